#pragma once

#include <memory>
#include <vector>

#include "markers/part.h"

/**
 * All parts that a picture may have. One that remembers nothing is a function; one that does is a Part, made here.
 * body_picture.cpp says which of them a picture has.
 */
namespace poinsot::node::parts {

// What stands still.

/**
 * The body as it looks: a mesh, or else its solids in true size, in body axes, painted so that neither a turn nor a
 * flip can be overlooked.
 */
void appendShape(const Subject& subject, Canvas& canvas);

void appendBodyTitle(const Subject& subject, Canvas& canvas);
void appendPictureTitles(const Subject& subject, Canvas& canvas);

/** The names of the ellipsoids, in their colours, below the picture in world axes. */
void appendEllipsoidNames(const Subject& subject, Canvas& canvas);

/** The ends of the body's principal axes, outside of its shape, in the colours of the axes 1, 2 and 3. */
void appendBodyAxes(const Subject& subject, Canvas& canvas);

/** Returns the body's solids or its mesh, in body axes: markers without frames and namespaces. */
std::vector<Marker> shapeOf(const Subject& subject);

/**
 * Returns such a shape once more, in another size, in the world's frame.
 * @param position of its origin [m]. @param attitude body axes → world.
 */
std::vector<Marker> copyOf(std::vector<Marker> shape, const Eigen::Vector3d& position,
                           const Eigen::Quaterniond& attitude, double size);

/** The path that a body flies, and the body as it is at some times on it, where the scene plays in rounds. */
void appendFlight(const Subject& subject, Canvas& canvas);

/** A free body's two ellipsoids, the ends of its axes, and the curves on the ellipsoids, in both pictures. */
void appendConstruction(const Subject& subject, Canvas& canvas);

/**
 * The family of polhodes with the |L| of the start, on the momentum ellipsoid of the picture in body axes: its members
 * in one list of lines (id 0), and the separatrices of that |L| in another (id 1). Where the energy ellipsoid is
 * outside, it hides them. Nothing for three equal moments.
 */
void appendPolhodeFamily(const Subject& subject, Canvas& canvas);

/**
 * What a free body's energy ellipsoid rolls on, in the picture in world axes, and never changes: the invariable plane,
 * the herpolhode on it, and by how much the body turns about L in one period of the polhode (Montgomery's angle).
 *
 * Lines are lifted off the plane by the same factor as a polhode off its ellipsoids, so that the two lines touch where
 * the surfaces do. The angle is told below the picture in body axes, where the polhode is: below the other one the next
 * body's L may stand.
 */
void appendRolling(const Subject& subject, Canvas& canvas);

/**
 * The body cone and the space cone of a free body with two equal moments, in the picture in world axes: mantles whose
 * apex is the centre, with a rim and some lines down to the apex. The one stands still in the body, the other in the
 * world; the first rolls on the second. Nothing for other bodies.
 */
void appendCones(const Subject& subject, Canvas& canvas);

/** L as an arrow in the picture in world axes, where it is constant. */
void appendStillMomentum(const Subject& subject, Canvas& canvas);

/** The pivot of a body on one, and the rod from there to its centre of mass. */
void appendPivot(const Subject& subject, Canvas& canvas);

// What moves.

/** L as an arrow in the picture in world axes; under torques it may vanish. */
void appendMomentum(const Subject& subject, const Now& now, Canvas& canvas);
void appendTorquedMomentum(const Subject& subject, const Now& now, Canvas& canvas);

/** ω as an arrow in the picture in world axes, Ω as a bead in that in body axes. */
void appendSpin(const Subject& subject, const Now& now, Canvas& canvas);

/** The external torque as an arrow from the body's origin, and once more at the tip of L, which moves that way. */
void appendTorque(const Subject& subject, const Now& now, Canvas& canvas);

/** The weight of a body on a pivot as an arrow from its centre of mass. */
void appendWeight(const Subject& subject, const Now& now, Canvas& canvas);

/** The way to the centre of the body's orbit. */
void appendWayToCentre(const Subject& subject, const Now& now, Canvas& canvas);

/** What stands still of the picture of the orbit: the planet and the orbit, neither to scale. */
void appendPlanet(const Subject& subject, Canvas& canvas);

// What moves, and remembers.

/** Below the body's title: its figures, with its method, from the first on; until then the flips of one that flips. */
std::unique_ptr<Part> makeWords(const Subject& subject, const MotionSetup& setup);

/** The newest stretch of the way that Ω of a free body has gone on its polhode, in the picture in body axes. */
std::unique_ptr<Part> makeTrail(const Subject& subject, const Motion& motion);

/**
 * The same under torques, and all of the way before it, in pieces of which the new ones are sent.
 * @param rides on the present momentum ellipsoid: it grows and shrinks with it.
 */
std::unique_ptr<Part> makePath(bool rides);

/**
 * The ellipsoids and curves of the moment under torques, and ω and Ω, which end on them. Nothing of it is there while
 * the body is nearly at rest.
 */
std::unique_ptr<Part> makeTorquedConstruction();

/** In the picture of the orbit, the body on its way round the planet. */
std::unique_ptr<Part> makeOnOrbit(const Subject& subject);

/**
 * The way that the far end of a heavy body's line from the pivot through its centre of mass has gone in the world,
 * where a top draws its loops.
 */
std::unique_ptr<Part> makeWay(const Subject& subject);

// For the layout.

/** How far below the picture in body axes a title is clear of Ω's name, wherever on the polhode that is [radii]. */
double beadSymbolDepth(const Subject& subject);

/** What the layout of the scene needs to know of the body. */
view::BodyExtent extentOf(const Subject& subject, const SceneFacts& scene);

/** The corners of a box that holds a body on a pivot in its first 20 s, or as far as few steps lead. */
std::vector<view::Ball> sweptOnPivot(const Subject& subject, Motion motion);

/** Whether effects turn the body as a whole. One that only moves momentum about inside has no part. */
bool isPushed(const Motion& motion);

}  // namespace poinsot::node::parts
