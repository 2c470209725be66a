#pragma once

#include <string>

// Unlike those of <cctype>, these do not depend on the locale.
namespace poinsot::scene {

inline bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/** Returns the small letter of a capital, and any other character as it is. */
inline char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline bool isLetter(char c) {
  return lower(c) >= 'a' && lower(c) <= 'z';
}

inline std::string lower(std::string text) {
  for (char& c : text) c = lower(c);
  return text;
}

}  // namespace poinsot::scene
