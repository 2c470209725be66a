#include "poinsot/core/stepper.h"

#include <algorithm>
#include <cmath>

#include "poinsot/core/steppers/buss2.h"
#include "poinsot/core/steppers/lie_euler.h"
#include "poinsot/core/steppers/restore_momentum.h"
#include "poinsot/core/steppers/rk4.h"

namespace poinsot {
namespace {

constexpr double kSmall = 1e-100, kLarge = 1e100;  // between them products of two or three stay in range

/** The power of two that brings a size near 1 where it is extreme; 0 where it is not, nor 0, infinite or NaN. */
int excess(double size) {
  if ((size >= kSmall && size <= kLarge) || !(size > 0) || !std::isfinite(size)) return 0;
  return std::ilogb(size);
}

/** Λ and L by 2ᵏ, which is exact but for denormals. */
void scale(RotationState& state, int k) {
  for (auto* vector : {&state.momentum_body, &state.momentum_rest, &state.kept_momentum}) {
    *vector = vector->unaryExpr([k](double value) { return std::ldexp(value, k); });
  }
}

/** The L to be kept is that of the start, or the one that the caller has made of it since. */
void findKeptMomentum(RotationState& state) {
  const Eigen::Vector3d kept = state.kept_momentum;
  state.keepMomentum();
  if ((state.kept_momentum - kept).squaredNorm() <= 1e-26 * kept.squaredNorm()) {
    state.kept_momentum = kept;
    state.kept_inverse_square = kept.isZero(0) ? 0 : 1 / kept.squaredNorm();
  }
}

/** The axis of the moment that is neither the largest nor the smallest. */
int intermediateAxis(const Eigen::Vector3d& moments) {
  int axes[] = {0, 1, 2};
  std::sort(axes, axes + 3, [&](int i, int j) { return moments[i] < moments[j]; });
  return axes[1];
}

/**
 * Sets to 0 what has died away beside a spin about an axis of extreme moment. It would stay nothing, but its products
 * would be denormal numbers, with which a step takes twice as long. About the unstable axis the least remainder grows
 * again, and stays.
 */
void dropRemainders(RotationState& state, int unstable_axis) {
  Eigen::Vector3d& p = state.momentum_body;
  const double x = std::abs(p[0]), y = std::abs(p[1]), z = std::abs(p[2]);
  const double most = std::max(x, std::max(y, z));
  if (std::abs(p[unstable_axis]) == most) return;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(p[i]) < 1e-130 * most) p[i] = state.momentum_rest[i] = 0;
  }
}

/**
 * Runs a method's inline step() in a plain loop. The method sees moments and momenta of an ordinary size: extreme ones
 * are scaled by powers of two, and the step with them, which changes no digit of the result. Where it keeps L, rounding
 * is kept from moving it.
 */
template <class Scheme, int steps_between_restorations>
class BatchStepper final : public Stepper {
 public:
  explicit BatchStepper(const Eigen::Vector3d& moments)
      : moments_scale_(excess(moments.maxCoeff())),
        unstable_axis_(intermediateAxis(moments)),
        scheme_(moments.unaryExpr([this](double value) { return std::ldexp(value, -moments_scale_); })) {}

  void advance(RotationState& state, double step, std::int64_t count) const override {
    const int momentum_scale = excess(state.momentum_body.cwiseAbs().maxCoeff());
    if (momentum_scale == 0 && moments_scale_ == 0) {
      run(state, step, count);
    } else {
      scale(state, -momentum_scale);
      run(state, std::ldexp(step, momentum_scale - moments_scale_), count);
      scale(state, momentum_scale);
    }
  }

 private:
  void run(RotationState& state, double step, std::int64_t count) const {
    RotationState s = state;
    if constexpr (steps_between_restorations == 0) {
      for (std::int64_t i = 0; i < count; ++i) scheme_.step(s, step);
      state = s;
      return;
    }
    findKeptMomentum(s);
    while (count > 0) {
      const int due = std::max(1, steps_between_restorations - s.steps_since_restored);
      const int some = static_cast<int>(std::min<std::int64_t>(count, due));
      for (int i = 0; i < some; ++i) scheme_.step(s, step);
      count -= some;
      s.steps_since_restored += some;
      if (s.steps_since_restored < steps_between_restorations) break;
      s.steps_since_restored = 0;
      steppers::restoreMomentum(s);
      dropRemainders(s, unstable_axis_);
    }
    state = s;
  }

  int moments_scale_, unstable_axis_;
  Scheme scheme_;
};

template <class Scheme>
std::unique_ptr<Stepper> make(const Eigen::Vector3d& moments) {
  return std::make_unique<BatchStepper<Scheme, 0>>(moments);
}

/** For those that conserve L; the count, for those that turn the body more than once a step. */
template <class Scheme, int steps_between_restorations = steppers::kStepsBetweenRestorations>
std::unique_ptr<Stepper> makeKeeping(const Eigen::Vector3d& moments) {
  return std::make_unique<BatchStepper<Scheme, steps_between_restorations>>(moments);
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> table = {
      // name, order, conserves L, conserves E
      {"lie_euler", 1, true, false, makeKeeping<steppers::LieEuler>},
      {"buss2", 2, true, false, makeKeeping<steppers::Buss2>},
      {"rk4", 4, false, false, make<steppers::Rk4>},
  };
  return table;
}

const Method* findMethod(const std::string& name) {
  for (const Method& method : methods()) {
    if (name == method.name) return &method;
  }
  return nullptr;
}

std::string methodNames() {
  std::string names;
  for (const Method& method : methods()) names += (names.empty() ? "" : ", ") + std::string(method.name);
  return names;
}

}  // namespace poinsot
