#pragma once

#include <string>

#include "poinsot/cost/cost_breakdown.h"
#include "poinsot/scene/scene.h"

namespace poinsot::tools {

/** A body's breakdown for people: method, why, a row for each part, and how the sum compares with a run. */
std::string costBreakdownText(const scene::Body& body, const std::string& why, const cost::CostBreakdown& breakdown);

/** The header of costBreakdownRows(), with its line end. */
std::string ledgerHeader();

/** The same as CSV: a row for each part and one, `total`, for all together; 9 significant digits. */
std::string costBreakdownRows(const scene::Body& body, const cost::CostBreakdown& breakdown);

}  // namespace poinsot::tools
