#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "output_file.h"
#include "poinsot/core/motion.h"
#include "poinsot/scene/scene.h"
#include "sample_times.h"
#include "worst_errors.h"

namespace poinsot::tools {

/** Columns that a table of states may have besides the state. */
struct MoreColumns {
  bool energy = false;  ///< E,Lx,Ly,Lz: kinetic energy [J], L in world axes [kg·m²/s]
  bool errors =
      false;  ///< attitude_error,energy_drift: from the closed form [rad], nan under torques; relative to t = 0
};

/** Reads "states", "energy" and "errors", separated by commas. Throws std::invalid_argument, saying what is expected.
 */
MoreColumns readColumns(const std::string& text);

/**
 * CSV of a scene: body,t,qw,qx,qy,qz,O1,O2,O3,bx,by,bz and more, 17 significant digits, a row for each body and time.
 * Attitude body → world, of either sign, continuous in t; Ω in body axes [rad/s]; position in world axes [m].
 *
 * Body after body, so that a scene of ten thousand needs the memory of one and each stays in the processor's caches.
 * Throws OutputError, and std::runtime_error where a body has no state.
 * @param done is told how many more rows there are.
 * @return a sentence on the worst errors of each free body that a stepper moves.
 */
std::vector<std::string> writeStateTable(const scene::Scene& scene, const SampleTimes& times,
                                         const MoreColumns& columns, TextSink& out,
                                         const std::function<void(std::int64_t)>& done);

/** Whether a run is judged: a free body's, by a stepper. */
bool isJudged(const Motion& motion);

/** The sentence on a run. */
std::string worstErrorsText(const std::string& body, const Motion& motion, const WorstErrors& worst);

}  // namespace poinsot::tools
