#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace poinsot {

/** A row of torque.csv or torque_rows.csv in test/data: a body under effects, and the truth at t. */
struct TorqueRow {
  std::string id;
  std::string note;
  std::string body;                         ///< as in a scene, without name and method: `inertia: …, effects: […]`
  double t;                                 ///< s
  Eigen::Quaternion<long double> attitude;  ///< as the scene's axes have it; 25 digits of the file
  Eigen::Matrix<long double, 3, 1> omega;   ///< rad/s
  double cond_rad, cond_omega;              ///< what a change of an input by 2⁻⁵³ makes; Ω relative

  /** How far a state is from it: [rad], and |ΔΩ|/|Ω|. */
  double attitudeError(const Eigen::Quaterniond& q) const;
  double omegaError(const Eigen::Vector3d& w) const;

  /** A scene of one body, "body". @param method its keys, such as `accuracy: 1e-9, horizon: 3`. */
  std::string scene(const std::string& method) const;
};

/** All rows of torque.csv, whose inputs are columns. Throws std::runtime_error for a file that is not as expected. */
std::vector<TorqueRow> readTorqueColumns(const std::string& path);

/** All rows of torque_rows.csv, whose inputs are written as a scene. */
std::vector<TorqueRow> readTorqueScenes(const std::string& path);

}  // namespace poinsot
