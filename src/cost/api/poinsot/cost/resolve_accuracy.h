#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "poinsot/cost/cancelled.h"
#include "poinsot/scene/scene.h"

namespace poinsot::cost {

/**
 * Gives every body with an accuracy a method and a step (choice.h), by nominal costs, so that the choice is the same on
 * every machine. Returns a sentence for each such body: the choice, its estimated and verified error, and its cost.
 * Throws Cancelled, or scene::Error with the place of the accuracy where that is out of reach.
 * @param rate at which states will be asked for [Hz].
 * @param cancel see choose().
 */
std::vector<std::string> resolveAccuracies(scene::Scene& scene, double rate,
                                           const std::atomic<bool>& cancel = kNeverCancelled);

}  // namespace poinsot::cost
