#pragma once

#include <string>
#include <vector>

#include "poinsot/session/request.h"
#include "poinsot/session/status.h"

/** Words for what a session does and refuses. */
namespace poinsot::node {

/** Returns words such as "method rk4 of wing and seek", each once; empty for no request. */
std::string textOf(const std::vector<session::Request>& requests);

/** Returns what was refused, what was expected and what was got. */
std::string textOf(const session::Refusal& refusal);

/** Returns words such as "on the separatrix"; "under torque" where there is no free motion. */
std::string regimeText(const session::BodyStatus& body);

}  // namespace poinsot::node
