#pragma once

#include <cstdint>

/** The numbers that a ClosedForm works out once and then evaluates from. Symbols: doc/closed_form.md. */
namespace poinsot::closed_form {

/** A number as the sum of two doubles. */
struct Pair {
  double high = 0;  ///< the sum, rounded to a double
  double low = 0;   ///< the sum less `high`
};

/**
 * How the motion goes on: two phases that are linear in scaled time, each counted in turns of its own.
 * - half: v = u/2K, in half-periods of Ω;
 * - turn: f, the phase about L, in turns of a quaternion (4π).
 * On the separatrix, where K is infinite, v = u/kSeparatrixSpan.
 */
struct Phases {
  Pair half;  ///< v
  Pair turn;  ///< f
};

/** The unit of v on the separatrix: see Phases. */
constexpr double kSeparatrixSpan = 2000;

/** Everything that is needed to evaluate a state at some time. */
struct Constants {
  /** The functions of the theta series: trigonometric up to a nome of 0.2, hyperbolic from there to the separatrix. */
  enum class Series : std::uint8_t { trigonometric, hyperbolic };
  /** ClosedForm::Regime, as the evaluation needs it. */
  enum class Kind : std::uint8_t { steady, periodic, separatrix };

  Kind kind = Kind::steady;               ///< steady, periodic, or on the separatrix
  Series series = Series::trigonometric;  ///< which of the series below are in use
  std::int8_t encircled = -1;             ///< principal axis, −1 for none
  bool delicate = false;   ///< Ω₁ may dwarf the rest, so that cn must be right to its last bits also near its zeros
  bool symmetric = false;  ///< two equal moments

  double time_scale = 1;  ///< scaled time = t·time_scale, a power of two
  double reach = 0;       ///< scaled time up to which double-double phases are good enough
  Phases rate;            ///< per unit of scaled time
  Phases start;           ///< at t = 0; turn is 0

  // Series in y = cos 2α, or in E = exp(−|x|) and H = exp(|x| − X/2), x = X·v.
  double theta_even[3] = {1, 0, 0};  ///< trigonometric: θ₄, and θ₃ with odd terms reversed; the even terms
  double theta_odd[2] = {0, 0};      ///< trigonometric: the odd terms of the same
  double sine_even[3] = {1, 0, 0};   ///< trigonometric: θ₁/sin α, θ₂/cos α; the even terms
  double sine_odd[2] = {0, 0};       ///< trigonometric: the odd terms of the same
  double z_real[4] = {1, 0, 0, 0};   ///< trigonometric: Z, real part
  double z_imag[3] = {0, 0, 0};      ///< trigonometric: Z, imaginary part
  double wraps = 1;                  ///< hyperbolic: 0 on the separatrix, else 1
  double span = 0;                   ///< hyperbolic: X = πK/K'
  double span_high = 0;              ///< hyperbolic: the first 8 bits of X
  double span_rest = 0;              ///< hyperbolic: the rest of X
  double nome[7] = {0};              ///< hyperbolic: powers 0 … 6 of q' = exp(−X)
  double root_nome = 0;              ///< hyperbolic: √q'
  double z_cos[4] = {0, 0, 0, 0};    ///< hyperbolic: cos (n + ½)η
  double z_sin[4] = {0, 0, 0, 0};    ///< hyperbolic: sin (n + ½)η
  double z_turn = 0;                 ///< hyperbolic: η/2π, by which Z turns a half-period

  // Amplitudes of cn, sn, dn as the series give them (theta constants included), along the internal axes.
  double momentum[3] = {0, 0, 1};  ///< of M/|L|
  int from[3] = {0, 1, 2};         ///< Ω's component i is that along internal axis from[i] …
  double omega[3] = {0, 0, 0};     ///< … times this …
  double omega_unit = 1;           ///< … times this [rad/s]
  double frame[4][4] = {};         ///< attitude (w, x, y, z) = frame · (internal quaternion)

  double complementary_modulus = 1;  ///< k'
};

}  // namespace poinsot::closed_form
