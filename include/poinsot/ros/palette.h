#pragma once

#include <std_msgs/ColorRGBA.h>

/** What each colour means, the same in every picture; told apart by the colour-blind too (after Okabe and Ito). */
namespace poinsot::node::palette {

inline std_msgs::ColorRGBA colour(float r, float g, float b) {
  std_msgs::ColorRGBA c;
  c.r = r;
  c.g = g;
  c.b = b;
  c.a = 1;
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
  return colour(0.20f, 0.78f, 0.55f);
}
/** Where Ω came from, under torques. */
inline std_msgs::ColorRGBA path() {
  return colour(1, 0.70f, 0.84f);
}
inline std_msgs::ColorRGBA torque() {
  return colour(0.96f, 0.90f, 0.25f);
}
inline std_msgs::ColorRGBA gravity() {
  return colour(0.40f, 0.76f, 0.96f);
}
inline std_msgs::ColorRGBA pivot() {
  return colour(0.86f, 0.87f, 0.90f);
}
inline std_msgs::ColorRGBA label() {
  return colour(0.93f, 0.94f, 0.96f);
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
