#include "row_judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>

namespace poinsot {
namespace {

using Vector3 = Eigen::Matrix<long double, 3, 1>;

constexpr double kOmegaTolerance = 2e-15;
constexpr double kDenormalBelow = 1e-290;

double norm(const Vector3& v) {
  return static_cast<double>(v.stableNorm());
}

}  // namespace

RowErrors errorsOf(const ReferenceRow& row, const Eigen::Quaterniond& attitude, const Eigen::Vector3d& omega) {
  const Eigen::Quaternion<long double> q = attitude.cast<long double>();
  const long double length = q.norm();
  const long double sine = (row.exact_attitude.conjugate() * q).vec().norm() / length / row.exact_attitude.norm();
  const Vector3 off = omega.cast<long double>() - row.exact_omega;
  const bool is_exact = off.isZero(0);
  return {static_cast<double>(2 * sine),  // the angle, but for a cubic term
          is_exact ? 0 : static_cast<double>(off.stableNorm() / row.exact_omega.stableNorm()),
          static_cast<double>(std::abs(length - 1))};
}

double omegaTolerance(const ReferenceRow& row) {
  const double size = norm(row.exact_omega);
  const bool has_denormals = size > 0 && size < kDenormalBelow;
  return kOmegaTolerance + (has_denormals ? std::numeric_limits<double>::denorm_min() / size : 0);
}

std::string complaint(const ReferenceRow& row, const RowErrors& errors) {
  std::ostringstream out;
  if (!(errors.attitude <= kAttitudeTolerance)) out << " attitude off by " << errors.attitude << " rad";
  if (!(errors.omega <= omegaTolerance(row))) out << " omega off by " << errors.omega << " of itself";
  if (!(errors.norm <= kNormTolerance)) out << " length of the quaternion off by " << errors.norm;
  return out.str().empty() ? "" : row.id + " (" + row.note + "):" + out.str();
}

void RowJudge::judge(const ReferenceRow& row, const Eigen::Quaterniond& attitude, const Eigen::Vector3d& omega,
                     const std::string& how) {
  const RowErrors errors = errorsOf(row, attitude, omega);
  EXPECT_EQ(complaint(row, errors), "") << how;
  for (Worst* worst : {&all_, &kinds_[row.note.substr(0, row.note.find(';'))]}) {
    ++worst->states;
    worst->attitude.meet(errors.attitude / kAttitudeTolerance, row.id);
    worst->omega.meet(errors.omega / omegaTolerance(row), row.id);
  }
}

void RowJudge::Ratio::meet(double other, const std::string& other_id) {
  if (other <= value) return;  // NaN is worse than anything
  value = other;
  id = other_id;
}

void RowJudge::Worst::print(const std::string& kind) const {
  std::printf("  %-32s %6d  %5.3f %-5s  %5.3f %-5s\n", kind.c_str(), states, attitude.value, attitude.id.c_str(),
              omega.value, omega.id.c_str());
}

void RowJudge::print(const std::string& title) const {
  std::printf("%s: worst error/tolerance\n  %-32s %6s  %-11s  %-11s\n", title.c_str(), "kind", "states", "attitude",
              "omega");
  for (const auto& [kind, worst] : kinds_) worst.print(kind);
  all_.print("ALL");
}

}  // namespace poinsot
