#include "poinsot/ros/rolling_markers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "poinsot/ros/conversions.h"
#include "poinsot/ros/palette.h"
#include "poinsot/view/herpolhode.h"

namespace poinsot::node {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

// Lengths in metres.
constexpr double kLeastPlaneRadius = 0.5;
constexpr double kBeyondHerpolhode = 0.22;
constexpr double kHerpolhodeWidth = 0.009;
constexpr double kPointDiameter = 0.05;
constexpr double kArcWidth = 0.018;
constexpr double kArcBeyond = 0.09;  // outside the herpolhode
constexpr double kArcSpacing = 0.1;  // rad
constexpr double kLeastHerpolhode = 0.02;
constexpr double kTurnHeight = 0.17;
constexpr int kDiscPieces = 40;
constexpr double kDegree = 0.01745329251994329577;
constexpr double kWholeTurn = 360 * kDegree;

/** Whole turns and the rest, in words. */
std::string turnsAboutMomentum(double angle) {
  const double whole = std::floor(angle / kWholeTurn);
  char text[128];
  if (whole > 0) {
    std::snprintf(text, sizeof text, "one round of the polhode:\n%.0f \xC3\x97 360\xC2\xB0 + %.1f\xC2\xB0 about L",
                  whole, (angle - whole * kWholeTurn) / kDegree);
  } else {
    std::snprintf(text, sizeof text, "one round of the polhode:\n%.1f\xC2\xB0 about L", angle / kDegree);
  }
  return text;
}

Marker discOf(const MarkerFactory& factory, const view::InvariablePlane& plane, double metres, double radius) {
  Marker m = factory.marker(factory.ns(names::kSpace, names::kInvariablePlane), 0, Marker::TRIANGLE_LIST,
                            factory.frames().space);
  m.pose.position = toPoint(metres * plane.distance * plane.normal);
  m.pose.orientation = toQuaternion(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), plane.normal));
  const auto rim = [radius](int i) {
    const double angle = kWholeTurn * i / kDiscPieces;
    return toPoint({radius * std::cos(angle), radius * std::sin(angle), 0});
  };
  for (int i = 0; i < kDiscPieces; ++i) {
    m.points.push_back(toPoint(Eigen::Vector3d::Zero()));
    m.points.push_back(rim(i));
    m.points.push_back(rim(i + 1));
  }
  m.scale = toVector3({1, 1, 1});
  m.color = palette::invariablePlane();
  makeUnlit(m);
  m.frame_locked = true;
  return m;
}

}  // namespace

void appendRolling(const MarkerFactory& factory, const ClosedForm& motion, double metres,
                   const Eigen::Vector3d& words_place, MarkerArray& out) {
  const view::InvariablePlane plane = view::invariablePlane(motion);
  if (plane.normal.isZero(0)) return;
  const view::Herpolhode herpolhode = view::herpolhode(motion);
  const double outer = metres * herpolhode.outer;
  out.markers.push_back(discOf(factory, plane, metres, std::max(kLeastPlaneRadius, outer + kBeyondHerpolhode)));

  const std::vector<Eigen::Vector3d>& points = herpolhode.curve.points;
  const bool is_point = points.size() == 1;
  Marker curve = factory.marker(factory.ns(names::kSpace, names::kHerpolhode), 0,
                                is_point ? Marker::SPHERE_LIST : Marker::LINE_STRIP, factory.frames().space);
  for (const Eigen::Vector3d& p : points) curve.points.push_back(toPoint(kPolhodeLift * metres * p));
  if (herpolhode.curve.closed) curve.points.push_back(curve.points.front());
  curve.scale = is_point ? toVector3(Eigen::Vector3d::Constant(kPointDiameter)) : toVector3({kHerpolhodeWidth, 0, 0});
  curve.color = palette::omega();
  curve.frame_locked = true;
  out.markers.push_back(curve);

  const double angle = motion.montgomeryAngle();
  if (!std::isfinite(angle)) return;
  const Eigen::Vector3d foot = metres * plane.distance * plane.normal;
  Marker words = factory.text(kTurn, names::kWorld, words_place, turnsAboutMomentum(angle), kTurnHeight);
  words.color = palette::angularMomentum();
  words.frame_locked = true;
  out.markers.push_back(words);
  if (outer < kLeastHerpolhode) return;

  const double rest = std::fmod(angle, kWholeTurn);
  const ClosedForm::State state = motion.at(herpolhode.start);
  const Eigen::Vector3d spoke = metres * (state.attitude * state.omega_principal) - foot;
  const Eigen::Vector3d rim = (1 + kArcBeyond / outer) * (spoke - spoke.dot(plane.normal) * plane.normal);
  Marker sector =
      factory.marker(factory.ns(names::kSpace, names::kMontgomery), 0, Marker::LINE_STRIP, factory.frames().space);
  const auto add = [&](const Eigen::Vector3d& p) { sector.points.push_back(toPoint(kPolhodeLift * p)); };
  const int pieces = std::max(1, static_cast<int>(std::ceil(rest / kArcSpacing)));
  add(foot);
  for (int i = 0; i <= pieces; ++i) add(foot + Eigen::AngleAxisd(rest * i / pieces, plane.normal) * rim);
  add(foot);
  sector.scale.x = kArcWidth;
  sector.color = palette::angularMomentum();
  sector.frame_locked = true;
  out.markers.push_back(sector);
}

}  // namespace poinsot::node
