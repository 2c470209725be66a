// The recurrences. Included by one source file for each instruction set, which defines POINSOT_TAYLOR_LEVEL.
#include <algorithm>

#include "kernel.h"

namespace poinsot::taylor {
namespace POINSOT_TAYLOR_LEVEL {

using Four = double __attribute__((vector_size(32)));

// 1, 1/2, 1/3, …
constexpr double kInverse[kMostOrder] = {1,        1.0 / 2,  1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,
                                         1.0 / 7,  1.0 / 8,  1.0 / 9,  1.0 / 10, 1.0 / 11, 1.0 / 12,
                                         1.0 / 13, 1.0 / 14, 1.0 / 15, 1.0 / 16, 1.0 / 17, 1.0 / 18,
                                         1.0 / 19, 1.0 / 20, 1.0 / 21, 1.0 / 22, 1.0 / 23, 1.0 / 24};

inline Four four(const double* v) {
  return Four{v[0], v[1], v[2], 0};
}
template <int a, int b, int c, int d>
inline Four shuffled(Four v) {
#ifdef __clang__
  return __builtin_shufflevector(v, v, a, b, c, d);
#else  // gcc has that one since version 12
  using Order = long long __attribute__((vector_size(32)));
  return __builtin_shuffle(v, Order{a, b, c, d});
#endif
}
inline Four yzx(Four v) {
  return shuffled<1, 2, 0, 3>(v);
}
inline Four zxy(Four v) {
  return shuffled<2, 0, 1, 3>(v);
}
inline double larger(double a, double b) {
  return a > b ? a : b;
}
inline double absolute(double a) {
  return __builtin_fabs(a);
}
inline double largest(Four v) {
  return larger(larger(absolute(v[0]), absolute(v[1])), larger(absolute(v[2]), absolute(v[3])));
}

/** A vector in body axes, also with its axes permuted, as products of series need it. */
struct Coefficients {
  Four plain[kMostOrder + 1], yzx[kMostOrder + 1], zxy[kMostOrder + 1];

  void set(int k, Four v) {
    plain[k] = v;
    yzx[k] = POINSOT_TAYLOR_LEVEL::yzx(v);
    zxy[k] = POINSOT_TAYLOR_LEVEL::zxy(v);
  }
};

/** Column by column. */
inline Four times(const double* map, Four v) {
  return four(map) * v[0] + four(map + 3) * v[1] + four(map + 6) * v[2];
}

/** Returns Σ cₖ for k = order … 1. */
inline Four sum(const Four* c, int order) {
  // Even and odd powers are summed apart, so that the chain of additions is half as long.
  Four even = c[order & ~1], odd = c[(order - 1) | 1];
  for (int k = (order & ~1) - 2; k >= 2; k -= 2) even += c[k];
  for (int k = ((order - 1) | 1) - 2; k >= 1; k -= 2) odd += c[k];
  return even + odd;
}

/** Returns the larger, or NaN where one of them is. */
inline double worse(double a, double b) {
  return a > b || a != a ? a : b;
}
/** Returns the larger of two successive terms, because a single one may vanish. */
inline double pair(const Four* c, int last) {
  return larger(largest(c[last - 1]), largest(c[last]));
}

/** Of a series whose size is `whole`. */
inline LeftOut leftOut(const Four* c, int order, double whole) {
  const double last = pair(c, order), before = pair(c, order - 2);
  if (last == 0) return {0, 0};
  return {last / whole, last < before ? last * last / ((before - last) * whole) : __builtin_inf()};
}

inline LeftOut worse(const LeftOut& a, const LeftOut& b) {
  return {worse(a.last_terms, b.last_terms), worse(a.error, b.error)};
}

/**
 * Coefficient k of every series includes the factor hᵏ, so that terms have the size of the increments, whatever the
 * scale of time; a power of h or of |Ω| alone would leave the range of doubles.
 *
 * Carried vectors obey v̇ = v×Ω + something linear: the fields, then r and ṙ/n of an orbit, then σ. Their number is a
 * template parameter, so that their products are all formed in one loop over the coefficients of Ω.
 */
template <int carried>
LeftOut step(const Body& body, const Start& start, int order, double h, Increment& out) {
  Coefficients omega, vectors[std::max(carried, 1)];
  Four attitude[kMostOrder + 1];
  const int radial = body.fields, along = radial + 1, slug = radial + (body.gradient ? 2 : 0);

  omega.set(0, four(start.omega));
  attitude[0] = Four{start.attitude[0], start.attitude[1], start.attitude[2], start.attitude[3]};
  for (int i = 0; i < body.fields; ++i) vectors[i].set(0, four(start.fields[i]));
  if (body.gradient) {
    vectors[radial].set(0, four(start.radial));
    vectors[along].set(0, four(start.along));
  }
  if (body.slug) vectors[slug].set(0, four(start.slug_omega));

  const Four moments = Four{body.moments[0], body.moments[1], body.moments[2], 1};
  // Λ×Ω = (μⱼ − μₖ)ΩⱼΩₖ, and so u×Mu with the opposite sign.
  const Four differences = yzx(moments) - zxy(moments);
  const Four inverse_moments = Four{1, 1, 1, 1} / moments;
  const bool invertible = largest(inverse_moments) < 1e300;  // moments may be denormal
  const double gradient = 3 * body.orbit_rate * body.orbit_rate;

  for (int k = 0; k < order; ++k) {
    Four gyroscopic = {}, a1 = {}, a2 = {}, a3 = {}, cross[std::max(carried, 1)] = {};
    const auto add = [&](int j) {
      const int m = k - j;
      const Four w = omega.plain[j], w_yzx = omega.yzx[j], w_zxy = omega.zxy[j];
      gyroscopic += w_yzx * omega.zxy[m];
      a1 += attitude[m] * w[0];
      a2 += attitude[m] * w[1];
      a3 += attitude[m] * w[2];
      for (int i = 0; i < carried; ++i) {
        cross[i] += vectors[i].yzx[m] * w_zxy;
        cross[i] -= vectors[i].zxy[m] * w_yzx;
      }
    };
    // Terms of the newest coefficients come last, so that the processor can sum the others meanwhile.
    for (int j = 1; j < k; ++j) add(j);
    if (k > 0) add(k);
    add(0);
    Four torque = differences * gyroscopic;
    if (k == 0) torque += four(start.torque);
    for (int i = 0; i < body.fields; ++i) torque += times(body.maps[i], vectors[i].plain[k]);
    if (body.gradient) {
      Four product = {};
      for (int j = 0; j <= k; ++j) product += vectors[radial].yzx[j] * vectors[radial].zxy[k - j];
      torque -= (gradient * differences) * product;
      cross[carried > 0 ? radial : 0] += body.orbit_rate * vectors[along].plain[k];
      cross[carried > 1 ? along : 0] -= body.orbit_rate * vectors[radial].plain[k];
    }
    if (body.damped) torque -= times(body.damping, omega.plain[k]);
    if (body.slug) {
      const Four slip = omega.plain[k] - vectors[slug].plain[k];
      torque -= body.slug_damping * slip;
      cross[carried > 0 ? slug : 0] += body.slug_rate * slip;
    }
    const double next = h * kInverse[k];
    // Rounded inverses would be moments of a slightly different body, which matters only in the first terms.
    omega.set(k + 1, k < 2 || !invertible ? torque * next / moments : torque * next * inverse_moments);
    for (int i = 0; i < carried; ++i) vectors[i].set(k + 1, cross[i] * next);
    const Four turn = shuffled<3, 2, 1, 0>(a1) * Four{1, 1, -1, -1} + shuffled<2, 3, 0, 1>(a2) * Four{-1, 1, 1, -1} +
                      shuffled<1, 0, 3, 2>(a3) * Four{1, -1, 1, -1};
    attitude[k + 1] = turn * (0.5 * next);
  }

  const Four dq = sum(attitude, order), dw = sum(omega.plain, order);
  // Quantities that start at 0 are measured by their size after the step.
  const double speed = larger(larger(largest(omega.plain[0]), largest(omega.plain[1])), largest(dw));
  LeftOut left = worse(leftOut(attitude, order, 1), leftOut(omega.plain, order, speed));
  if (body.slug) {
    const Four* const sigma = vectors[carried > 0 ? slug : 0].plain;
    const Four ds = sum(sigma, order);
    left = worse(left, leftOut(sigma, order, larger(speed, larger(largest(sigma[0]), largest(ds)))));
    for (int i = 0; i < 3; ++i) out.slug_omega[i] = ds[i];
  }
  for (int i = 0; i < 4; ++i) out.attitude[i] = dq[i];
  for (int i = 0; i < 3; ++i) out.omega[i] = dw[i];
  return left;
}

LeftOut run(const Body& body, const Start& start, int order, double h, Increment& out) {
  switch (body.fields + (body.gradient ? 2 : 0) + (body.slug ? 1 : 0)) {
    case 0:
      return step<0>(body, start, order, h, out);
    case 1:
      return step<1>(body, start, order, h, out);
    case 2:
      return step<2>(body, start, order, h, out);
    case 3:
      return step<3>(body, start, order, h, out);
    case 4:
      return step<4>(body, start, order, h, out);
    case 5:
      return step<5>(body, start, order, h, out);
    case 6:
      return step<6>(body, start, order, h, out);
    default:
      return step<7>(body, start, order, h, out);
  }
}

}  // namespace POINSOT_TAYLOR_LEVEL
}  // namespace poinsot::taylor
