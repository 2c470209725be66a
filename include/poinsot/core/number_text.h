#pragma once

#include <string>

namespace poinsot {

/** Returns a number as by "%.*g", whatever the locale. With 17 significant digits, no two doubles look alike. */
std::string numberText(double value, int digits = 6);

}  // namespace poinsot
