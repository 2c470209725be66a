#include "poinsot/ros/markers/palette.h"

#include <algorithm>
#include <cmath>

namespace poinsot::node::palette {
namespace {

constexpr double kContrast = 4.6;
constexpr double kDarkLuminance = 0.0114, kLightLuminance = 0.857;  // of (24, 28, 36) and of (236, 239, 244)
constexpr float kStep = 0.02f;

double linear(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/** Relative luminance, WCAG 2.1. */
double luminance(const std_msgs::ColorRGBA& c) {
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

}  // namespace

std_msgs::ColorRGBA asText(const std_msgs::ColorRGBA& colour, bool light_background) {
  const float end = light_background ? 0 : 1;
  const auto contrast = [&](const std_msgs::ColorRGBA& c) {
    return light_background ? (kLightLuminance + 0.05) / (luminance(c) + 0.05)
                            : (luminance(c) + 0.05) / (kDarkLuminance + 0.05);
  };
  std_msgs::ColorRGBA out = colour;
  for (float share = kStep; contrast(out) < kContrast && share <= 1; share += kStep) {
    out.r = colour.r + share * (end - colour.r);
    out.g = colour.g + share * (end - colour.g);
    out.b = colour.b + share * (end - colour.b);
  }
  return out;
}

}  // namespace poinsot::node::palette
