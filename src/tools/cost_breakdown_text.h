#pragma once

#include <string>

#include "poinsot/cost/cost_breakdown.h"
#include "poinsot/scene/scene.h"

namespace poinsot::tools {

/** Returns a body's breakdown as text: method, why, a row for each part, and how the sum compares with a run. */
std::string costBreakdownText(const scene::Body& body, const std::string& why, const cost::CostBreakdown& breakdown);

/** Returns the header of costBreakdownRows(), with its line end. */
std::string costBreakdownHeader();

/** Returns the breakdown as CSV: a row for each part and one, `total`, for their sum; 9 significant digits. */
std::string costBreakdownRows(const scene::Body& body, const cost::CostBreakdown& breakdown);

}  // namespace poinsot::tools
