#pragma once

#include <rapidcheck.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <iosfwd>
#include <string>

#include "poinsot/core/closed_form.h"

/** Random free bodies for property tests, hard ones above all. Draw them within properties, with operator *. */
namespace poinsot {

/** A body at t = 0, principal axes. */
struct FreeBody {
  Eigen::Vector3d moments;  ///< kg·m²
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  Eigen::Vector3d omega;  ///< rad/s

  ClosedForm closedForm() const { return {moments, attitude, omega}; }
};

/** Decimal and, to run it again, hexadecimal. */
std::string shown(double value);
std::ostream& operator<<(std::ostream& out, const FreeBody& body);

namespace draw {

/** Integers from low to high, both included, equally likely; they shrink towards low. */
int integer(int low, int high);
double uniform(double low, double high);
double sign();

/** 10^x, x uniform between two. */
double powerOfTen(double low, double high);

/** One of several doubles, or bodies. */
template <class T>
T oneOf(std::initializer_list<T> choices) {
  return choices.begin()[integer(0, static_cast<int>(choices.size()) - 1)];
}

/** No component has more than 40 bits: products with small integers are exact. Not unit. */
Eigen::Quaterniond attitude();

Eigen::Vector3d direction();

/** Three in some order: of a real body, with ratios up to 1e12, two or three equal or nearly so, small integers. */
Eigen::Vector3d moments();

/**
 * Bodies of all kinds: any Ω, tiny and vanishing components, near the separatrix to 1e-17 of Ω, near an axis to
 * 1e-140. |Ω| is about 1.
 */
FreeBody body();

/** The same with |Ω| from 1e-100 to 1e100, and moments scaled by 1e-50 to 1e50. */
FreeBody bodyOfAnySize();

/** Exactly on the separatrix, not at rest on it. */
FreeBody bodyOnSeparatrix();

/** Like body(), in general motion: neither steady nor on the separatrix. */
FreeBody movingBody();

/** Of either sign, 1e-3 to `most` in units of 1/|Ω|. */
double time(const FreeBody& body, double most);

/** A multiple of 2^-20 units of time, 1/|Ω| rounded to a power of two: such times below 1e9 units add up exactly. */
double onGrid(const FreeBody& body, double t);

}  // namespace draw
}  // namespace poinsot
