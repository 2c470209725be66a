#pragma once

#include <string>
#include <vector>

#include "poinsot/cost/method_costs.h"
#include "poinsot/scene/scene.h"

namespace poinsot::cost {

/**
 * Gives every body whose scene names an accuracy a method and a step (choice.h), by the costs of this machine.
 * @param rate at which states will be asked for [Hz].
 * @return a sentence for each such body: what was chosen, the estimated and the verified error, and the cost.
 * Throws scene::Error, with the place of the accuracy, where it is out of reach.
 */
std::vector<std::string> settleMethods(scene::Scene& scene, double rate);

/** The same by given costs: with nominalCosts() a scene is settled alike everywhere and every time. */
std::vector<std::string> settleMethods(scene::Scene& scene, double rate, const MethodCosts& costs);

}  // namespace poinsot::cost
