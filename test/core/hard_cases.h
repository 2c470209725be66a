#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

namespace poinsot {

/** A motion that is hard on a method for a reason of its own. */
struct HardCase {
  std::string name;
  std::string hard;  ///< what is hard about it
  Eigen::Vector3d moments;
  Eigen::Vector3d omega;
  double step;  ///< [s], of either sign
  std::int64_t steps;
  Eigen::Quaterniond attitude = Eigen::Quaterniond(0.5, -0.1, 0.7, 0.5).normalized();
};

/** The list that every method meets: in the tests of core, and in doc/hard_cases.md. */
const std::vector<HardCase>& hardCases();

/** For 1e8 steps. */
std::vector<HardCase> longRuns();

}  // namespace poinsot
