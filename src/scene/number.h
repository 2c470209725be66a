#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "fields.h"
#include "place.h"
#include "poinsot/core/number_text.h"

namespace poinsot::scene {

/** What a number stands for: this decides which values are allowed, and how a message says so. */
struct Quantity {
  enum class Range { positive, not_negative, any };
  Range range;       ///< besides being finite
  const char* unit;  ///< empty for a pure number
};

namespace quantity {
constexpr Quantity kRate{Quantity::Range::positive, "Hz"};
constexpr Quantity kInertia{Quantity::Range::positive, "kg·m²"};
constexpr Quantity kInertiaEntry{Quantity::Range::any, "kg·m²"};
constexpr Quantity kMass{Quantity::Range::positive, "kg"};
constexpr Quantity kLength{Quantity::Range::positive, "m"};
constexpr Quantity kPosition{Quantity::Range::any, "m"};
constexpr Quantity kVelocity{Quantity::Range::any, "m/s"};
constexpr Quantity kAcceleration{Quantity::Range::any, "m/s²"};
constexpr Quantity kAngularVelocity{Quantity::Range::any, "rad/s"};
constexpr Quantity kAngle{Quantity::Range::any, "rad"};
constexpr Quantity kAngleError{Quantity::Range::positive, "rad"};
constexpr Quantity kStep{Quantity::Range::positive, "s"};
constexpr Quantity kTime{Quantity::Range::any, "s"};
constexpr Quantity kTorque{Quantity::Range::any, "N·m"};
constexpr Quantity kDamping{Quantity::Range::not_negative, "N·m·s"};
constexpr Quantity kOrbitRate{Quantity::Range::positive, "rad/s"};
constexpr Quantity kDirection{Quantity::Range::any, ""};
constexpr Quantity kScale{Quantity::Range::positive, ""};
constexpr Quantity kDuration{Quantity::Range::positive, "s"};
constexpr Quantity kQuaternionEntry{Quantity::Range::any, ""};
}  // namespace quantity

/** What an angular velocity must be besides a list of three numbers. */
constexpr const char* kExpectedSpin =
    "3 finite numbers (rad/s), all zero or such that energy and squared momentum are held in full precision";

/** "a positive finite number (kg)". */
std::string expectedNumber(const Quantity& quantity);

/** "a list of 3 finite numbers (m)". */
std::string expectedNumbers(std::size_t count, const Quantity& quantity);

/** "1, 2, 3.5", of 15 significant digits. */
std::string listed(const Eigen::Vector3d& v);

/**
 * Returns a number of the one grammar for all numbers, quoted or not, whatever the locale:
 * [+-]?(digits[.digits]|.digits)([eE][+-]?digits)?
 * Refuses whatever YAML readers understand differently: 0x10, 010, 1_000, 1:30, true, and .inf and .nan. A number
 * beyond the largest double is refused; one below the smallest becomes what strtod gives.
 */
double readNumber(const Place& place, const Quantity& quantity);

/** Returns the three numbers of a list. */
Eigen::Vector3d readVector(const Place& place, const Quantity& quantity);

/** Returns a unit quaternion, from a list of four numbers w x y z, not all zero, of any length. */
Eigen::Quaterniond readRotation(const Place& place);

/** Returns the number under a key that must be there. */
double requireNumber(const Fields& fields, const char* key, const Quantity& quantity);

/** Returns the three numbers of the list under a key that must be there. */
Eigen::Vector3d requireVector(const Fields& fields, const char* key, const Quantity& quantity);

}  // namespace poinsot::scene
