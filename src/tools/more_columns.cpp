#include "more_columns.h"

#include <sstream>

#include "bad_use.h"

namespace poinsot::tools {

MoreColumns readColumns(const std::string& text) {
  MoreColumns out;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    if (word == "energy") {
      out.energy = true;
    } else if (word == "errors") {
      out.errors = true;
    } else if (word != "states") {
      throw BadUse("--columns", "states, energy and errors, separated by commas", '"' + word + '"');
    }
  }
  return out;
}

std::string headerOf(const MoreColumns& columns) {
  return std::string(columns.energy ? ",E,Lx,Ly,Lz" : "") + (columns.errors ? ",attitude_error,energy_drift" : "");
}

}  // namespace poinsot::tools
