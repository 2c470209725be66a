#pragma once

#include <cstdio>
#include <string>

namespace poinsot::cost {

/** A number in messages; `format` is printf's. */
inline std::string shown(double value, const char* format = "%.3g") {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace poinsot::cost
