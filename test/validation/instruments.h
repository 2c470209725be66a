#pragma once

#include <functional>
#include <vector>

#include "poinsot/core/motion.h"

/** Measurements from the states of a motion alone, without periods and elliptic functions. */
namespace poinsot::validation {

/** A number read from a state. */
using Reading = std::function<double(const MotionState&)>;

/** A stride [s] in which no direction of the body turns by more than 0.1 rad: 0.1·μ_min/|L|. */
double stride(const MotionSetup& setup);

/** The component of Ω about the axis of intermediate moment, which changes its sign at each flip. */
Reading middleOmega(const MotionSetup& setup);

/**
 * The first `count` times t > 0 at which the reading changes its sign; fewer if `most` strides do not show them all.
 * Of readings that do not change their sign twice in a stride.
 */
std::vector<double> signChanges(Motion& motion, const Reading& reading, std::size_t count, double stride,
                                long most = 1000000);

/** From a sign change to the next but one [s]; kNone where there are none. */
double periodBySignChanges(const MotionSetup& setup, const Reading& reading);

/** The direction of a body axis about L [rad], in world axes: the angle φ of that axis' precession, up to whole turns.
 */
Reading azimuthAboutMomentum(const MotionSetup& setup, const Eigen::Vector3d& body_axis);

/** How far the body is turned about its axis `axis` [rad], from the plane through that axis and L: the angle ψ. */
Reading turnAboutAxis(int axis);

/** By how much an angle changes from t0 to t1 [rad], whole turns included. */
double turned(Motion& motion, const Reading& angle, double t0, double t1, double stride);

/**
 * The first time at which an angle has changed by ±`by` since t = 0; stride < 0 looks for the last one before.
 * kNone if `most` strides do not show it.
 */
double whenTurned(Motion& motion, const Reading& angle, double by, double stride, long most = 1000000);

}  // namespace poinsot::validation
