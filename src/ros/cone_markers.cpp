#include "poinsot/ros/cone_markers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "poinsot/ros/conversions.h"
#include "poinsot/ros/palette.h"
#include "poinsot/view/cones.h"
#include "poinsot/view/herpolhode.h"

namespace poinsot::node {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr int kFacets = 48;
constexpr int kFacetsPerLine = 4;
constexpr double kBeyond = 0.45;  // m, of the mantles beyond the tip of ω, which is on the ellipsoids
constexpr double kLineWidth = 0.012;

/** A mantle (id 0), and its rim and lines down it, by which one sees it roll (id 1); about `axis`, through `contact`.
 */
void appendCone(const MarkerFactory& factory, const char* what, const std::string& frame,
                const Eigen::Quaterniond& orientation, const Eigen::Vector3d& axis, const Eigen::Vector3d& contact,
                const std_msgs::ColorRGBA& colour, MarkerArray& out) {
  const std::string ns = factory.ns(names::kSpace, what);
  Marker mantle = factory.marker(ns, 0, Marker::TRIANGLE_LIST, frame);
  Marker lines = factory.marker(ns, 1, Marker::LINE_LIST, frame);
  const geometry_msgs::Point apex = toPoint(Eigen::Vector3d::Zero());
  const auto rim = [&](int i) { return toPoint(Eigen::AngleAxisd(2 * M_PI * i / kFacets, axis) * contact); };
  for (int i = 0; i < kFacets; ++i) {
    for (const geometry_msgs::Point& p : {apex, rim(i), rim(i + 1)}) mantle.points.push_back(p);
    for (const geometry_msgs::Point& p : {rim(i), rim(i + 1)}) lines.points.push_back(p);
    if (i % kFacetsPerLine > 0) continue;
    for (const geometry_msgs::Point& p : {apex, rim(i)}) lines.points.push_back(p);
  }
  mantle.scale = toVector3({1, 1, 1});
  mantle.color = colour;
  makeUnlit(mantle);
  lines.scale.x = kLineWidth;
  lines.color = palette::translucent(colour, 1);
  for (Marker* m : {&mantle, &lines}) {
    m->pose.orientation = toQuaternion(orientation);
    m->frame_locked = true;
    out.markers.push_back(*m);
  }
}

}  // namespace

void appendCones(const MarkerFactory& factory, const ClosedForm& motion, const PrincipalInertia& inertia, double metres,
                 MarkerArray& out) {
  const ClosedForm::State start = motion.at(0);
  const std::optional<view::Cones> cones = view::cones(inertia.moments(), start.omega_principal);
  if (!cones) return;
  const Eigen::Vector3d tip = metres * start.omega_principal;
  const Eigen::Vector3d contact = tip + kBeyond * tip.normalized();
  appendCone(factory, names::kBodyCone, factory.frames().space_body, inertia.axes(), cones->body_axis, contact,
             palette::bodyCone(), out);
  appendCone(factory, names::kSpaceCone, factory.frames().space, Eigen::Quaterniond::Identity(),
             view::invariablePlane(motion).normal, start.attitude * contact, palette::spaceCone(), out);
}

}  // namespace poinsot::node
