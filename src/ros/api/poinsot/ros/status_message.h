#pragma once

#include <string>
#include <vector>

#include "poinsot/NodeStatus.h"
#include "poinsot/session/session.h"

namespace poinsot::node {

/**
 * Returns the message of `~status`: what a session is doing.
 * @param rate of the ticks [Hz]
 * @param waiting_for_clock whether no tick comes because somebody else's /clock stands still
 * @param scenes names of scenes that can be loaded
 */
NodeStatus statusMessage(const session::Session& session, double rate, bool waiting_for_clock,
                         const std::vector<std::string>& scenes);

}  // namespace poinsot::node
