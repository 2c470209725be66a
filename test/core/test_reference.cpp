// The steppers judged on published rows: on those with |t| ≤ 100 whose moments obey the triangle inequality and differ by
// less than a factor of 10, with |Ω|h ≤ 0.01, error(h)/error(h/2) is within 20 % of 2, 4, 16 wherever the error is above
// 1e-11, and rk4 comes below 1e-10 wherever cond_rad is below 1e-13.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <set>

#include "poinsot/core/inertia.h"
#include "poinsot/core/rotation.h"
#include "poinsot/core/stepper.h"
#include "reference_rows.h"

namespace poinsot {
namespace {

constexpr double kCoarsest = 0.01;    // |Ω|h
constexpr double kSmallError = 1e-11;  // rad: below it no ratio is asked for
constexpr double kMostSteps = 2e8;     // of one run

const std::vector<ReferenceRow>& allRows() {
  static const std::vector<ReferenceRow> rows = readReferenceRows(TEST_DATA_DIR "/public.csv");
  return rows;
}

bool isJudged(const ReferenceRow& row) {
  return std::abs(row.t) <= 100 && row.moments.maxCoeff() < 10 * row.moments.minCoeff() &&
         PrincipalInertia::fromMoments(row.moments).satisfiesTriangleInequality();
}

/** Errors of one method on one row, with n₀·2ᵏ steps, k = 0, 1, …; n₀ is the least with |Ω|h ≤ 0.01. */
class Ladder {
 public:
  Ladder(const Method& method, const ReferenceRow& row) : row_(row), stepper_(method.make(row.moments)) {
    start_ = RotationState::fromOmega(row.moments, row.attitude_0.normalized(), row.omega_0);
    n_ = std::max(1.0, std::ceil(row.omega_0.stableNorm() * std::abs(row.t) / kCoarsest));
  }
  double steps(int k) const { return std::ldexp(n_, k); }
  bool withinReach(int k) const { return steps(k) <= kMostSteps; }
  double omegaStep(int k) const { return row_.omega_0.stableNorm() * std::abs(row_.t) / steps(k); }
  double error(int k) {
    while (static_cast<int>(errors_.size()) <= k) {
      const double n = steps(static_cast<int>(errors_.size()));
      RotationState state = start_;
      stepper_->advance(state, row_.t / n, static_cast<std::int64_t>(n));
      errors_.push_back(angleBetween(row_.attitude, state.attitude));
    }
    return errors_[k];
  }

 private:
  const ReferenceRow& row_;
  std::unique_ptr<Stepper> stepper_;
  RotationState start_;
  double n_;
  std::vector<double> errors_;
};

enum class Verdict {
  shown,        ///< the ratio of the order, from some step on
  small,        ///< no error above 1e-11 to judge
  roundoff,     ///< errors within 16·cond_rad, where no double-precision method shows an order
  out_of_reach  ///< the order would show only at steps too small to try
};

/** Halves the step until two ratios in a row (or the last one before errors get small) are within 20 % of 2^order. */
Verdict judge(const Method& method, const ReferenceRow& row) {
  Ladder ladder(method, row);
  const double wanted = std::ldexp(1.0, method.order);
  std::printf("%s %-9s cond %.1e:", row.id.c_str(), method.name, row.cond_rad);
  const auto say = [](Verdict verdict, const char* text) {
    std::printf("  %s\n", text);
    return verdict;
  };
  int good = 0;
  for (int k = 0; ladder.withinReach(k + 1); ++k) {
    if (ladder.error(k) <= kSmallError) {
      return good > 0 ? say(Verdict::shown, "shown") : say(Verdict::small, "error below 1e-11");
    }
    if (ladder.error(k + 1) <= 16 * row.cond_rad + 1e-15) return say(Verdict::roundoff, "roundoff");
    const double ratio = ladder.error(k) / ladder.error(k + 1);
    good = std::abs(ratio / wanted - 1) <= 0.2 ? good + 1 : 0;
    if (k == 0 || good > 0) {
      std::printf("  |O|h %.1e error %.1e ratio %.2f", ladder.omegaStep(k), ladder.error(k), ratio);
    }
    if (good == 2) return say(Verdict::shown, "shown");
  }
  return say(Verdict::out_of_reach, "OUT OF REACH");
}

TEST(Reference, rowsAreRead) {
  EXPECT_EQ(allRows().size(), 69u);
  EXPECT_EQ(allRows()[0].id, "P001");
  EXPECT_EQ(allRows()[0].omega_0, Eigen::Vector3d(0.01, 1, 0.01));
  EXPECT_EQ(allRows()[68].t, 1000);
  for (const ReferenceRow& row : allRows()) {
    EXPECT_NEAR(row.attitude.norm(), 1, 4e-16) << row.id;
    // E and L at t are those at 0: the file and the reader agree on what is what.
    const Eigen::Vector3d l0 = row.attitude_0.normalized() * row.moments.cwiseProduct(row.omega_0);
    const Eigen::Vector3d l = row.attitude * row.moments.cwiseProduct(row.omega);
    EXPECT_LE((l - l0).stableNorm(), 4e-15 * l0.stableNorm()) << row.id;
  }
}

TEST(Reference, steppersShowTheirOrder) {
  std::set<std::string> roundoff, out_of_reach;
  int rows = 0, shown = 0, small = 0;
  for (const ReferenceRow& row : allRows()) {
    if (!isJudged(row)) continue;
    ++rows;
    for (const char* name : {"lie_euler", "buss2", "rk4"}) {
      const std::string what = row.id + " " + name;
      switch (judge(*findMethod(name), row)) {
        case Verdict::shown:
          ++shown;
          break;
        case Verdict::small:
          ++small;
          break;
        case Verdict::roundoff:
          roundoff.insert(what);
          break;
        case Verdict::out_of_reach:
          out_of_reach.insert(what);
          break;
      }
    }
  }
  std::printf("%d rows x 3 methods: %d show the ratio, %d have no error above 1e-11, %zu roundoff, %zu out of reach\n",
              rows, shown, small, roundoff.size(), out_of_reach.size());
  EXPECT_EQ(rows, 47);
  EXPECT_EQ(roundoff, (std::set<std::string>{}));
  EXPECT_EQ(out_of_reach, (std::set<std::string>{}));
}

TEST(Reference, rk4ComesBelow1e10WhereTheRowIsWellConditioned) {
  int rows = 0;
  for (const ReferenceRow& row : allRows()) {
    if (!isJudged(row) || !(row.cond_rad < 1e-13)) continue;
    ++rows;
    Ladder ladder(*findMethod("rk4"), row);
    int k = 0;
    while (ladder.error(k) >= 1e-10 && ladder.withinReach(k + 1)) ++k;
    std::printf("%s |O|h %.1e error %.1e\n", row.id.c_str(), ladder.omegaStep(k), ladder.error(k));
    EXPECT_LT(ladder.error(k), 1e-10) << row.id;
  }
  EXPECT_EQ(rows, 35);
}

}  // namespace
}  // namespace poinsot
