#include "scene_views.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include "poinsot/ros/names.h"
#include "poinsot/view/camera.h"

namespace poinsot::rviz_panel::scene_views {
namespace {

namespace names = node::names;

// Distances in radii of the picture.
constexpr double kRidingDistance = 4.7, kAlongDistance = 4.2;
constexpr double kRidingX = -0.80, kRidingY = 0.42, kRidingZ = 0.42;  // direction of the eye from the centre
constexpr double kNear = 0.01, kRidingNear = 1.5, kAlongNear = 2.3;

rviz::Config view(const char* kind, const char* name, const std::string& frame, double near) {
  rviz::Config out;
  out.mapSetValue("Class", kind);
  out.mapSetValue("Name", name);
  out.mapSetValue("Target Frame", QString::fromStdString(frame));
  out.mapSetValue("Near Clip Distance", near);
  return out;
}

void setVector(rviz::Config& view, const char* key, double x, double y, double z) {
  rviz::Config vector = view.mapMakeChild(key);
  vector.mapSetValue("X", x);
  vector.mapSetValue("Y", y);
  vector.mapSetValue("Z", z);
}

rviz::Config orbit(const char* name, const std::string& frame, double distance, const Eigen::Vector3d& focal,
                   double pitch, double near) {
  rviz::Config out = view("rviz/Orbit", name, frame, near);
  out.mapSetValue("Distance", distance);
  out.mapSetValue("Pitch", pitch);
  out.mapSetValue("Yaw", 0);
  setVector(out, "Focal Point", focal.x(), focal.y(), focal.z());
  return out;
}

/** Appends the namespaces of a body's markers, but those of the picture in world axes where that is shown. */
void appendNamespaces(const std::string& body, bool is_shown, rviz::Config list) {
  const auto append = [&](const std::string& ns) { list.listAppendNew().setValue(QString::fromStdString(ns)); };
  for (const char* what : {names::kShape, names::kTrail, names::kLabel, names::kTorque, names::kGravity, names::kAxes,
                           names::kPath, names::kGhosts, names::kOrbit}) {
    append(names::markers(body, what));
  }
  for (const char* picture : {names::kModel, names::kSpace}) {
    if (picture == names::kSpace && is_shown) continue;
    for (const char* what :
         {names::kEnergyEllipsoid, names::kMomentumEllipsoid, names::kOmega, names::kPolhode, names::kSeparatrix,
          names::kAxes, names::kAngularMomentum, names::kHerpolhode, names::kInvariablePlane, names::kMontgomery,
          names::kBodyCone, names::kSpaceCone, names::kPolhodeFamily, names::kLabel}) {
      append(names::markers(body, picture, what));
    }
  }
}

}  // namespace

bool isUsable(const SceneLayout& layout) {
  const auto finite = [](const geometry_msgs::Point& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  return layout.centres.size() == layout.radii.size() && layout.bodies.size() == layout.frames.size() &&
         std::all_of(layout.centres.begin(), layout.centres.end(), finite) &&
         std::all_of(layout.radii.begin(), layout.radii.end(),
                     [](double radius) { return radius >= 0 && std::isfinite(radius); }) &&
         layout.picture_radius > 0 && std::isfinite(layout.picture_radius) && std::abs(layout.pitch) < M_PI_2;
}

rviz::Config overviewOf(const SceneLayout& layout, double aspect) {
  std::vector<view::Ball> balls;
  for (std::size_t i = 0; i < layout.centres.size(); ++i) {
    const geometry_msgs::Point& p = layout.centres[i];
    balls.push_back({{p.x, p.y, p.z}, layout.radii[i]});
  }
  const view::OrbitCamera camera = view::cameraThatShows(balls, layout.pitch, 0, aspect);
  return orbit(kOverview, names::kWorld, camera.distance, camera.focal, layout.pitch,
               kNear * std::min(1.0, camera.distance));
}

rviz::Config ridingOf(const SceneLayout& layout, const std::string& frame) {
  const double radius = layout.picture_radius;
  rviz::Config out = view("rviz/FrameAligned", kRiding, frame + "_space_body", kRidingNear * radius);
  const Eigen::Vector3d eye = kRidingDistance * radius * Eigen::Vector3d(kRidingX, kRidingY, kRidingZ).normalized();
  out.mapSetValue("Point towards", "arbitrary");
  out.mapSetValue("Lock Camera", true);
  out.mapSetValue("Pitch", std::asin(eye.z() / eye.norm()));
  out.mapSetValue("Yaw", std::atan2(-eye.y(), -eye.x()));
  out.mapSetValue("Roll", 0);
  setVector(out, "Position", eye.x(), eye.y(), eye.z());
  return out;
}

rviz::Config alongOf(const SceneLayout& layout, const std::string& frame) {
  const double radius = layout.picture_radius;
  return orbit(kAlongL, frame + "_space", kAlongDistance * radius, Eigen::Vector3d::Zero(), M_PI_2,
               kAlongNear * radius);
}

rviz::Config hiddenFor(const SceneLayout& layout, const std::string& body) {
  rviz::Config out;
  for (const auto& [view, displays] : std::initializer_list<std::pair<const char*, std::vector<const char*>>>{
           {kRiding, {"Floor", "Grip"}}, {kAlongL, {"Grip"}}}) {
    rviz::Config hidden = out.mapMakeChild(view);
    for (const char* display : {"Still", "Motion"}) {
      rviz::Config list = hidden.mapMakeChild(display);
      for (const std::string& other : layout.bodies) appendNamespaces(other, other == body, list);
      for (const char* drawing : {names::kDrawnLine, names::kDrawnText}) list.listAppendNew().setValue(drawing);
    }
    for (const char* display : displays) hidden.mapSetValue(display, true);
  }
  return out;
}

}  // namespace poinsot::rviz_panel::scene_views
