#include "bodies.h"

namespace poinsot::work_precision {

const std::vector<Problem>& bodies() {
  static const Eigen::Quaterniond turned = Eigen::Quaterniond(0.8, 0.36, -0.48, 0);
  static const std::vector<Problem> all = {
      // Spun about the axis of intermediate moment: a flip every 20 s, and every 2 s.
      {"dzhanibekov_slow", {1, 2, 3}, turned, {0.01, 1, 0.01}},
      {"dzhanibekov_fast", {1, 2, 3}, turned, {0.1, 10, 0.1}},
      // A T-handle of thin rods, moments as 0.2 : 1 : 1.1, spun about the middle one.
      {"t_handle", {1.0, 0.2, 1.1}, turned, {2, 0.02, 0.05}},
      {"near_symmetric", {1, 1.001, 2}, turned, {0.3, 0.4, 1}},
      // Off the separatrix by a thousandth; with these moments, the separatrix is Omega_1 = Omega_3.
      {"near_separatrix", {2, 5, 6}, turned, {0.5, 0.3, 0.5005}},
      {"extreme_ratio", {1, 100, 100.5}, turned, {0.6, 0.5, 0.7}},
  };
  return all;
}

}  // namespace poinsot::work_precision
