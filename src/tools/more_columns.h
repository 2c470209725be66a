#pragma once

#include <string>

namespace poinsot::tools {

/** Columns of a table of states besides the state. */
struct MoreColumns {
  bool energy = false;  ///< E,Lx,Ly,Lz: kinetic energy [J], L in world axes [kg·m²/s]
  /** attitude_error,energy_drift: from the closed form [rad], nan where there is none; relative to t = 0 */
  bool errors = false;
};

/** What an option that names columns takes, for its description. */
constexpr const char* kColumnsHelp =
    "What the CSV holds: states, and energy (E,Lx,Ly,Lz) and errors (attitude_error,energy_drift) if named";

/** Returns the columns named by "states", "energy" and "errors", separated by commas. Throws BadUse. */
MoreColumns readColumns(const std::string& text);

/** Returns the names of the columns, as they follow those of the state in a header: ",E,Lx,Ly,Lz". */
std::string headerOf(const MoreColumns& columns);

}  // namespace poinsot::tools
