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

/**
 * The step h by terms up to h^order, 4 ≤ order ≤ kMostOrder. False, and nothing in `out`, when the last two terms are
 * not small beside the state: the series does not converge, or h is so long that it is of no use.
 */
using Step = bool (*)(const Body& body, const Start& start, int order, double h, Increment& out);

bool stepBaseline(const Body& body, const Start& start, int order, double h, Increment& out);
bool stepV3(const Body& body, const Start& start, int order, double h, Increment& out);

/** The fastest that this processor can run; POINSOT_SIMD=baseline asks for the plain one. */
Step bestStep();

}  // namespace poinsot::taylor
