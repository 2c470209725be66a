#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace poinsot {

/** A row of public.csv or closed_form_rows.csv in test/data: a free body's start, and the truth at t. */
struct ReferenceRow {
  std::string id;
  std::string note;
  Eigen::Vector3d moments;        ///< kg·m²
  Eigen::Quaterniond attitude_0;  ///< as given: about unit, not normalised
  Eigen::Vector3d omega_0;        ///< rad/s, body axes
  double t;                       ///< s
  Eigen::Quaterniond attitude;
  Eigen::Vector3d omega;
  Eigen::Quaternion<long double> exact_attitude;  ///< the 25 digits of the file, for errors near 1e-16
  Eigen::Matrix<long double, 3, 1> exact_omega;   ///< likewise
  double cond_rad;    ///< attitude change when one input changes by 2⁻⁵³; NaN where the file has none
  double cond_omega;  ///< the same of Ω, relative
};

/** All rows; inputs from the hexadecimal columns. Throws std::runtime_error for a file that is not as expected. */
std::vector<ReferenceRow> readReferenceRows(const std::string& path);

}  // namespace poinsot
