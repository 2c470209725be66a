#pragma once

#include <map>
#include <string>

#include "reference_rows.h"

namespace poinsot {

/** The errors of a state against a reference row, computed in long double. */
struct RowErrors {
  double attitude;  ///< angle of the rotation between the two [rad]; lengths and signs do not matter
  double omega;     ///< |ΔΩ|/|Ω|; 0 where both are zero
  double norm;      ///< ||q| − 1|
};
RowErrors errorsOf(const ReferenceRow& row, const Eigen::Quaterniond& attitude, const Eigen::Vector3d& omega);

/** Tolerances of the closed form, the same for every row's conditioning. */
constexpr double kAttitudeTolerance = 2e-15;  // rad
constexpr double kNormTolerance = 1e-15;

/** Returns 2e-15 of |Ω|, or the spacing of doubles where Ω is a denormal. */
double omegaTolerance(const ReferenceRow& row);

/** Returns the row and the errors that exceed their tolerance or are NaN; empty without any. */
std::string complaint(const ReferenceRow& row, const RowErrors& errors);

/** Judges states of many rows; keeps the worst ratio error/tolerance of each kind of row. */
class RowJudge {
 public:
  /** Fails the running test where there is a complaint. @param how the state was computed, for the message. */
  void judge(const ReferenceRow& row, const Eigen::Quaterniond& attitude, const Eigen::Vector3d& omega,
             const std::string& how);

  /** Prints a line for each kind (the note up to its first semicolon) and one for all rows. */
  void print(const std::string& title) const;

 private:
  struct Ratio {
    double value = -1;
    std::string id;
    void meet(double other, const std::string& other_id);
  };
  struct Worst {
    Ratio attitude, omega;
    int states = 0;
    void print(const std::string& kind) const;
  };

  std::map<std::string, Worst> kinds_;
  Worst all_;
};

}  // namespace poinsot
