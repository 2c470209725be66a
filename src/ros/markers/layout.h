#pragma once

/**
 * How the parts of a picture stand to each other, in one place. Lengths are in radii of the picture, which its
 * ellipsoids reach, unless something else is said. Above, beside and before are meant for a viewer at +x.
 */
namespace poinsot::node::layout {

// The viewer, as the overview of one body has him.
constexpr double kViewerDistance = 7;  // about
constexpr double kLooksDown = 0.31;    // by so much for each unit
constexpr double kLooksAside = 0.37;   // likewise, at the picture in body axes, as he looks straight at the other

// Heights of letters. Names of arrows are the largest; what is long is smaller, so that it stays beside its neighbours.
constexpr double kSymbolHeight = 0.23;
constexpr double kTitleHeight = 0.21;
constexpr double kFiguresHeight = 0.17;
constexpr double kFlipsHeight = 0.17;
constexpr double kTurnHeight = 0.17;

// Titles of pictures stand below their centres: below the ellipsoids, and the name of Ω wherever that may come.
constexpr double kTitleDepth = 1.4;                                          // at least
constexpr double kBelowSymbol = 0.5 * (kSymbolHeight + kTitleHeight) + 0.2;  // from middle to middle

// Middles of texts below the title, of which there is one at a time below a centre. A text that is lower by its depth
// for the viewer stands nearer to him by so much, and lower by this share of it: one who looks from above sees it
// apart, too.
constexpr double kFallPerDepth = 1;
constexpr double kFiguresDepth = 0.14;  // the upper edge of the figures, and for each line of them:
constexpr double kFiguresDepthALine = 0.108;
constexpr double kFlipsDepth = 0.3;
constexpr double kNamesDepth = 0.3;  // of the ellipsoids
constexpr double kNamesHeight = 0.18;
constexpr double kNamesApart = 0.5;  // from the middle
constexpr double kTurnDepth = 0.38;  // two lines

// Lines on the ellipsoids lie outside them, so as not to sink into them; the higher one covers the lower. A factor of
// Ω-space where the surface is that of a free body; under torques, where it may be long and thin, along the normal.
constexpr double kSeparatrixLift = 1.004;
constexpr double kFamilyLift = 1.005;
constexpr double kPolhodeLift = 1.010;
constexpr double kTrailLift = 1.020;
constexpr double kPathHeight = 0.016;
constexpr double kTorquedTrailHeight = 0.026;

// How many points a curve has: the middle of a chord of a circle of 1 is so far inside it.
constexpr int kPolhodePoints = 64;     // 0.001
constexpr int kSeparatrixPoints = 48;  // 0.002

// Their widths. What Ω does now is the widest.
constexpr double kBeadDiameter = 0.10;
constexpr double kStubWidth = 0.022;
constexpr double kAxisWidth = 0.035;
constexpr double kTrailWidth = 0.045;
constexpr double kPolhodeWidth = 0.028;
constexpr double kPathWidth = 0.018;
constexpr double kSeparatrixWidth = 0.012;
constexpr double kFamilyWidth = 0.008;

// The pointer from the tip of ω, which is on the ellipsoids, to its name; and where names stand from tips and beads.
constexpr double kPointerLength = 0.3;
constexpr double kBeyondPointer = 0.1;
constexpr double kBesideArrow = 0.24;
constexpr double kBesideBead = 0.28;
constexpr double kBesideTorque = 0.25;    // of L, on the other side of the torque's arrow
constexpr double kBesideEffect = 0.16;    // of the arrows of effects
constexpr double kBeforeLines = 0.15;     // towards the viewer
constexpr double kBeforeSurfaces = 0.45;  // so that no ellipsoid hides it

// Arrows of effects begin inside the body, and end beyond it.
constexpr double kTorqueBeyond = 0.3;      // the largest torque's
constexpr double kTorqueAtMomentum = 0.7;  // all of the largest torque's at the tip of L
constexpr double kWeightBeyond = 0.1;
constexpr double kOrbitBeyond = 0.3;

// What is smaller is not drawn.
constexpr double kLeastPicture = 0.002;   // the longest semi-axis: a body nearly at rest has nothing to look at
constexpr double kLeastMomentum = 0.005;  // L's arrow
constexpr double kLeastTorque = 0.01;

}  // namespace poinsot::node::layout
