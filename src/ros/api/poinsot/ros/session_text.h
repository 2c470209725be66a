#pragma once

#include <string>
#include <vector>

#include "poinsot/session/request.h"
#include "poinsot/session/status.h"

/** What a session does and refuses, in words. */
namespace poinsot::node {

/** "method rk4 of wing and seek"; empty for none. Once each. */
std::string textOf(const std::vector<session::Request>& requests);

std::string textOf(const session::Refusal& refusal);

/** "on the separatrix"; "under torque" where there is no free motion. */
std::string regimeText(const session::BodyStatus& body);

}  // namespace poinsot::node
