#include "poinsot/ros/family_markers.h"

#include <vector>

#include "poinsot/ros/conversions.h"
#include "poinsot/ros/palette.h"
#include "poinsot/view/polhode_family.h"

namespace poinsot::node {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kLift = 1.005;  // a line's middle lies deeper than its ends
constexpr double kMemberWidth = 0.008;

Marker linesOf(const MarkerFactory& factory, int id, const PrincipalInertia& inertia,
               const std::vector<view::Curve>& curves, double metres, double width, const std_msgs::ColorRGBA& colour) {
  Marker m =
      factory.marker(factory.ns(names::kModel, names::kPolhodeFamily), id, Marker::LINE_LIST, factory.frames().model);
  m.pose.orientation = toQuaternion(inertia.axes());
  for (const view::Curve& curve : curves) {
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      m.points.push_back(toPoint(kLift * metres * curve.points[i]));
      m.points.push_back(toPoint(kLift * metres * curve.points[(i + 1) % curve.points.size()]));
    }
  }
  m.scale.x = width;
  m.color = colour;
  m.frame_locked = true;
  return m;
}

}  // namespace

void appendFamily(const MarkerFactory& factory, const PrincipalInertia& inertia, const Eigen::Vector3d& omega_principal,
                  double metres, MarkerArray& out) {
  const view::PolhodeFamily family = view::polhodeFamily(inertia.moments(), omega_principal);
  if (!family.members.empty()) {
    out.markers.push_back(linesOf(factory, 0, inertia, family.members, metres, kMemberWidth, palette::polhodeFamily()));
  }
  if (!family.separatrix.empty()) {
    out.markers.push_back(
        linesOf(factory, 1, inertia, family.separatrix, metres, kSeparatrixWidth, palette::separatrix()));
  }
}

}  // namespace poinsot::node
