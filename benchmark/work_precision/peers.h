#pragma once

#include "contestant.h"

namespace poinsot::work_precision {

/** Other people's solvers, of the packages that were installed when this was built. */
void addPeers(Contestants& to);

}  // namespace poinsot::work_precision
