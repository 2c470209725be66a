#pragma once

/**
 * Taylor series of a body under torques, for one instruction set: declarations. Plain numbers only: an inline function
 * of a library, compiled in several ways, would be kept in one of them by the linker.
 */
namespace poinsot::taylor {

constexpr int kMostOrder = 24;
constexpr int kMostFields = 4;  ///< Torques' three, and the constant one

/** What does not change from step to step; principal axes. */
struct Body {
  double moments[3];
  int fields;                   ///< world vectors that are carried along
  double maps[kMostFields][9];  ///< column by column: torque = map · Rᵀx
  bool gradient;
  double orbit_rate;
  bool damped;
  double damping[9];  ///< column by column
  bool slug;
  double slug_damping, slug_rate;  ///< c and c/J
};

/** Where a step begins. */
struct Start {
  double attitude[4];  ///< x, y, z, w
  double omega[3], slug_omega[3];
  double torque[3];               ///< constant in the body
  double fields[kMostFields][3];  ///< Rᵀx
  double radial[3], along[3];     ///< Rᵀr, Rᵀṙ/n
};

/** What a step adds. */
struct Increment {
  double attitude[4], omega[3], slug_omega[3];
};

/** What a step leaves out, as parts of the state or of its change, the worst of all series. NaN where a term is none.
 */
struct LeftOut {
  double last_terms;  ///< the larger of the last two terms that are in it
  double error;       ///< all that would come after them, if they went on to fall as the last four did; may be infinite
};

/** The step h by terms up to h^order, 4 ≤ order ≤ kMostOrder. */
using Step = LeftOut (*)(const Body& body, const Start& start, int order, double h, Increment& out);

LeftOut stepBaseline(const Body& body, const Start& start, int order, double h, Increment& out);
LeftOut stepV3(const Body& body, const Start& start, int order, double h, Increment& out);

/** The fastest that this processor can run; POINSOT_SIMD=baseline asks for the plain one. */
Step bestStep();

}  // namespace poinsot::taylor
