#pragma once

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

}  // namespace poinsot::audit
