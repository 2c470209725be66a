#pragma once

#include <string>

namespace poinsot {

/** A number as messages show it, whatever the locale. Of 17 significant digits, no two doubles are shown alike. */
std::string numberText(double value, int digits = 6);

}  // namespace poinsot
