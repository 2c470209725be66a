#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "poinsot/cost/cancelled.h"
#include "poinsot/scene/scene.h"

namespace poinsot::cost {

/**
 * Gives every body whose scene names an accuracy a method and a step (choice.h), by nominal costs: alike on every
 * machine and every time.
 * @param rate at which states will be asked for [Hz].
 * @return a sentence for each such body: what was chosen, the estimated and the verified error, and the cost.
 * @param cancel see choose().
 * Throws Cancelled, or scene::Error, with the place of the accuracy, where it is out of reach.
 */
std::vector<std::string> resolveAccuracies(scene::Scene& scene, double rate,
                                           const std::atomic<bool>& cancel = kNeverCancelled);

}  // namespace poinsot::cost
