#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace poinsot::tools {

/** The greatest errors of a run by a stepper, and when they occurred. */
class WorstErrors {
 public:
  /**
   * @param attitude_error against the closed form [rad]; NaN where there is none, which is ignored
   * @param energy_drift relative, since the start
   */
  void add(double t, double attitude_error, double energy_drift) {
    if (std::abs(attitude_error) > std::abs(attitude_.value)) attitude_ = {attitude_error, t};
    if (std::abs(energy_drift) > std::abs(energy_.value)) energy_ = {energy_drift, t};
  }

  /** Returns whether the run is worth a warning, under the same limits as in the node's diagnostics. */
  bool lost() const { return attitude_.value > kLost || std::abs(energy_.value) > kLost; }

  /** "at most 1.7 rad from the closed form (t = 50000 s), energy drift at most 0.0012 (t = 1000 s)" */
  std::string text() const {
    char out[160];
    std::snprintf(out, sizeof out,
                  "at most %.3g rad from the closed form (t = %.9g s), energy drift at most %.3g (t = %.9g s)",
                  attitude_.value, attitude_.t, energy_.value, energy_.t);
    return out;
  }

 private:
  static constexpr double kLost = 0.1;  // rad, or relative
  struct Worst {
    double value = 0, t = 0;
  };
  Worst attitude_, energy_;
};

}  // namespace poinsot::tools
