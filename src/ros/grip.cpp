#include "poinsot/ros/grip.h"

#include <cmath>
#include <optional>

#include "poinsot/ros/brush.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/names.h"
#include "poinsot/ros/palette.h"

namespace poinsot::node {
namespace {

using interactive_markers::MenuHandler;
using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::InteractiveMarkerFeedback;
using visualization_msgs::Marker;

constexpr double kDiameter = 0.24;  // m: the point of Ω within is 0.1
constexpr float kAlpha = 0.35f;
constexpr int kMeridians = 12, kParallels = 6;
constexpr std::size_t kMostTouches = 1000;  // kept between two calls of take()

/** Around what is drawn at Ω. Of a sixth of the triangles of RViz's own sphere, which software OpenGL feels. */
Marker ball() {
  Marker out;
  out.type = Marker::TRIANGLE_LIST;
  out.pose.orientation.w = 1;
  out.scale = toVector3({1, 1, 1});
  out.color = palette::translucent(palette::omega(), kAlpha);
  const auto point = [](int parallel, int meridian) {
    const double polar = M_PI * parallel / kParallels, around = 2 * M_PI * meridian / kMeridians;
    return toPoint(
        0.5 * kDiameter *
        Eigen::Vector3d(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)));
  };
  for (int j = 0; j < kParallels; ++j) {
    for (int i = 0; i < kMeridians; ++i) {
      const auto north_west = point(j, i), south_west = point(j + 1, i), south_east = point(j + 1, i + 1),
                 north_east = point(j, i + 1);
      if (j > 0) out.points.insert(out.points.end(), {north_west, south_west, north_east});
      if (j + 1 < kParallels) out.points.insert(out.points.end(), {north_east, south_west, south_east});
    }
  }
  makeUnlit(out);
  return out;
}

geometry_msgs::Pose poseAt(const Eigen::Vector3d& point) {
  geometry_msgs::Pose out;
  out.position = toPoint(point);
  out.orientation.w = 1;
  return out;
}

Touch touch(Touch::Kind kind) {
  Touch out;
  out.kind = kind;
  return out;
}

Touch keeping(view::Keep keep) {
  Touch out = touch(Touch::Kind::keep);
  out.keep = keep;
  return out;
}

Touch spinning(Touch::Kind kind, view::Axis axis) {
  Touch out = touch(kind);
  out.axis = axis;
  return out;
}

}  // namespace

Grip::Grip(const ros::NodeHandle& private_handle)
    : handle_(private_handle),
      server_(private_handle.resolveName(names::kGrip)),
      update_(
          handle_.advertise<visualization_msgs::InteractiveMarkerUpdate>(std::string(names::kGrip) + "/update", 100)) {
  using Kind = Touch::Kind;
  const auto lead = menu_.insert("Lead Omega over the");
  keep_energy_ = entry(lead, "energy ellipsoid (E stays)", keeping(view::Keep::energy));
  keep_momentum_ = entry(lead, "momentum ellipsoid (|L| stays)", keeping(view::Keep::momentum));
  const auto spin = menu_.insert("Spin exactly about the axis of");
  entry(spin, "smallest moment", spinning(Kind::axis, view::Axis::smallest));
  entry(spin, "intermediate moment", spinning(Kind::axis, view::Axis::intermediate));
  entry(spin, "largest moment", spinning(Kind::axis, view::Axis::largest));
  const auto near = menu_.insert("Spin near the axis of");
  entry(near, "smallest moment: stable", spinning(Kind::near, view::Axis::smallest));
  entry(near, "intermediate moment: flips", spinning(Kind::near, view::Axis::intermediate));
  entry(near, "largest moment: stable", spinning(Kind::near, view::Axis::largest));
  const auto separatrix =
      menu_.insert("Spin exactly on the separatrix (to rounding)", [this](const Feedback& f) { add(f); });
  meaning_[separatrix] = touch(Kind::separatrix);
  const auto reset = menu_.insert("Reset: the scene's own spins", [this](const Feedback& f) { add(f); });
  meaning_[reset] = touch(Kind::reset);
  showKept(view::Keep::energy);
}

MenuHandler::EntryHandle Grip::entry(MenuHandler::EntryHandle parent, const std::string& title, const Touch& touch) {
  const auto out = menu_.insert(parent, title, [this](const Feedback& feedback) { add(feedback); });
  meaning_[out] = touch;
  return out;
}

void Grip::make(const std::string& body, const std::string& frame, const Eigen::Vector3d& point) {
  InteractiveMarker grip;
  grip.header.frame_id = frame;
  grip.name = body;
  grip.scale = static_cast<float>(kDiameter);
  grip.pose = poseAt(point);

  InteractiveMarkerControl control;
  control.name = "lead";
  control.description = "drag: lead Omega about; right click: spins to choose from. ";
  // In the plane of the screen. MENU beside it would take the left button too.
  control.interaction_mode = InteractiveMarkerControl::MOVE_3D;
  control.orientation.w = 1;
  control.always_visible = true;
  control.markers.push_back(ball());
  grip.controls.push_back(control);

  server_.insert(grip, [this](const Feedback& feedback) { add(feedback); });
  menu_.apply(server_, body);
  frames_[body] = frame;
}

void Grip::place(const std::string& body, const std::string& frame, const Eigen::Vector3d& point) {
  const auto there = frames_.find(body);
  const bool is_new = there == frames_.end() || there->second != frame;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto place = places_.find(body);
    if (!is_new && place != places_.end() && place->second == point) return;
    places_[body] = point;
  }
  if (is_new) {
    make(body, frame, point);
  } else {
    server_.setPose(body, poseAt(point));
  }
}

void Grip::remove(const std::string& body) {
  if (frames_.erase(body) == 0) return;
  server_.erase(body);
  const std::lock_guard<std::mutex> lock(mutex_);
  places_.erase(body);
}

void Grip::removeAll() {
  frames_.clear();
  server_.clear();
  const std::lock_guard<std::mutex> lock(mutex_);
  places_.clear();
}

void Grip::showKept(view::Keep keep) {
  menu_.setCheckState(keep_energy_, keep == view::Keep::energy ? MenuHandler::CHECKED : MenuHandler::UNCHECKED);
  menu_.setCheckState(keep_momentum_, keep == view::Keep::momentum ? MenuHandler::CHECKED : MenuHandler::UNCHECKED);
  menu_.reApply(server_);
}

void Grip::apply() {
  server_.applyChanges();
}

// The server takes the hand's place, whatever it is, for the grip's. It calls back while it holds its own lock, so
// nothing is sent in between.
void Grip::putBack(const std::string& body) {
  std::optional<Eigen::Vector3d> place;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = places_.find(body);
    if (found != places_.end()) place = found->second;
  }
  if (place) server_.setPose(body, poseAt(*place));
}

void Grip::add(const Feedback& feedback) {
  Touch out;
  switch (feedback->event_type) {
    case InteractiveMarkerFeedback::MOUSE_DOWN:
      out.kind = Touch::Kind::press;
      break;
    case InteractiveMarkerFeedback::POSE_UPDATE:
      out.kind = Touch::Kind::lead;
      putBack(feedback->marker_name);
      break;
    case InteractiveMarkerFeedback::MOUSE_UP:
      out.kind = Touch::Kind::let_go;
      break;
    case InteractiveMarkerFeedback::KEEP_ALIVE:
      out.kind = Touch::Kind::hold;
      break;
    case InteractiveMarkerFeedback::MENU_SELECT: {
      const auto found = meaning_.find(feedback->menu_entry_id);
      if (found == meaning_.end()) return;
      out = found->second;
      break;
    }
    default:
      return;
  }
  out.body = feedback->marker_name;
  out.frame = feedback->header.frame_id;
  const auto& p = feedback->pose.position;
  out.point = {p.x, p.y, p.z};
  const std::lock_guard<std::mutex> lock(mutex_);
  if (touches_.size() < kMostTouches) touches_.push_back(out);
}

std::vector<Touch> Grip::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<Touch> out;
  out.swap(touches_);
  return out;
}

}  // namespace poinsot::node
