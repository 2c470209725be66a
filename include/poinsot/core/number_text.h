#pragma once

#include <string>

namespace poinsot {

/** A number in messages, with so many significant digits at most; 17 tell it from all others. In no country's style. */
std::string numberText(double value, int digits = 6);

}  // namespace poinsot
