#pragma once

#include <functional>
#include <string>
#include <vector>

#include "poinsot/audit/audit.h"
#include "poinsot/audit/recording.h"
#include "poinsot/audit/report.h"
#include "segment.h"

/** The questions, a family a function; each appends its checks for one body. doc/audit.md says where bounds come from.
 */
namespace poinsot::audit {

/** What every check sees. */
struct Evidence {
  const Body& body;
  const std::vector<Segment>& segments;  ///< of the body; none where it has no description
  const Transforms& transforms;
  const Options& options;
};

/** Descriptions: a tensor that is one, its principal moments and axes; effects that can be read. */
void judgeDescription(const Evidence& evidence, std::vector<Check>& checks);

/** All numbers finite; quaternions unit; stamps and segments never decrease. */
void judgeForm(const Evidence& evidence, std::vector<Check>& checks);

/** Inside one message: omega_world = RΩ, momentum_world = RMΩ, kinetic_energy = ½ΩᵀMΩ. */
void judgeState(const Evidence& evidence, std::vector<Check>& checks);

/** tf = state = odometry at equal stamps. */
void judgeAgreement(const Evidence& evidence, std::vector<Check>& checks);

/** From message to message, and over many: time, dR/dstamp, Euler's equations, translation. */
void judgeMotion(const Evidence& evidence, std::vector<Check>& checks);

/** What the motion conserves, and what the messages say of drift and error themselves. */
void judgeConservation(const Evidence& evidence, std::vector<Check>& checks);

/** Poinsot's construction as drawn. */
void judgeMarkers(const Evidence& evidence, std::vector<Check>& checks);

// What only bodies under torques are asked.

/** From message to message: what the torques add to L and E, and how the slug turns. */
class TorqueJudges {
 public:
  explicit TorqueJudges(const std::string& key)
      : momentum_("dL/dt = torque", key), energy_("dE/dt = power", key), slug_("slug's equation", key) {}

  void judge(const Segment& segment, const State& a, const State& b, const Followed& followed);

  /** Appends those that have something to say of this body. */
  void addTo(std::vector<Judge*>& out, const Evidence& evidence);

 private:
  Judge momentum_, energy_, slug_;
  bool at_rest_ = false;
};

/** Something of the true motion that never changes. */
struct Constant {
  const char* name;
  std::string words;  ///< "E drifts"
  std::function<Eigen::Vector3d(const State&)> value;
  double scale;                                 ///< what its size is compared with
  std::function<double(const State&)> allowed;  ///< what it may be off by in a state, relative to the scale
};

/** What the effects that act on a body leave constant. */
std::vector<Constant> constantsUnderTorques(const Segment& segment);

/** Dampings and slugs take energy out, at every moment: E, with the slug's ½Jσ². */
void judgeFall(const Segment& segment, double ceiling, Judge& judge);

/** A slug starts with the body; of recordings that show t = 0. */
void judgeSlugsStart(const Evidence& evidence, std::vector<Check>& checks);

}  // namespace poinsot::audit
