#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "place.h"

namespace poinsot::scene {

/** What a number stands for: it decides which values are allowed, and how a message says so. */
struct Quantity {
  bool positive;     ///< else any finite value
  const char* unit;  ///< empty for a pure number
};

namespace quantity {
constexpr Quantity kRate{true, "Hz"};
constexpr Quantity kInertia{true, "kg·m²"};
constexpr Quantity kInertiaEntry{false, "kg·m²"};
constexpr Quantity kMass{true, "kg"};
constexpr Quantity kLength{true, "m"};
constexpr Quantity kPosition{false, "m"};
constexpr Quantity kVelocity{false, "m/s"};
constexpr Quantity kAcceleration{false, "m/s²"};
constexpr Quantity kAngularVelocity{false, "rad/s"};
constexpr Quantity kAngle{false, "rad"};
constexpr Quantity kAngleError{true, "rad"};
constexpr Quantity kStep{true, "s"};
constexpr Quantity kDuration{true, "s"};
constexpr Quantity kQuaternionEntry{false, ""};
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

/** As a message shows a number. */
std::string shownNumber(double value);

}  // namespace poinsot::scene
