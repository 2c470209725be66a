#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "kept_momentum.h"
#include "poinsot/core/inertia.h"
#include "poinsot/core/stepper.h"
#include "steppers/restore_energy.h"
#include "steppers/restore_momentum.h"

/** Steppers for free bodies, made from the schemes in steppers/, whose single steps are inline. */
namespace poinsot::batch {

constexpr double kSmall = 1e-100, kLarge = 1e100;  // between them products of two or three stay in range

/** Returns the binary exponent of a size that is extreme; 0 for all other sizes, and for 0, infinity and NaN. */
inline int excess(double size) {
  if ((size >= kSmall && size <= kLarge) || !(size > 0) || !std::isfinite(size)) return 0;
  return std::ilogb(size);
}

/** Multiplies Λ and L by 2ᵏ, which is exact but for denormals. */
inline void scale(FreeRotationState& state, int k) {
  for (auto* vector : {&state.momentum_principal, &state.momentum_rest, &state.kept_momentum}) {
    *vector = vector->unaryExpr([k](double value) { return std::ldexp(value, k); });
  }
}

/** Sets the conserved L and E to those of the state, unless they differ by no more than rounding. */
inline void findKept(FreeRotationState& state, const Eigen::Vector3d& moments, const steppers::EnergyKeeper& energy) {
  const Eigen::Vector3d kept = state.kept_momentum;
  const double kept_inverse_inertia = state.kept_inverse_inertia;
  inlined::keepMomentum(state, inlined::momentumWorld(state));
  if ((state.kept_momentum - kept).squaredNorm() <= 1e-26 * kept.squaredNorm()) {
    state.kept_momentum = kept;
    state.kept_inverse_square = kept.isZero(0) ? 0 : 1 / kept.squaredNorm();
  }
  const Eigen::Vector3d& p = state.momentum_principal;
  state.kept_inverse_inertia = p.dot(p.cwiseQuotient(moments)) * state.kept_inverse_square;
  if (std::abs(state.kept_inverse_inertia - kept_inverse_inertia) <= 1e-11 * kept_inverse_inertia) {
    state.kept_inverse_inertia = kept_inverse_inertia;
  } else {
    state.kept_energy_gaps = energy.gaps(state);
  }
}

/**
 * Sets to 0 the components that have become negligible beside a spin about an axis of extreme moment. They would stay
 * negligible, but their products would be denormal numbers, with which a step takes twice as long. Beside a spin about
 * the unstable axis the smallest component grows again, so it is kept.
 */
inline void dropRemainders(FreeRotationState& state, int unstable_axis) {
  Eigen::Vector3d& p = state.momentum_principal;
  const double x = std::abs(p[0]), y = std::abs(p[1]), z = std::abs(p[2]);
  const double most = std::max(x, std::max(y, z));
  if (std::abs(p[unstable_axis]) == most) return;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(p[i]) < 1e-130 * most) p[i] = state.momentum_rest[i] = 0;
  }
}

/** What a scheme works out once for many steps: its Plan, or the step itself where it has none. */
template <class Scheme, class = void>
struct Planned {
  static double plan(const Scheme&, const FreeRotationState&, double step) { return step; }
};
template <class Scheme>
struct Planned<Scheme, std::void_t<typename Scheme::Plan>> {
  static auto plan(const Scheme& scheme, const FreeRotationState& state, double step) {
    return scheme.plan(state, step);
  }
};

/** Takes the steps; an implicit method says how many iterations each took. */
template <class Scheme, class Plan>
[[gnu::always_inline]] inline Work take(const Scheme& scheme, FreeRotationState& state, const Plan& plan,
                                        std::int64_t count) {
  if constexpr (std::is_same_v<decltype(scheme.step(state, plan)), int>) {
    Work work;
    for (std::int64_t i = 0; i < count; ++i) work += Scheme::work(scheme.step(state, plan));
    return work;
  } else {
    for (std::int64_t i = 0; i < count; ++i) scheme.step(state, plan);
    return count * Scheme::kWork;
  }
}

/**
 * Runs a method's inline step() in a plain loop. The method sees moments and momenta of an ordinary size: extreme ones
 * are scaled by powers of two, and the step with them, which changes no digit of the result. Where it keeps L, rounding
 * is kept from moving it.
 */
template <class Scheme, int steps_between_restorations, bool keeps_energy>
class BatchStepper final : public Stepper {
 public:
  explicit BatchStepper(const Eigen::Vector3d& moments)
      : moments_scale_(excess(moments.maxCoeff())),
        unstable_axis_(ascendingAxes(moments)[1]),
        moments_(moments.unaryExpr([this](double value) { return std::ldexp(value, -moments_scale_); })),
        scheme_(moments_),
        energy_(moments_) {}

  Work advanceFrom(RotationState& state, double, double length) const override { return advance(state, 0, length, 1); }

  Work advance(RotationState& state, std::int64_t, double step, std::int64_t count) const override {
    const int momentum_scale = excess(state.momentum_principal.cwiseAbs().maxCoeff());
    if (momentum_scale == 0 && moments_scale_ == 0) {
      return run(state, step, count);
    }
    FreeRotationState scaled = state;  // run() may throw
    scale(scaled, -momentum_scale);
    const Work work = run(scaled, std::ldexp(step, momentum_scale - moments_scale_), count);
    scale(scaled, momentum_scale);
    static_cast<FreeRotationState&>(state) = scaled;
    return work;
  }

 private:
  Work run(FreeRotationState& state, double step, std::int64_t count) const {
    FreeRotationState s = state;
    if constexpr (steps_between_restorations == 0) {
      const Work work = take(scheme_, s, step, count);
      state = s;
      return work;
    }
    findKept(s, moments_, energy_);
    const auto plan = Planned<Scheme>::plan(scheme_, s, step);
    Work work;
    while (count > 0) {
      const int due = std::max(1, steps_between_restorations - s.steps_since_restored);
      const int some = static_cast<int>(std::min<std::int64_t>(count, due));
      work += take(scheme_, s, plan, some);
      count -= some;
      s.steps_since_restored += some;
      if (s.steps_since_restored < steps_between_restorations) break;
      s.steps_since_restored = 0;
      if constexpr (keeps_energy) energy_.restore(s);
      steppers::restoreMomentum(s);
      dropRemainders(s, unstable_axis_);
    }
    state = s;
    return work;
  }

  int moments_scale_, unstable_axis_;
  Eigen::Vector3d moments_;  ///< as the scheme sees them
  Scheme scheme_;
  steppers::EnergyKeeper energy_;
};

template <class Scheme>
std::unique_ptr<Stepper> make(const Eigen::Vector3d& moments) {
  return std::make_unique<BatchStepper<Scheme, 0, false>>(moments);
}

/** For schemes that conserve L. The count is lower for those that turn the body more than once a step. */
template <class Scheme, int steps_between_restorations = steppers::kStepsBetweenRestorations>
std::unique_ptr<Stepper> makeKeeping(const Eigen::Vector3d& moments) {
  return std::make_unique<BatchStepper<Scheme, steps_between_restorations, false>>(moments);
}

/** For schemes that conserve L and E. */
template <class Scheme>
std::unique_ptr<Stepper> makeKeepingEnergy(const Eigen::Vector3d& moments) {
  return std::make_unique<BatchStepper<Scheme, steppers::kStepsBetweenRestorations, true>>(moments);
}

}  // namespace poinsot::batch
