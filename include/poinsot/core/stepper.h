#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "poinsot/core/rotation_state.h"
#include "poinsot/core/work.h"

namespace poinsot {

/** A one-step method for the free rigid body, bound to one body. */
class Stepper {
 public:
  virtual ~Stepper() = default;

  /**
   * Takes `count` steps. Allocates nothing; the one virtual call is a batch's, not a step's. Throws NoConvergence where
   * an implicit method finds no step; `state` is then as it was.
   * @param state in principal axes.
   * @param step [s], of either sign.
   * @param count ≥ 0.
   * @return the evaluations that it took.
   */
  virtual Work advance(RotationState& state, double step, std::int64_t count) const = 0;
};

/** One row of the table of methods. */
struct Method {
  const char* name;         ///< by which scenes and programs ask for it
  int order;                ///< the global error of a motion falls with h to this power
  bool conserves_momentum;  ///< L in world axes, to roundoff
  bool conserves_energy;    ///< E, to roundoff
  /** Binds it to a body. @param moments principal moments [kg·m²], valid. */
  std::unique_ptr<Stepper> (*make)(const Eigen::Vector3d& moments);
};

/** All methods that this version has, in the order in which they are listed to users. */
const std::vector<Method>& methods();

/** The method of that name, or nullptr. */
const Method* findMethod(const std::string& name);

/** "lie_euler, buss2, …" for messages. */
std::string methodNames();

}  // namespace poinsot
