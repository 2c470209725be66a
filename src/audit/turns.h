#pragma once

#include <Eigen/Core>

#include "poinsot/audit/recording.h"
#include "poinsot/audit/report.h"

/** From message to message: how far the body turns. */
namespace poinsot::audit {

constexpr double kStampRounding = 2e-9;  // s: two stamps, each rounded to 1 ns

/** Two consecutive states of one segment, and what lies between them. */
struct Interval {
  const State& a;
  const State& b;
  double stamps;    ///< [s]
  double duration;  ///< time_rate · stamps: simulation time, as the stream says
  double rounding;  ///< of that [s]
};

/** The audit's idea of the turn from a to b as a rotation vector in the axes of a, and how far to trust it. */
struct Turn {
  Eigen::Vector3d theta;
  double error;  ///< [rad]
};

/** @param allowance what the method allows, on top of turn.error [rad] */
void compareTurn(Judge& judge, const Interval& v, const Turn& turn, double allowance);

}  // namespace poinsot::audit
