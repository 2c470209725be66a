#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "markers/layout.h"
#include "markers/parts.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/markers/palette.h"
#include "poinsot/view/cones.h"
#include "poinsot/view/herpolhode.h"

namespace poinsot::node::parts {
namespace {

// Lengths in radii of the picture.
constexpr double kLeastPlaneRadius = 0.5;
constexpr double kBeyondHerpolhode = 0.22;
constexpr double kHerpolhodeWidth = 0.009;
constexpr double kPointDiameter = 0.05;
constexpr double kArcWidth = 0.018;
constexpr double kArcBeyond = 0.09;  // outside the herpolhode
constexpr double kArcSpacing = 0.1;  // rad
constexpr double kLeastHerpolhode = 0.02;
constexpr int kDiscPieces = 40;
constexpr double kDegree = 0.01745329251994329577;
constexpr double kWholeTurn = 360 * kDegree;

// Of the cones.
constexpr int kFacets = 48;
constexpr int kFacetsPerLine = 4;
constexpr double kConeBeyond = 0.45;  // of the mantles beyond the tip of ω, which is on the ellipsoids
constexpr double kConeLineWidth = 0.012;

/** Whole turns and the rest, in words. */
std::string turnsAboutMomentum(double angle) {
  const double whole = std::max(0.0, std::floor(angle / kWholeTurn));
  return "one round of the polhode:\n" + (whole > 0 ? formatted("%.0f \xC3\x97 360\xC2\xB0 + ", whole) : "") +
         formatted("%.1f\xC2\xB0 about L", (angle - whole * kWholeTurn) / kDegree);
}

Marker discOf(const Subject& subject, const view::InvariablePlane& plane, double radius) {
  const MarkerFactory& factory = subject.factory;
  Marker m = locked(factory.marker(factory.ns(names::kSpace, names::kInvariablePlane), 0, Marker::TRIANGLE_LIST,
                                   factory.frames().space, {1, 1, 1}, palette::kInvariablePlane));
  m.pose.position = toPoint(subject.radii() * plane.distance * plane.normal);
  m.pose.orientation = toQuaternion(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), plane.normal));
  const auto rim = [radius](int i) {
    const double angle = kWholeTurn * i / kDiscPieces;
    return toPoint({radius * std::cos(angle), radius * std::sin(angle), 0});
  };
  for (int i = 0; i < kDiscPieces; ++i) {
    for (const geometry_msgs::Point& p : {toPoint(Eigen::Vector3d::Zero()), rim(i), rim(i + 1)}) m.points.push_back(p);
  }
  makeUnlit(m);
  return m;
}

/** A mantle (id 0), and its rim and lines down it, by which one sees it roll (id 1); about `axis`, through `contact`.
 */
void appendCone(const MarkerFactory& factory, const char* what, const std::string& frame,
                const Eigen::Quaterniond& orientation, const Eigen::Vector3d& axis, const Eigen::Vector3d& contact,
                const std_msgs::ColorRGBA& colour, Canvas& canvas) {
  const std::string ns = factory.ns(names::kSpace, what);
  Marker mantle = locked(factory.marker(ns, 0, Marker::TRIANGLE_LIST, frame, {1, 1, 1}, colour));
  Marker lines =
      locked(factory.marker(ns, 1, Marker::LINE_LIST, frame, {kConeLineWidth, 0, 0}, palette::translucent(colour, 1)));
  mantle.pose.orientation = lines.pose.orientation = toQuaternion(orientation);
  const geometry_msgs::Point apex = toPoint(Eigen::Vector3d::Zero());
  const auto rim = [&](int i) { return toPoint(Eigen::AngleAxisd(2 * M_PI * i / kFacets, axis) * contact); };
  for (int i = 0; i < kFacets; ++i) {
    for (const geometry_msgs::Point& p : {apex, rim(i), rim(i + 1)}) mantle.points.push_back(p);
    for (const geometry_msgs::Point& p : {rim(i), rim(i + 1)}) lines.points.push_back(p);
    if (i % kFacetsPerLine > 0) continue;
    for (const geometry_msgs::Point& p : {apex, rim(i)}) lines.points.push_back(p);
  }
  makeUnlit(mantle);
  canvas.put(mantle);
  canvas.put(lines);
}

}  // namespace

void appendRolling(const Subject& subject, Canvas& canvas) {
  const ClosedForm& motion = *subject.closed_form;
  const view::InvariablePlane plane = view::invariablePlane(motion);
  if (plane.normal.isZero(0)) return;
  const MarkerFactory& factory = subject.factory;
  const std::string& space = factory.frames().space;
  const double metres = subject.radii();
  const view::Herpolhode herpolhode = view::herpolhode(motion);
  const double outer = metres * herpolhode.outer;
  canvas.put(discOf(subject, plane, std::max(kLeastPlaneRadius, outer + kBeyondHerpolhode)));
  canvas.put(factory.curve(factory.ns(names::kSpace, names::kHerpolhode), 0, space, herpolhode.curve,
                           layout::kPolhodeLift * metres, kHerpolhodeWidth, kPointDiameter, palette::kOmega));

  const double angle = motion.montgomeryAngle();
  if (!std::isfinite(angle)) return;
  const view::BodyPlace& place = subject.frame.place;
  // Without a title, the words take its place.
  const bool has_title = place.titles != view::PictureTitles::none;
  const double title_depth = place.picture_title_depth - (has_title ? 0 : layout::kTurnDepth * subject.unit());
  Marker words =
      factory.text(kTurn, names::kWorld, subject.belowTitle(place.model_centre, title_depth, layout::kTurnDepth),
                   turnsAboutMomentum(angle), layout::kTurnHeight, palette::kAngularMomentum);
  words.frame_locked = true;
  canvas.put(words);
  if (outer < kLeastHerpolhode) return;

  const double rest = std::fmod(angle, kWholeTurn);
  const ClosedForm::State state = motion.at(herpolhode.start);
  const Eigen::Vector3d foot = metres * plane.distance * plane.normal;
  const Eigen::Vector3d spoke = metres * (state.attitude * state.omega_principal) - foot;
  const Eigen::Vector3d rim = (1 + kArcBeyond / outer) * (spoke - spoke.dot(plane.normal) * plane.normal);
  Marker sector = locked(factory.marker(factory.ns(names::kSpace, names::kMontgomery), 0, Marker::LINE_STRIP, space,
                                        {kArcWidth, 0, 0}, palette::kAngularMomentum));
  const auto add = [&](const Eigen::Vector3d& p) { sector.points.push_back(toPoint(layout::kPolhodeLift * p)); };
  const int pieces = std::max(1, static_cast<int>(std::ceil(rest / kArcSpacing)));
  add(foot);
  for (int i = 0; i <= pieces; ++i) add(foot + Eigen::AngleAxisd(rest * i / pieces, plane.normal) * rim);
  add(foot);
  canvas.put(sector);
}

void appendCones(const Subject& subject, Canvas& canvas) {
  const ClosedForm& motion = *subject.closed_form;
  const ClosedForm::State start = motion.at(0);
  const std::optional<view::Cones> cones = view::cones(subject.inertia.moments(), start.omega_principal);
  if (!cones) return;
  const Eigen::Vector3d tip = subject.radii() * start.omega_principal;
  const Eigen::Vector3d contact = tip + kConeBeyond * tip.normalized();
  const MarkerFactory& factory = subject.factory;
  appendCone(factory, names::kBodyCone, factory.frames().space_body, subject.inertia.axes(), cones->body_axis, contact,
             palette::kBodyCone, canvas);
  appendCone(factory, names::kSpaceCone, factory.frames().space, Eigen::Quaterniond::Identity(),
             view::invariablePlane(motion).normal, start.attitude * contact, palette::kSpaceCone, canvas);
}

}  // namespace poinsot::node::parts
