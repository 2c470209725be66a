#pragma once

#include <std_msgs/ColorRGBA.h>

/**
 * What each colour means, the same in every picture; told apart by the colour-blind too (after Okabe and Ito), and on
 * dark and light backgrounds: by WCAG's measure arrows and lines that leave the ellipsoids have a contrast of 2:1 to
 * either, so they are of middling brightness. White and pale lines stay on the ellipsoids. Letters: asText().
 */
namespace poinsot::node::palette {

inline std_msgs::ColorRGBA colour(float r, float g, float b) {
  std_msgs::ColorRGBA c;
  c.r = r;
  c.g = g;
  c.b = b;
  c.a = 1;
  return c;
}

inline std_msgs::ColorRGBA translucent(std_msgs::ColorRGBA c, float alpha) {
  c.a = alpha;
  return c;
}

inline const std_msgs::ColorRGBA kEnergy = colour(0.95f, 0.62f, 0.05f);
inline const std_msgs::ColorRGBA kMomentumEllipsoid = colour(0.10f, 0.42f, 0.80f);
inline const std_msgs::ColorRGBA kPolhode = colour(1, 1, 1);
inline const std_msgs::ColorRGBA kMirrorPolhode = colour(0.72f, 0.74f, 0.78f);
inline const std_msgs::ColorRGBA kSeparatrix = colour(0.18f, 0.20f, 0.24f);
inline const std_msgs::ColorRGBA kOmega = colour(0.93f, 0.13f, 0.47f);
inline const std_msgs::ColorRGBA kAngularMomentum = colour(0.06f, 0.56f, 0.38f);
inline const std_msgs::ColorRGBA kPolhodeFamily = colour(0.62f, 0.80f, 0.97f);
inline const std_msgs::ColorRGBA kInvariablePlane = translucent(colour(0.56f, 0.62f, 0.68f), 0.35f);
inline const std_msgs::ColorRGBA kBodyCone = translucent(colour(0.80f, 0.36f, 0.22f), 0.30f);
inline const std_msgs::ColorRGBA kSpaceCone = translucent(kAngularMomentum, 0.30f);
/** Where Ω came from, under torques. */
inline const std_msgs::ColorRGBA kPath = colour(0.90f, 0.50f, 0.68f);
inline const std_msgs::ColorRGBA kTorque = colour(0.62f, 0.49f, 0.02f);
inline const std_msgs::ColorRGBA kGravity = colour(0.16f, 0.51f, 0.74f);
inline const std_msgs::ColorRGBA kPivot = colour(0.60f, 0.61f, 0.64f);
inline const std_msgs::ColorRGBA kLabel = colour(0.47f, 0.50f, 0.54f);

inline const std_msgs::ColorRGBA kMomentumName = colour(0.38f, 0.62f, 0.95f);  ///< as text, brighter
/** The principal axes in order of the scene, as in the panel's plots. */
inline const std_msgs::ColorRGBA kAxes[] = {colour(0.91f, 0.31f, 0.36f), colour(0.37f, 0.75f, 0.29f),
                                            colour(0.34f, 0.77f, 0.91f)};
inline const std_msgs::ColorRGBA kPlanet = colour(0.22f, 0.45f, 0.62f);
inline const std_msgs::ColorRGBA kFlight = colour(0.47f, 0.50f, 0.54f);

/** Parts of a body in turn, so that one can see it turn. */
inline const std_msgs::ColorRGBA kParts[] = {colour(0.62f, 0.66f, 0.71f), colour(0.88f, 0.89f, 0.90f),
                                             colour(0.80f, 0.36f, 0.22f)};

/**
 * Returns the colour lightened, or darkened for a light background, as far as letters need to be read: to a contrast of
 * 4.5 : 1, as WCAG 2.1 (AA) measures it, to the dark or the light background of the panel.
 */
std_msgs::ColorRGBA asText(const std_msgs::ColorRGBA& colour, bool light_background);

}  // namespace poinsot::node::palette
