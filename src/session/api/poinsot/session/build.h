#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "poinsot/scene/scene.h"
#include "poinsot/session/companion.h"
#include "poinsot/session/job.h"

/** What the background job does, on data of its own. */
namespace poinsot::session {

/** Applies the requests to the draft in order; a refused one changes nothing. Throws cost::Cancelled. */
Prepared prepare(Draft draft, const std::vector<Asked>& asked, const ReadScene& read,
                 const std::atomic<bool>& cancelled);

/** Which bodies to build, and how. */
struct BuildOrder {
  scene::Scene scene;                 ///< as it is to be; accuracies are still to be met by a method and a step
  std::vector<std::size_t> bodies;    ///< which of the scene's bodies
  double time = 0;                    ///< to which they are to be stepped [s]
  double rate = scene::kDefaultRate;  ///< of the ticks [Hz]
  MakeCompanion companion;
};

/** Returns the order for all bodies of a scene, at t = 0. */
BuildOrder wholeScene(scene::Scene scene, double rate, MakeCompanion companion);

/**
 * Builds bodies. Throws cost::Cancelled, scene::Error where an accuracy is out of reach, std::runtime_error where there
 * are too many steps to `time`, or no state there.
 */
Built build(BuildOrder order, const std::atomic<bool>& cancelled);

/** Steps what was built to another time [s]. Throws as build(). */
void advance(Built& built, double time, const std::atomic<bool>& cancelled);

/** Steps motions to a time [s]. Throws cost::Cancelled, or std::range_error where a motion has no state there. */
Advanced advanced(std::vector<Motion> motions, double time, const std::atomic<bool>& cancelled);

}  // namespace poinsot::session
