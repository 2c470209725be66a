#include "poinsot/view/flips.h"

#include <cmath>
#include <functional>
#include <limits>

#include "sorted_axes.h"

namespace poinsot::view {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLeastSwing = 0.70710678118654752;  // cos 45°

std::int64_t toCount(double whole) {
  constexpr double kMost = 9007199254740992;  // 2⁵³, beyond which doubles skip whole numbers
  return static_cast<std::int64_t>(std::fmax(-kMost, std::fmin(kMost, whole)));
}

/** Flips at equal intervals of half a period. */
struct Beat {
  const ClosedForm& motion;
  double half;

  double toNext(double t) const { return motion.timeToNextFlip(t); }
  /** Returns the time since the last flip, > 0; at a flip, since the one before. */
  double toLast(double t) const {
    const double last = half - toNext(t);
    return last > 0 ? last : last + half;
  }
};

const char* textOfSteadySpin(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega) {
  Eigen::Index axis;
  omega.cwiseAbs().maxCoeff(&axis);
  const auto others = [&](auto compare) {
    int count = 0;
    for (Eigen::Index i = 0; i < 3; ++i) count += i != axis && compare(moments[i], moments[axis]);
    return count;
  };
  if (others(std::equal_to<>()) == 1) return "steady about an axis of equal moments";
  const int larger = others(std::greater<>());
  return larger == 2   ? "steady about the axis of smallest moment"
         : larger == 0 ? "steady about the axis of largest moment"
                       : "steady about the axis of intermediate moment";
}

}  // namespace

double flipOnSeparatrix(const ClosedForm& motion) {
  if (motion.at(0).omega_principal[SortedAxes(motion.moments()).index[1]] == 0) return 0;
  // Look from earlier and earlier times, until the flip lies ahead.
  double before = 0, left = motion.timeToNextFlip(0);
  for (double step = 1 / motion.precessionRate(); !std::isfinite(left) && std::isfinite(step); step *= 2) {
    before = -step;
    left = motion.timeToNextFlip(before);
  }
  return before + left;
}

double largestSwing(const ClosedForm& motion) {
  if (motion.regime() == ClosedForm::Regime::separatrix) return 1;
  if (motion.regime() == ClosedForm::Regime::steady) return 0;
  const SortedAxes axes(motion.moments());
  if (!axes.allDiffer()) return 0;
  const int a = motion.encircledAxis() == axes.index[0] ? 0 : 2, c = 2 - a;
  const auto& m = axes.moment;
  Eigen::Vector3d omega = motion.at(0).omega_principal;
  omega /= omega.cwiseAbs().maxCoeff();
  const double ob = omega[axes.index[1]], oc = omega[axes.index[c]];
  const double ab = std::abs(m[a] - m[1]), ac = m[2] - m[0];
  // |F − 2E μ_a| = I_c d_ac Ω_c² + I_b d_ab Ω_b², a sum of positive terms.
  const double p = m[c] * ac * oc * oc + m[1] * ab * ob * ob;
  double f = 0;
  for (int i = 0; i < 3; ++i) f += std::pow(m[i] * omega[axes.index[i]], 2);
  return std::sqrt(m[1] * p / ab / f);
}

Flips flipsOf(const ClosedForm& motion, double t, double direction) {
  const double next = motion.timeToNextFlip(t);  // throws when t is not finite
  if (!(largestSwing(motion) > kLeastSwing)) return {false, 0, kInfinity};
  const bool backwards = direction < 0;

  if (motion.regime() == ClosedForm::Regime::separatrix) {
    const double flip = flipOnSeparatrix(motion);
    const int count = (0 < flip && flip <= t) - (t <= flip && flip < 0);
    return {true, count, !backwards ? next : t > flip ? t - flip : kInfinity};
  }

  const Beat beat{motion, motion.period() / 2};
  Flips out{true, 0, backwards ? beat.toLast(t) : next};
  // There is a whole number of half periods from flip to flip; round() removes errors of rounding.
  if (t > 0) out.since_start = toCount(std::round((t + next - beat.toNext(0)) / beat.half));
  if (t < 0) out.since_start = -toCount(std::round((-t + beat.toLast(t) - beat.toLast(0)) / beat.half));
  return out;
}

const char* textOf(Regime regime, const Eigen::Vector3d& moments, const Eigen::Vector3d& omega_principal) {
  switch (regime) {
    case Regime::about_smallest:
      return "about the axis of smallest moment";
    case Regime::about_largest:
      return "about the axis of largest moment";
    case Regime::separatrix:
      return "on the separatrix";
    case Regime::circle:
      return "about the axis of symmetry";
    case Regime::axis_spin:
      return textOfSteadySpin(moments, omega_principal);
    case Regime::sphere:
      return "steady: three equal moments";
    case Regime::rest:
      break;
  }
  return "at rest";
}

}  // namespace poinsot::view
