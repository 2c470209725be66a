#pragma once

#include <string>

#include "poinsot/cost/ledger.h"
#include "poinsot/scene/scene.h"

namespace poinsot::tools {

/** A body's ledger for people: method, why, a row for each part, and how the sum compares with a run. */
std::string ledgerText(const scene::Body& body, const std::string& why, const cost::Ledger& ledger);

/** The header of ledgerRows(), with its line end. */
std::string ledgerHeader();

/** The same as CSV: a row for each part and one, `total`, for all together; 9 significant digits. */
std::string ledgerRows(const scene::Body& body, const cost::Ledger& ledger);

}  // namespace poinsot::tools
