#pragma once

#include <Eigen/Core>
#include <string>

/** Values as text with 17 significant digits, from which they can be read back. */
namespace poinsot::effects {

/** Returns the value as by "%.17g", whatever the locale. */
std::string text(double value);

/** Returns "[x, y, z]". */
std::string text(const Eigen::Vector3d& v);

}  // namespace poinsot::effects
