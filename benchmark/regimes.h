#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace poinsot::benchmarks {

/** A free body at t = 0, principal axes. */
struct Start {
  Eigen::Vector3d moments;  ///< kg·m²
  Eigen::Quaterniond attitude;
  Eigen::Vector3d omega;  ///< rad/s
};

/** A kind of motion that may have a cost of its own. Its starts are the same in every run. */
struct Regime {
  std::string name;
  std::vector<Start> starts;  ///< the first stands for the regime where one body is enough
  std::vector<double> times;  ///< s, of either sign, in no order
};

/** All regimes; the first is "general". */
const std::vector<Regime>& regimes();

/** The regime of that name; it must exist. */
const Regime& regime(const std::string& name);

}  // namespace poinsot::benchmarks
