#pragma once

#include "poinsot/cost/method_costs.h"

namespace poinsot::cost {

/**
 * What the methods once cost on one machine (poinsot_node --measure-costs), rounded. Only the proportions matter, which
 * differ little between machines. For programs that must choose alike everywhere and every time: measured costs differ
 * a little from run to run, and so would the choice.
 */
const MethodCosts& nominalCosts();

}  // namespace poinsot::cost
