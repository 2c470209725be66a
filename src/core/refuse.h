#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "poinsot/core/eigen_types.h"
#include "poinsot/core/number_text.h"

/** Refusals of arguments, all by std::invalid_argument. */
namespace poinsot {

[[noreturn]] inline void refuse(const std::string& message) {
  throw std::invalid_argument(message);
}

/** @param name of the value. @param unit of the value. */
inline void requirePositive(double value, const char* name, const char* unit) {
  if (value > 0 && std::isfinite(value)) return;
  refuse(std::string(name) + ": expected a positive finite number (" + unit + "), got " + numberText(value, 17));
}

/** @param omega Ω [rad/s]. */
inline void requireFinite(const Eigen::Vector3d& omega) {
  for (int i = 0; i < 3; ++i) {
    if (std::isfinite(omega[i])) continue;
    refuse("component " + std::to_string(i + 1) + " of the angular velocity: expected a finite number (rad/s), got " +
           numberText(omega[i], 17));
  }
}

/** Refuses a quaternion from which no attitude can be made. */
[[noreturn]] inline void refuseAttitude(const Quaternion& q) {
  refuse("attitude: expected a finite quaternion (w, x, y, z) other than zero, got [" + numberText(q.w(), 17) + ", " +
         numberText(q.x(), 17) + ", " + numberText(q.y(), 17) + ", " + numberText(q.z(), 17) + "]");
}

}  // namespace poinsot
