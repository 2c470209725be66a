#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "poinsot/core/rotation_state.h"
#include "poinsot/core/torques.h"
#include "poinsot/core/work.h"

namespace poinsot {

/** What moves under torques; principal axes. */
struct TorquedState {
  RotationState rotation;                                ///< of the body
  Eigen::Vector3d slug_omega = Eigen::Vector3d::Zero();  ///< σ of a slug inside, in the body's principal axes [rad/s]
  Eigen::Vector3d slug_rest = Eigen::Vector3d::Zero();   ///< what compensated summation has left over of σ [rad/s]
};

/** A one-step method for a body under torques, bound to one. */
class TorqueStepper {
 public:
  /** @param torques that act on the body; its moments are theirs. */
  explicit TorqueStepper(Torques torques) : torques_(std::move(torques)) {}
  virtual ~TorqueStepper() = default;

  /**
   * From t to t + h [s], h of either sign: in one step, or in several that end where a torque switches in between.
   * Allocates nothing. The state is not finite afterwards where it left the range of doubles. May throw NoConvergence;
   * the state is then as it was.
   */
  Work advance(TorquedState& state, double t, double h) const;

  /** What acts on the body. */
  const Torques& torques() const { return torques_; }

 protected:
  /** One step; `constant` holds for all of it. */
  virtual Work step(TorquedState& state, double t, double h, const Torques::Constant& constant) const = 0;

 private:
  Torques torques_;
};

/** One row of the table of methods that take torques. */
struct TorqueMethod {
  const char* name;    ///< by which scenes and programs ask for it
  int order;           ///< the global error of a motion falls with h to this power
  bool takes_damping;  ///< torques that depend on Ω; others only those that depend on t and R
  bool cuts_steps;     ///< takes a step that is too long for it in parts
  /** Binds it to a body and its torques. */
  std::unique_ptr<TorqueStepper> (*make)(const Torques& torques);
};

/** taylor8 … taylor24, aba84, buss2, rk4. */
const std::vector<TorqueMethod>& torqueMethods();

/** The method of that name, or nullptr. */
const TorqueMethod* findTorqueMethod(const std::string& name);

/** "taylor8, …" for messages. */
std::string torqueMethodNames();

/** Why the method does not take these torques; empty when it does. */
std::string objectionTo(const TorqueMethod& method, const Torques& torques);

}  // namespace poinsot
