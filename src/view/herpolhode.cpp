#include "poinsot/view/herpolhode.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "even_spread.h"
#include "poinsot/core/pi.h"
#include "poinsot/view/ellipsoids.h"
#include "poinsot/view/flips.h"

namespace poinsot::view {
namespace {

constexpr double kWholeTurn = 2 * kPi;   // rad
constexpr int kPiecesPerTurn = 8;        // of the body about L, before pieces are halved
constexpr int kPiecesPerHalfPeriod = 8;  // likewise
constexpr int kMostHalvings = 12;
constexpr double kProbe =
    0.23;  // of a piece: a second place to measure, because a chord may cross a bend in its middle

/** The tip of ω, as a function of time. */
class Tip {
 public:
  Tip(const ClosedForm& motion, const InvariablePlane& plane) : motion_(motion), plane_(plane) {}

  Eigen::Vector3d operator()(double t) const {
    const ClosedForm::State state = motion_.at(t);
    return state.attitude * state.omega_principal;
  }
  double radius(double t) const { return onPlane(t).norm(); }
  /** Returns the angle about L from the tip at one time to that at another [rad], −π … π. */
  double angle(double from, double to) const {
    const Eigen::Vector3d a = onPlane(from), b = onPlane(to);
    return std::atan2(a.cross(b).dot(plane_.normal), a.dot(b));
  }

 private:
  /** Returns the place of the tip from the plane's centre [rad/s]. */
  Eigen::Vector3d onPlane(double t) const {
    const Eigen::Vector3d omega = (*this)(t);
    return omega - omega.dot(plane_.normal) * plane_.normal;
  }

  const ClosedForm& motion_;
  const InvariablePlane& plane_;
};

double distanceToChord(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d chord = b - a;
  const double length2 = chord.squaredNorm();
  const double s = length2 > 0 ? std::clamp((p - a).dot(chord) / length2, 0.0, 1.0) : 0.0;
  return (p - a - s * chord).norm();
}

/** Collects times, at most `most`, between which straight lines stay within the tolerance of the tip's curve. */
class Spread {
 public:
  Spread(const Tip& tip, double tolerance, std::size_t most) : tip_(tip), tolerance_(tolerance), most_(most) {}

  /** Adds those of an interval, but for its begin. @return whether there was room for all of it. */
  bool add(double begin, double end, double longest) {
    const double pieces = std::max(1.0, std::ceil((end - begin) / longest));
    double last = begin;
    Eigen::Vector3d last_tip = tip_(begin);
    for (double k = 1; k <= pieces; ++k) {
      const double next = k == pieces ? end : begin + (end - begin) * (k / pieces);
      const Eigen::Vector3d next_tip = tip_(next);
      halve(last, last_tip, next, next_tip, kMostHalvings);
      if (times_.size() >= most_) {
        times_.resize(most_);
        return k == pieces && times_.back() == end;
      }
      last = next;
      last_tip = next_tip;
    }
    return true;
  }

  const std::vector<double>& times() const { return times_; }

 private:
  void halve(double a, const Eigen::Vector3d& at_a, double b, const Eigen::Vector3d& at_b, int left) {
    const double middle = a + (b - a) / 2;
    const Eigen::Vector3d at_middle = tip_(middle);
    if (left == 0 || times_.size() >= most_ ||
        (distanceToChord(at_middle, at_a, at_b) <= tolerance_ &&
         distanceToChord(tip_(a + kProbe * (b - a)), at_a, at_b) <= tolerance_)) {
      times_.push_back(b);
      return;
    }
    halve(a, at_a, middle, at_middle, left - 1);
    halve(middle, at_middle, b, at_b, left - 1);
  }

  const Tip& tip_;
  double tolerance_;
  std::size_t most_;
  std::vector<double> times_;
};

bool isCircle(const Herpolhode& h, double tolerance) {
  return h.outer - h.inner <= tolerance;
}

/** Draws the circle through the outermost tip. */
void drawCircle(const Tip& tip, const InvariablePlane& plane, int points, Herpolhode& out) {
  const Eigen::Vector3d first = tip(out.start);
  for (int i = 0; i < points; ++i) {
    out.curve.points.push_back(Eigen::AngleAxisd(kWholeTurn * i / points, plane.normal) * first);
  }
  out.curve.closed = true;
}

void drawSeparatrix(const ClosedForm& motion, const Tip& tip, double tolerance, std::size_t most, Herpolhode& out) {
  out.start = flipOnSeparatrix(motion);
  out.outer = tip.radius(out.start);
  const double turn_time = kWholeTurn / motion.precessionRate();
  double reach = turn_time;
  for (int i = 0; i < 60 && tip.radius(out.start + reach) > tolerance; ++i) reach *= 1.25;
  Spread spread(tip, tolerance, most - 1);
  spread.add(out.start - reach, out.start + reach, turn_time / kPiecesPerTurn);
  out.curve.points.push_back(tip(out.start - reach));
  for (const double t : spread.times()) out.curve.points.push_back(tip(t));
}

/** Returns how many half periods, each turning by `angle`, bring a point at radius `outer` back; 0 where it takes more
 * than `most`. */
int halfPeriodsToClose(double angle, double outer, double tolerance, int most) {
  for (int n = 1; n <= most; ++n) {
    if (std::abs(std::remainder(n * angle, kWholeTurn)) * outer <= tolerance) return n;
  }
  return 0;
}

}  // namespace

InvariablePlane invariablePlane(const ClosedForm& motion) {
  const ClosedForm::State state = motion.at(0);
  const Eigen::Vector3d momentum = motion.moments().cwiseProduct(state.omega_principal);
  const Eigen::Vector3d normal = momentum.stableNormalized();
  return {state.attitude * normal, state.omega_principal.dot(normal)};
}

Herpolhode herpolhode(const ClosedForm& motion, int most_points, int most_half_periods, double tolerance) {
  Herpolhode out;
  const InvariablePlane plane = invariablePlane(motion);
  if (plane.normal.isZero(0)) return out;
  const Tip tip(motion, plane);
  const double stray = tolerance * longestSemiAxis(motion.moments(), motion.at(0).omega_principal);
  const std::size_t most = static_cast<std::size_t>(std::max(32, most_points));

  if (motion.regime() == ClosedForm::Regime::steady) {
    out.curve.points.push_back(tip(0));
    return out;
  }
  if (motion.regime() == ClosedForm::Regime::separatrix) {
    drawSeparatrix(motion, tip, stray, most, out);
    return out;
  }

  // |ω| is extreme where Ω crosses a plane of symmetry: at the middle of a flip, and a quarter of a period later.
  const double quarter = motion.period() / 4;
  const double flip = motion.timeToNextFlip(0);
  if (std::isfinite(flip)) {
    const double one = tip.radius(flip), other = tip.radius(flip + quarter);
    out.start = one >= other ? flip : flip + quarter;
    out.inner = std::min(one, other);
    out.outer = std::max(one, other);
  } else {
    out.inner = out.outer = tip.radius(0);
  }
  const double turn_time = kWholeTurn / motion.precessionRate();
  if (isCircle(out, stray)) {
    const double wanted = pointsOfCircle(out.outer, stray);
    drawCircle(tip, plane, static_cast<int>(std::clamp(wanted, 16.0, static_cast<double>(most))), out);
    return out;
  }

  const double half = 2 * quarter;
  Spread spread(tip, stray, most - 1);
  out.curve.points.push_back(tip(out.start));
  const bool whole =
      spread.add(out.start, out.start + half, std::min(turn_time / kPiecesPerTurn, half / kPiecesPerHalfPeriod));
  const std::vector<double>& times = spread.times();
  const int fit = whole ? static_cast<int>((most - 1) / times.size()) : 1;
  // Measured, because it is half of Montgomery's angle or half a turn more.
  const double angle = tip.angle(out.start, out.start + half);
  const int closing = halfPeriodsToClose(angle, out.outer, stray, std::min(fit, most_half_periods));
  const int count = closing > 0 ? closing : std::max(1, std::min(fit, most_half_periods));
  // Every half period is the same, turned about L.
  for (int k = 0; k < count; ++k) {
    for (const double t : times) out.curve.points.push_back(tip(t + k * half));
  }
  if (closing > 0 && whole) {
    out.curve.points.pop_back();
    out.curve.closed = true;
  }
  return out;
}

}  // namespace poinsot::view
