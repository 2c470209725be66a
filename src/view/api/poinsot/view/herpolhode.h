#pragma once

#include <Eigen/Core>

#include "poinsot/core/closed_form.h"
#include "poinsot/view/curve.h"

namespace poinsot::view {

/** The plane on which the energy ellipsoid rolls: ω·L = 2E, so that it stands still in the world. */
struct InvariablePlane {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< L/|L|, world axes; zero at rest
  double distance = 0;                               ///< 2E/|L|, of the plane from the ellipsoid's centre [rad/s]
};

/** Returns the invariable plane of a free body. */
InvariablePlane invariablePlane(const ClosedForm& motion);

/** The curve of the tip of ω on the invariable plane; world axes, rad/s. */
struct Herpolhode {
  /**
   * Closed where it is a circle (two equal moments, or as thick as the tolerance) or comes back to where it began; else
   * open, from one of its outermost points to another; on the separatrix out of the plane's centre and back into it. A
   * single point for steady spins; nothing at rest.
   */
  Curve curve;
  double inner = 0, outer = 0;  ///< radii of the annulus about the plane's centre that holds it [rad/s]
  double start = 0;  ///< a time at which it is outermost [s]: at the beginning of the curve, or in its middle
};

/**
 * Returns the herpolhode of a free body, from the closed form at times that are spread so that lines between the points
 * stray from it by no more than `tolerance`.
 *
 * It covers a whole number of half periods of the polhode, in each of which it goes from the outer circle to the inner
 * and back: as many as bring it back to its beginning, within `tolerance`; if there is no such number up to
 * `most_half_periods`, that many, or as many as fit into the points. One half period that does not fit is cut off.
 *
 * @param most_points at least 32.
 * @param tolerance relative to |L|/μmin, the longest semi-axis of the momentum ellipsoid.
 */
Herpolhode herpolhode(const ClosedForm& motion, int most_points = 1024, int most_half_periods = 6,
                      double tolerance = 1e-3);

}  // namespace poinsot::view
