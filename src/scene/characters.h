#pragma once

namespace poinsot::scene {

// Unlike std::isdigit, this does not depend on the locale.
inline bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace poinsot::scene
