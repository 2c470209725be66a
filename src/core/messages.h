#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>

namespace poinsot {

[[noreturn]] inline void refuse(const std::string& what) {
  throw std::invalid_argument(what);
}

/** A number in messages, with all the digits that tell it from its neighbours. */
inline std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

}  // namespace poinsot
