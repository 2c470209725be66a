#include "wide.h"

#include <cmath>

// wide_number.h comes first: the templates of the others must see its functions.
#define POINSOT_SIMD_LEVEL wide
// clang-format off
#include "wide_number.h"
#include "set_up.h"
// clang-format on

namespace poinsot::closed_form {
namespace wide {

/** phase mod period */
Pair wrapped(const Wide& phase, double period) {
  return asPair(Wide(phase - period * round(phase / period)));
}

class Motion {
 public:
  Motion(const Start& start, const Constants& constants) : constants_(constants) {
    Constants unused;
    rates_ = setUp<Wide>(start, unused);
  }
  Wide scaledTime(double t) const { return Wide(t) * constants_.time_scale; }
  Phases phasesAt(const Wide& time) const {
    const Wide half = rates_.half_start + rates_.half * time;
    return {constants_.kind == Constants::Kind::separatrix ? clamped(half) : wrapped(half, 2),
            wrapped(rates_.turn * time, 1)};
  }

 private:
  static Pair clamped(const Wide& phase) {
    if (phase > kFarAlong) return {kFarAlong, 0};
    if (phase < -kFarAlong) return {-kFarAlong, 0};
    return asPair(phase);
  }

  const Constants& constants_;
  Rates<Wide> rates_;
};

}  // namespace wide

bool isOrdinary(const Start& start) {
  // With these, every product in the set-up stays above 2⁻¹⁰⁰⁰, or is added to something far larger.
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
  wide::setUp<wide::Wide>(start, constants);
}

void phasesWide(const Start& start, const Constants& constants, double t, Phases& out) {
  const wide::Motion motion(start, constants);
  out = motion.phasesAt(motion.scaledTime(t));
}

void sampleWide(const Start& start, const Constants& constants, double t0, double dt, long n,
                double* const columns[7]) {
  const wide::Motion motion(start, constants);
  const wide::Wide begin = motion.scaledTime(t0), step = motion.scaledTime(dt);
  for (long j = 0; j < n; ++j) {
    double attitude[4], omega[3];
    bestLevel().at_phases(constants, motion.phasesAt(wide::Wide(begin + step * j)), attitude, omega);
    for (int i = 0; i < 4; ++i) columns[i][j] = attitude[(i + 3) % 4];
    for (int i = 0; i < 3; ++i) columns[4 + i][j] = omega[i];
  }
}

Pair exactDiscriminant(double w3, double i3, double i2, double i1, double w1) {
  // Exact: of an ordinary start each of the two terms has at most 2·53 + 53 + (53 + 60 + 1) bits.
  using Exact = wide::mp::number<wide::mp::cpp_bin_float<448, wide::mp::digit_base_2>, wide::mp::et_off>;
  const Exact value = Exact(w3) * w3 * (Exact(i3) * (Exact(i3) - i2)) - Exact(w1) * w1 * (Exact(i1) * (Exact(i2) - i1));
  const double high = value.convert_to<double>();
  return {high, Exact(value - high).convert_to<double>()};
}

}  // namespace poinsot::closed_form
