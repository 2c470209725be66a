#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "more_columns.h"
#include "output_file.h"
#include "poinsot/core/motion.h"
#include "poinsot/scene/scene.h"
#include "sample_times.h"
#include "worst_errors.h"

namespace poinsot::tools {

/**
 * Writes a scene's motion as CSV: body,t,qw,qx,qy,qz,O1,O2,O3,bx,by,bz and more, 17 significant digits, a row for each
 * body and time. Attitude body → world, of either sign, continuous in t; Ω in body axes [rad/s]; position in world axes
 * [m].
 *
 * Bodies are written one after the other, so that a scene of ten thousand needs the memory of one, which stays in the
 * processor's caches. Returns a sentence on the worst errors of each free body that a stepper moves. Throws
 * OutputError, and std::runtime_error where a body has no state.
 * @param done is called with the number of rows just written.
 */
std::vector<std::string> writeStateTable(const scene::Scene& scene, const SampleTimes& times,
                                         const MoreColumns& columns, TextSink& out,
                                         const std::function<void(std::int64_t)>& done);

/** Returns whether a run has errors to report: that of a free body under a stepper. */
bool isJudged(const Motion& motion);

/** Returns the sentence on the worst errors of a run. */
std::string worstErrorsText(const std::string& body, const Motion& motion, const WorstErrors& worst);

}  // namespace poinsot::tools
