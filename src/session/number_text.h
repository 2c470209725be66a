#pragma once

#include <cstdio>
#include <string>

namespace poinsot::session {

/** A number in messages: six digits at most. */
inline std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

}  // namespace poinsot::session
