#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace poinsot {

/** A row of test/data/public.csv: a free body's start, and the truth at t (25 digits there, doubles here). */
struct ReferenceRow {
  std::string id;
  Eigen::Vector3d moments;        ///< kg·m²
  Eigen::Quaterniond attitude_0;  ///< as given: about unit, not normalised
  Eigen::Vector3d omega_0;        ///< rad/s, body axes
  double t;                       ///< s
  Eigen::Quaterniond attitude;
  Eigen::Vector3d omega;
  double cond_rad;    ///< attitude change when one input changes by 2⁻⁵³
  double cond_omega;  ///< the same of Ω, relative
};

/** All rows; inputs from the hexadecimal columns. Throws std::runtime_error for a file that is not as expected. */
std::vector<ReferenceRow> readReferenceRows(const std::string& path);

}  // namespace poinsot
