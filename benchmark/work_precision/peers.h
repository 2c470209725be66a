#pragma once

#include "contestant.h"

namespace poinsot::work_precision {

/** Other people's solvers, those whose packages were there when this was built. */
void addPeers(Contestants& to);

}  // namespace poinsot::work_precision
