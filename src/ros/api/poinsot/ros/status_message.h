#pragma once

#include <string>
#include <vector>

#include "poinsot/NodeStatus.h"
#include "poinsot/session/session.h"

namespace poinsot::node {

/** @param rate of the ticks [Hz]; scenes: names that can be loaded. */
NodeStatus statusMessage(const session::Session& session, double rate, const std::vector<std::string>& scenes);

}  // namespace poinsot::node
