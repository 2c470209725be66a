#pragma once

#include <cstdint>
#include <functional>

#include "output_file.h"
#include "poinsot/scene/scene.h"
#include "sample_times.h"

namespace poinsot::tools {

/**
 * CSV of a scene: body,t,qw,qx,qy,qz,O1,O2,O3,bx,by,bz, 17 significant digits, a row for each body and time. Attitude
 * body → world, of either sign, continuous in t; Ω in body axes [rad/s]; position in world axes [m].
 *
 * Body after body, so that a scene of ten thousand needs the memory of one and each stays in the processor's caches.
 * Throws OutputError, and std::runtime_error where a body has no state.
 * @param done is told how many more rows there are.
 */
void writeStateTable(const scene::Scene& scene, const SampleTimes& times, TextSink& out,
                     const std::function<void(std::int64_t)>& done);

}  // namespace poinsot::tools
