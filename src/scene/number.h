#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "place.h"
#include "poinsot/core/number_text.h"

namespace poinsot::scene {

/** What a number stands for: it decides which values are allowed, and how a message says so. */
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

/** "a positive finite number (kg)". */
std::string allowedNumber(const Quantity& quantity);

/** "a list of 3 finite numbers (m)". */
std::string allowedNumbers(std::size_t count, const Quantity& quantity);

/**
 * One grammar for all numbers, quoted or not, whatever the locale: [+-]?(digits[.digits]|.digits)([eE][+-]?digits)?
 * Everything that YAML readers understand differently is refused: 0x10, 010, 1_000, 1:30, true, and .inf and .nan.
 * Beyond the largest double: refused; below the smallest: what strtod gives.
 */
double readNumber(const Place& place, const Quantity& quantity);

/** A list of exactly `count` numbers. */
std::vector<double> readNumbers(const Place& place, std::size_t count, const Quantity& quantity);

Eigen::Vector3d readVector(const Place& place, const Quantity& quantity);

/** Four numbers w x y z, not all zero, of any length; normalised. */
Eigen::Quaterniond readRotation(const Place& place);

}  // namespace poinsot::scene
