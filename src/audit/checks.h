#pragma once

#include <functional>
#include <string>
#include <vector>

#include "poinsot/audit/audit.h"
#include "poinsot/audit/recording.h"
#include "poinsot/audit/report.h"
#include "segment.h"

/** The checks, one function for each family. Each appends its checks of one body; doc/audit.md explains the bounds. */
namespace poinsot::audit {

/** What all checks are given. */
struct Evidence {
  const Body& body;
  const std::vector<Segment>& segments;  ///< of the body; none where it has no description
  const Transforms& transforms;
  const Options& options;
};

/** Descriptions: a symmetric positive tensor, its principal moments and axes, effects that can be read. */
void judgeDescription(const Evidence& evidence, std::vector<Check>& checks);

/** All numbers finite; quaternions unit; stamps and segments never decrease. */
void judgeForm(const Evidence& evidence, std::vector<Check>& checks);

/** Inside one message: omega_world = RΩ, momentum_world = RMΩ, kinetic_energy = ½ΩᵀMΩ. */
void judgeState(const Evidence& evidence, std::vector<Check>& checks);

/** tf = state = odometry at equal stamps. */
void judgeAgreement(const Evidence& evidence, std::vector<Check>& checks);

/** From message to message, and over many: time, dR/dstamp, Euler's equations, translation. */
void judgeMotion(const Evidence& evidence, std::vector<Check>& checks);

/** What the motion conserves, and the messages' own figures for drift and error. */
void judgeConservation(const Evidence& evidence, std::vector<Check>& checks);

/** The markers of Poinsot's construction. */
void judgeMarkers(const Evidence& evidence, std::vector<Check>& checks);

/** Judges that nothing but the body itself is drawn of it. */
void judgeNoPictures(const Body& body, std::vector<Check>& checks);

// For bodies under torques only.

/** From message to message: what the torques add to L and E, and the slug's equation. */
class TorqueJudges {
 public:
  explicit TorqueJudges(const std::string& key)
      : momentum_("dL/dt = torque", key), energy_("dE/dt = power", key), slug_("slug's equation", key) {}

  void judge(const Segment& segment, const State& a, const State& b, const Followed& followed);

  /** Appends the judges that apply to this body. */
  void addTo(std::vector<Judge*>& out, const Evidence& evidence);

 private:
  Judge momentum_, energy_, slug_;
  bool at_rest_ = false;
};

/** A constant of the true motion. */
struct Constant {
  const char* name;
  std::string words;  ///< "E drifts"
  std::function<Eigen::Vector3d(const State&)> value;
  double scale;                                 ///< to which changes are relative
  std::function<double(const State&)> allowed;  ///< its error that is allowed in a state, relative to the scale
};

/** Returns what the effects on a body leave constant. */
std::vector<Constant> constantsUnderTorques(const Segment& segment);

/** Checks that E with the slug's ½Jσ² never rises where only dampings and a slug act. */
void judgeFall(const Segment& segment, double ceiling, Judge& judge);

/** Checks in states at t = 0 that the slug starts at rest in the body. */
void judgeSlugsStart(const Evidence& evidence, std::vector<Check>& checks);

}  // namespace poinsot::audit
