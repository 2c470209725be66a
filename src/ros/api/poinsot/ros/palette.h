#pragma once

#include <std_msgs/ColorRGBA.h>

/**
 * What each colour means, the same in every picture; told apart by the colour-blind too (after Okabe and Ito), and on
 * dark and light backgrounds: by WCAG's measure text has a contrast of 3:1 to either, arrows and lines that leave the
 * ellipsoids 2:1. So they are of middling brightness. White and pale lines stay on the ellipsoids.
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

inline std_msgs::ColorRGBA energy() {
  return colour(0.95f, 0.62f, 0.05f);
}
inline std_msgs::ColorRGBA momentumEllipsoid() {
  return colour(0.10f, 0.42f, 0.80f);
}
inline std_msgs::ColorRGBA polhode() {
  return colour(1, 1, 1);
}
inline std_msgs::ColorRGBA mirrorPolhode() {
  return colour(0.72f, 0.74f, 0.78f);
}
inline std_msgs::ColorRGBA separatrix() {
  return colour(0.18f, 0.20f, 0.24f);
}
inline std_msgs::ColorRGBA omega() {
  return colour(0.93f, 0.13f, 0.47f);
}
inline std_msgs::ColorRGBA angularMomentum() {
  return colour(0.06f, 0.56f, 0.38f);
}
inline std_msgs::ColorRGBA polhodeFamily() {
  return colour(0.62f, 0.80f, 0.97f);
}
inline std_msgs::ColorRGBA invariablePlane() {
  return translucent(colour(0.56f, 0.62f, 0.68f), 0.35f);
}
inline std_msgs::ColorRGBA bodyCone() {
  return translucent(colour(0.80f, 0.36f, 0.22f), 0.30f);
}
inline std_msgs::ColorRGBA spaceCone() {
  return translucent(angularMomentum(), 0.30f);
}
/** Where Ω came from, under torques. */
inline std_msgs::ColorRGBA path() {
  return colour(0.90f, 0.50f, 0.68f);
}
inline std_msgs::ColorRGBA torque() {
  return colour(0.62f, 0.49f, 0.02f);
}
inline std_msgs::ColorRGBA gravity() {
  return colour(0.16f, 0.51f, 0.74f);
}
inline std_msgs::ColorRGBA pivot() {
  return colour(0.60f, 0.61f, 0.64f);
}
inline std_msgs::ColorRGBA label() {
  return colour(0.47f, 0.50f, 0.54f);
}

/** Parts of a body in turn, so that one can see it turn. */
inline std_msgs::ColorRGBA part(int index) {
  switch (index % 3) {
    case 0:
      return colour(0.62f, 0.66f, 0.71f);
    case 1:
      return colour(0.88f, 0.89f, 0.90f);
    default:
      return colour(0.80f, 0.36f, 0.22f);
  }
}

}  // namespace poinsot::node::palette
