#include "wide.h"

#include <algorithm>
#include <cmath>

// wide_number.h comes first, because the templates of the others must see its functions.
#define POINSOT_SIMD_LEVEL wide
// clang-format off
#include "wide_number.h"
#include "set_up.h"
// clang-format on

namespace poinsot::closed_form {
namespace wide {

// Phases need some 110 bits below a turn and as many above as there are: up to 2¹⁰²⁴ s times 2¹⁰²⁴ rad/s.
constexpr int kMostBits = 2304;
// Nearly all phases are far smaller, and take a tenth of the time.
constexpr int kFewBits = 512;
constexpr double kFewBitsReach = 0x1p380;  // turns

/** phase mod period */
template <class Real>
Pair wrapped(const Real& phase, double period) {
  return asPair(Real(phase - period * round(phase / period)));
}

template <class Real>
Pair clamped(const Real& phase) {
  if (phase > kFarAlong) return {kFarAlong, 0};
  if (phase < -kFarAlong) return {-kFarAlong, 0};
  return asPair(phase);
}

template <class Real>
class Motion {
 public:
  Motion(const Start& start, const Constants& constants) : constants_(constants) {
    Constants unused;
    rates_ = setUp<Real>(start, unused);
  }

  /** Returns the phases at t0 + j·dt. */
  Phases phasesAt(double t0, double dt, long j) const {
    const Real time = (Real(t0) + Real(dt) * j) * constants_.time_scale;
    const Real half = rates_.half_start + rates_.half * time;
    return {constants_.kind == Constants::Kind::separatrix ? clamped(half) : wrapped(half, 2),
            wrapped(Real(rates_.turn * time), 1)};
  }

 private:
  const Constants& constants_;
  Rates<Real> rates_;
};

/** Calls action(motion) with a Motion whose numbers are wide enough for times up to `reach` [s]. */
template <class Action>
void withMotion(const Start& start, const Constants& constants, double reach, const Action& action) {
  if (isOrdinary(start) && reach * constants.time_scale < constants.reach * (kFewBitsReach / kMostTurns)) {
    action(Motion<Wide<kFewBits>>(start, constants));
  } else {
    action(Motion<Wide<kMostBits>>(start, constants));
  }
}

}  // namespace wide

bool isOrdinary(const Start& start) {
  // Within these limits, every product in the set-up stays above 2⁻¹⁰⁰⁰ or is added to a far larger number.
  constexpr int kOmegaBits = 480, kMomentBits = 60;
  double omega = 0, least_omega = HUGE_VAL, moment = 0, least_moment = HUGE_VAL;
  for (int i = 0; i < 3; ++i) {
    const double w = std::abs(start.omega[i]);
    omega = std::max(omega, w);
    if (w > 0) least_omega = std::min(least_omega, w);
    moment = std::max(moment, start.moments[i]);
    least_moment = std::min(least_moment, start.moments[i]);
  }
  return (omega == 0 || std::ilogb(least_omega) >= std::ilogb(omega) - kOmegaBits) &&
         std::ilogb(least_moment) >= std::ilogb(moment) - kMomentBits;
}

void setUpWide(const Start& start, Constants& constants) {
  wide::setUp<wide::Wide<wide::kMostBits>>(start, constants);
}

void phasesWide(const Start& start, const Constants& constants, double t, Phases& out) {
  wide::withMotion(start, constants, std::abs(t), [&](const auto& motion) { out = motion.phasesAt(t, 0, 0); });
}

void sampleWide(const Start& start, const Constants& constants, double t0, double dt, long n,
                double* const columns[7]) {
  const double reach = std::abs(t0) + std::abs(dt) * static_cast<double>(n);
  wide::withMotion(start, constants, reach, [&](const auto& motion) {
    for (long j = 0; j < n; ++j) {
      double attitude[4], omega[3];
      bestLevel().at_phases(constants, motion.phasesAt(t0, dt, j), attitude, omega);
      for (int i = 0; i < 4; ++i) columns[i][j] = attitude[(i + 3) % 4];
      for (int i = 0; i < 3; ++i) columns[4 + i][j] = omega[i];
    }
  });
}

Pair exactDiscriminant(double w3, double i3, double i2, double i1, double w1) {
  // Exact, because for an ordinary start each of the two terms has at most 2·53 + 53 + (53 + 60 + 1) bits.
  using Exact = wide::Wide<448>;
  return wide::asPair(
      Exact(Exact(w3) * w3 * (Exact(i3) * (Exact(i3) - i2)) - Exact(w1) * w1 * (Exact(i1) * (Exact(i2) - i1))));
}

}  // namespace poinsot::closed_form
