#pragma once

#include <map>
#include <string>

#include "reference_rows.h"

namespace poinsot {

/** How far a state is from the truth of a row, reckoned in long double. */
struct RowErrors {
  double attitude;  ///< angle of the rotation between the two [rad], whatever lengths and signs
  double omega;     ///< |ΔΩ|/|Ω|; 0 where both are zero
  double norm;      ///< ||q| − 1|
};
RowErrors errorsOf(const ReferenceRow& row, const Eigen::Quaterniond& attitude, const Eigen::Vector3d& omega);

/** What the closed form is held to, whatever the row's conditioning. */
constexpr double kAttitudeTolerance = 2e-15;  // rad
constexpr double kNormTolerance = 1e-15;

/** 2e-15 of |Ω|; where Ω itself is a denormal also their spacing, below which no double can come. */
double omegaTolerance(const ReferenceRow& row);

/** Names the row and what is beyond its tolerance, NaN too; empty when all is well. */
std::string complaint(const ReferenceRow& row, const RowErrors& errors);

/** Judges states of many rows; keeps the worst ratio error/tolerance of each kind of row. */
class RowJudge {
 public:
  /** Complaints become failures of the test that runs; `how` says in them how the state was got. */
  void judge(const ReferenceRow& row, const Eigen::Quaterniond& attitude, const Eigen::Vector3d& omega,
             const std::string& how);

  /** A line for each kind, the note up to its first semicolon, and one for all. */
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
