#pragma once

namespace poinsot {

/** π, to the nearest double. */
constexpr double kPi = 3.14159265358979323846;

}  // namespace poinsot
