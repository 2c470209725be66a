#include "poinsot/ros/body_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "poinsot/ros/conversions.h"
#include "poinsot/ros/palette.h"
#include "poinsot/ros/shape_markers.h"
#include "poinsot/view/ellipsoids.h"
#include "poinsot/view/polhode.h"
#include "poinsot/view/separatrix.h"

namespace poinsot::node {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

// Lengths in metres; a picture's ellipsoids reach 1 m.
constexpr double kPolhodeWidth = 0.028;
constexpr double kSeparatrixWidth = 0.012;
constexpr double kTrailWidth = 0.045;
constexpr double kBeadDiameter = 0.10;
constexpr double kShaft = 0.045;
constexpr double kHead = 0.115;
constexpr double kHeadLength = 0.17;
constexpr double kTitleHeight = 0.21;
constexpr double kSymbolHeight = 0.23;
constexpr double kTitleDepth = 1.3;  // of the titles below the centres, at least
constexpr double kFiguresHeight = 0.19;
constexpr double kFiguresDepth = 0.55;    // below the title
const ros::Duration kFiguresPause(0.25);  // a label that changed with every tick could not be read
constexpr double kPointerLength = 0.4;    // of ω's pointer beyond the surface

// A line lies this much outside the surface that it runs on, so as not to sink into it.
constexpr double kPolhodeLift = 1.010;
constexpr double kSeparatrixLift = 1.004;
constexpr double kTrailLift = 1.020;

constexpr double kTrailShare = 0.6;       // of the polhode: a trail that met itself would flicker
constexpr double kStrayTrailShare = 1.5;  // where Ω may leave the polhode, to be seen doing so
constexpr double kTrailSpacing = 0.012;   // m

constexpr double kBesideArrow = 0.17;  // m
constexpr double kBesideBead = 0.22;
constexpr double kBeforeLines = 0.15;                  // towards the viewer
const Eigen::Vector3d kBeforeSurfaces(0.32, 0, 0.14);  // towards a viewer who looks down a little

// Ids within <body>/label.
enum LabelId {
  kBodyTitle,
  kSpaceTitle,
  kModelTitle,
  kMomentumSymbol,
  kOmegaPointer,
  kOmegaSymbol,
  kModelOmegaSymbol,
  kFigures
};

std_msgs::ColorRGBA blend(const std_msgs::ColorRGBA& a, const std_msgs::ColorRGBA& b, float t) {
  return palette::colour(a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b));
}

/**
 * For a viewer at +x: where ω's name stands beside its arrow, on the side away from L; on the right while the two are
 * parallel. It passes quickly, but without a jump, from one side to the other.
 */
Eigen::Vector3d besideOmega(const Eigen::Vector3d& omega_metres, const Eigen::Vector3d& momentum_world) {
  const Eigen::Vector3d l = momentum_world.normalized();
  const double lean = omega_metres.y() - omega_metres.dot(l) * l.y();
  const double side = std::clamp((lean + 0.06) / 0.02, -1.0, 1.0);
  return {kBeforeLines, kBesideArrow * side, 0};
}

/** For a viewer at +x: where Ω's name stands from its bead, outwards and before the ellipsoids; world axes [m]. */
Eigen::Vector3d besideBead(const Eigen::Vector3d& bead) {
  const Eigen::Vector2d outwards = Eigen::Vector2d(bead.y() + 0.04, bead.z() + 0.02).normalized();
  return kBeforeSurfaces + kBesideBead * Eigen::Vector3d(0, outwards.x(), outwards.y());
}

std::string shown(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string methodOf(const MotionSetup& setup) {
  return setup.method + (setup.step ? shown(", step %.3g ms", 1e3 * *setup.step) : "");
}

view::Trail trailOf(const view::Polhode& polhode, double metres_per_radian_per_second, double share) {
  double length = 0;
  if (!polhode.branches.empty()) {
    const std::vector<Eigen::Vector3d>& points = polhode.branches.front().points;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  }
  length *= share * metres_per_radian_per_second;
  return {2 + static_cast<std::size_t>(length / kTrailSpacing), length, kTrailSpacing};
}

}  // namespace

MarkerArray clearedMarkers() {
  MarkerArray out;
  Marker clear;
  clear.action = Marker::DELETEALL;
  // With a frame RViz takes it in turn with the markers; one without counts as failed and is handled out of turn.
  clear.header.frame_id = names::kWorld;
  clear.pose.orientation.w = 1;
  out.markers.push_back(clear);
  return out;
}

BodyPicture::BodyPicture(const scene::Body& body, Motion motion, const names::Frames& frames)
    : name_(body.name),
      frames_(frames),
      start_(motion.at(0)),
      inertia_(body.inertia),
      shape_(body.shape ? *body.shape : shapes::equivalentBox(body.inertia.moments(), body.inertia.axes())),
      method_(methodOf(motion.setup())),
      momentum_is_constant_(motion.conservesMomentum()),
      omega_principal_(inertia_.axes().conjugate() * start_.omega_body),
      polhode_(view::polhode(inertia_.moments(), omega_principal_)),
      layout_(view::layoutOf(start_.position, shape_.boundingRadius(), inertia_.moments(), inertia_.axes(), polhode_,
                             omega_principal_)),
      scale_(view::pictureScale(inertia_.moments(), omega_principal_)),
      trail_(trailOf(polhode_, scale_.metres_per_radian_per_second,
                     motion.inClosedForm() ? kTrailShare : kStrayTrailShare)) {}

Marker BodyPicture::marker(const std::string& ns, int id, int type, const std::string& frame) const {
  Marker out;
  out.header.frame_id = frame;
  out.ns = ns;
  out.id = id;
  out.type = type;
  out.action = Marker::ADD;
  out.pose.orientation.w = 1;
  return out;
}

Marker BodyPicture::text(int id, const std::string& frame, const Eigen::Vector3d& place, const std::string& words,
                         double height) const {
  Marker out = marker(names::markers(name_, names::kLabel), id, Marker::TEXT_VIEW_FACING, frame);
  out.pose.position = toPoint(place);
  out.text = words;
  out.scale.z = height;
  out.color = palette::label();
  return out;
}

Marker BodyPicture::arrow(const std::string& ns, const std::string& frame, const Eigen::Vector3d& tip) const {
  Marker out = marker(ns, 0, Marker::ARROW, frame);
  out.points = {toPoint(Eigen::Vector3d::Zero()), toPoint(tip)};
  out.scale = toVector3({kShaft, kHead, kHeadLength});
  return out;
}

void BodyPicture::appendStatic(MarkerArray& out) const {
  const std::vector<Marker> parts = shapeMarkers(shape_);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Marker part = parts[i];
    part.header.frame_id = frames_.body;
    part.ns = names::markers(name_, names::kShape);
    part.id = static_cast<int>(i);
    part.frame_locked = true;
    out.markers.push_back(part);
  }
  appendTitles(out);
  if (atRest()) return;  // no ellipsoids, no curves, no arrows
  for (const Picture& picture : {Picture{names::kSpace, frames_.space_body}, Picture{names::kModel, frames_.model}}) {
    appendEllipsoids(picture, out);
    appendCurves(picture, out);
  }
  if (momentum_is_constant_) appendMomentum(ros::Time(), start_.momentum_world, out);
}

void BodyPicture::appendEllipsoids(const Picture& picture, MarkerArray& out) const {
  const double metres = scale_.metres_per_radian_per_second;
  const double f = start_.momentum_world.squaredNorm();
  const auto add = [&](const char* what, const Eigen::Vector3d& semi_axes, const std_msgs::ColorRGBA& colour) {
    Marker m = marker(names::markers(name_, picture.name, what), 0, Marker::SPHERE, picture.body_frame);
    m.pose.orientation = toQuaternion(inertia_.axes());
    m.scale = toVector3(2 * metres * semi_axes);  // a SPHERE's scale is its diameter
    m.color = colour;
    m.frame_locked = true;
    out.markers.push_back(m);
  };
  add(names::kEnergyEllipsoid, view::energySemiAxes(inertia_.moments(), start_.kinetic_energy), palette::energy());
  add(names::kMomentumEllipsoid, view::momentumSemiAxes(inertia_.moments(), f), palette::momentumEllipsoid());
}

void BodyPicture::appendCurves(const Picture& picture, MarkerArray& out) const {
  const double metres = scale_.metres_per_radian_per_second;
  const auto add = [&](const char* what, int id, const view::Curve& curve, double lift, double width,
                       const std_msgs::ColorRGBA& colour) {
    const bool is_point = curve.points.size() == 1;  // RViz draws no line through a single point
    Marker m = marker(names::markers(name_, picture.name, what), id,
                      is_point ? Marker::SPHERE_LIST : Marker::LINE_STRIP, picture.body_frame);
    m.pose.orientation = toQuaternion(inertia_.axes());
    for (const Eigen::Vector3d& p : curve.points) m.points.push_back(toPoint(lift * metres * p));
    if (curve.closed && !is_point) m.points.push_back(m.points.front());
    m.scale = is_point ? toVector3(Eigen::Vector3d::Constant(2 * width)) : toVector3({width, 0, 0});
    m.color = colour;
    m.frame_locked = true;
    out.markers.push_back(m);
  };
  for (std::size_t i = 0; i < polhode_.branches.size(); ++i) {
    add(names::kPolhode, static_cast<int>(i), polhode_.branches[i], kPolhodeLift, kPolhodeWidth,
        i == 0 ? palette::polhode() : palette::mirrorPolhode());
  }
  const std::vector<view::Curve> separatrix = view::separatrix(inertia_.moments(), start_.kinetic_energy);
  for (std::size_t i = 0; i < separatrix.size(); ++i) {
    add(names::kSeparatrix, static_cast<int>(i), separatrix[i], kSeparatrixLift, kSeparatrixWidth,
        palette::separatrix());
  }
}

void BodyPicture::appendTitles(MarkerArray& out) const {
  const Eigen::Vector3d down(0, 0, -std::max(kTitleDepth, shape_.boundingRadius() + 0.3));
  out.markers.push_back(text(kBodyTitle, names::kWorld, start_.position + down, name_, kTitleHeight));
  if (atRest()) return;
  out.markers.push_back(text(kSpaceTitle, frames_.space, down, "in world axes", kTitleHeight));
  out.markers.push_back(text(kModelTitle, names::kWorld, layout_.model_centre + down, "in body axes", kTitleHeight));
}

void BodyPicture::appendMomentum(const ros::Time& stamp, const Eigen::Vector3d& momentum_world,
                                 MarkerArray& out) const {
  const Eigen::Vector3d tip = scale_.metres_per_angular_momentum * momentum_world;
  Marker l = arrow(names::markers(name_, names::kSpace, names::kAngularMomentum), frames_.space, tip);
  l.color = palette::angularMomentum();
  Marker symbol = text(kMomentumSymbol, frames_.space, 1.12 * tip, "L", kSymbolHeight);
  symbol.color = palette::angularMomentum();
  l.header.stamp = symbol.header.stamp = stamp;
  out.markers.push_back(l);
  out.markers.push_back(symbol);
}

void BodyPicture::appendFigures(const Tick& tick, const Figures& figures, MarkerArray& out) {
  if (figures_shown_ && tick.stamp >= *figures_shown_ && tick.stamp < *figures_shown_ + kFiguresPause) return;
  figures_shown_ = tick.stamp;
  const std::string words = method_ + shown("\nattitude error %.1e rad", figures.attitude_error) +
                            shown("\nenergy drift %+.1e", figures.energy_drift) +
                            (std::isnan(figures.cost) ? "" : shown("\ncost %.3g us per s", 1e6 * figures.cost));
  const double down = std::max(kTitleDepth, shape_.boundingRadius() + 0.3) + kFiguresDepth;
  Marker label = text(kFigures, names::kWorld, start_.position - Eigen::Vector3d(0, 0, down), words, kFiguresHeight);
  label.header.stamp = tick.stamp;
  out.markers.push_back(label);
}

void BodyPicture::appendMoving(const Tick& tick, const MotionState& state, MarkerArray& out) {
  if (atRest()) return;
  const std::size_t first = out.markers.size();
  const double metres = scale_.metres_per_radian_per_second;
  const Eigen::Vector3d in_space = metres * state.omega_world;
  const Eigen::Vector3d in_model = metres * state.omega_body;

  Marker omega = arrow(names::markers(name_, names::kSpace, names::kOmega), frames_.space, in_space);
  omega.color = palette::omega();
  out.markers.push_back(omega);

  // The arrow ends on the surface, where its own ellipsoids hide it: a pointer leads on to its name.
  const Eigen::Vector3d outwards = in_space.normalized();
  Marker pointer = marker(names::markers(name_, names::kLabel), kOmegaPointer, Marker::ARROW, frames_.space);
  pointer.points = {toPoint(in_space), toPoint(in_space + kPointerLength * outwards)};
  pointer.scale = toVector3({kShaft, kHead, kHeadLength});
  pointer.color = palette::omega();
  out.markers.push_back(pointer);
  Marker symbol = text(kOmegaSymbol, frames_.space,
                       in_space + (kPointerLength + 0.1) * outwards + besideOmega(in_space, state.momentum_world),
                       "\xCF\x89", kSymbolHeight);
  symbol.color = palette::omega();
  out.markers.push_back(symbol);

  Marker bead = marker(names::markers(name_, names::kModel, names::kOmega), 0, Marker::SPHERE, frames_.model);
  bead.pose.position = toPoint(in_model);
  bead.scale = toVector3(Eigen::Vector3d::Constant(kBeadDiameter));
  bead.color = palette::omega();
  out.markers.push_back(bead);
  Marker bead_symbol =
      text(kModelOmegaSymbol, frames_.model,
           in_model + layout_.model_orientation.conjugate() * besideBead(layout_.model_orientation * in_model),
           "\xCE\xA9", kSymbolHeight);
  bead_symbol.color = palette::omega();
  out.markers.push_back(bead_symbol);

  trail_.add(kTrailLift * in_model);
  if (trail_.size() >= 2) {
    Marker trail = marker(names::markers(name_, names::kTrail), 0, Marker::LINE_STRIP, frames_.model);
    for (std::size_t i = 0; i < trail_.size(); ++i) {
      trail.points.push_back(toPoint(trail_[i]));
      const float age = 1 - static_cast<float>(i + 1) / static_cast<float>(trail_.size());
      trail.colors.push_back(blend(palette::omega(), palette::polhode(), age));
    }
    trail.scale.x = kTrailWidth;
    trail.color = palette::omega();
    out.markers.push_back(trail);
    trail_shown_ = true;
  } else if (trail_shown_) {
    // After a jump the old trail would stay where it was.
    Marker none = marker(names::markers(name_, names::kTrail), 0, Marker::LINE_STRIP, frames_.model);
    none.action = Marker::DELETE;
    trail_shown_ = false;
    out.markers.push_back(none);
  }
  if (!momentum_is_constant_) appendMomentum(tick.stamp, state.momentum_world, out);
  for (std::size_t i = first; i < out.markers.size(); ++i) out.markers[i].header.stamp = tick.stamp;
}

}  // namespace poinsot::node
