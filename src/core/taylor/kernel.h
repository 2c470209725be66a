#pragma once

/**
 * Taylor series of a body under torques, compiled once for each instruction set. Plain numbers only: of an inline
 * function of a library that is compiled in several ways, the linker would keep one for all.
 */
namespace poinsot::taylor {

constexpr int kMostOrder = 24;
constexpr int kMostFields = 4;  ///< Torques' three, and the constant one

/** The constants of the body and its torques, in principal axes. */
struct Body {
  double moments[3];
  int fields;                   ///< number of world vectors
  double maps[kMostFields][9];  ///< column by column: torque = map · Rᵀx
  bool gradient;
  double orbit_rate;
  bool damped;
  double damping[9];  ///< column by column
  bool slug;
  double slug_damping, slug_rate;  ///< c and c/J
};

/** The state at the start of a step, and the world vectors seen from the body. */
struct Start {
  double attitude[4];  ///< x, y, z, w
  double omega[3], slug_omega[3];
  double torque[3];               ///< constant in the body
  double fields[kMostFields][3];  ///< Rᵀx
  double radial[3], along[3];     ///< Rᵀr, Rᵀṙ/n
};

/** The change of the state in a step. */
struct Increment {
  double attitude[4], omega[3], slug_omega[3];
};

/** The truncation error of a step, relative to the state or its change: the worst of all series. NaN where a term is
 * NaN. */
struct LeftOut {
  double last_terms;  ///< the larger of the last two terms
  double error;       ///< the sum of all later terms, if they fall as the last four did; may be infinite
};

/** Takes the step h [s] by terms up to h^order, 4 ≤ order ≤ kMostOrder. */
using Step = LeftOut (*)(const Body& body, const Start& start, int order, double h, Increment& out);

LeftOut stepBaseline(const Body& body, const Start& start, int order, double h, Increment& out);
LeftOut stepV3(const Body& body, const Start& start, int order, double h, Increment& out);

/** Returns the fastest that this processor can run; the baseline where POINSOT_SIMD=baseline is set. */
Step bestStep();

}  // namespace poinsot::taylor
