#include "poinsot/ros/spin_handles.h"

#include <algorithm>
#include <cmath>

#include "markers/marker_factory.h"
#include "poinsot/ros/body_topics.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/markers/palette.h"
#include "poinsot/ros/names.h"

namespace poinsot::node {
namespace {

using interactive_markers::MenuHandler;
using session::HandleEvent;
using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::InteractiveMarkerFeedback;
using visualization_msgs::Marker;

constexpr double kDiameter = 0.24;  // radii of a picture: the point of Ω within is 0.1
constexpr float kAlpha = 0.35f;
constexpr int kMeridians = 12, kParallels = 6;
constexpr std::size_t kMostHandles = 16;    // bodies beyond have none
constexpr std::size_t kPlacedEachTick = 4;  // with more they are placed more rarely
constexpr std::size_t kMostEvents = 1000;   // kept between two calls of take()

/** Returns a ball of that diameter [m] around Ω, with a sixth of the triangles of RViz's own sphere: software OpenGL is
 * slow. */
Marker ball(double diameter) {
  Marker out;
  out.type = Marker::TRIANGLE_LIST;
  out.pose.orientation.w = 1;
  out.scale = toVector3({1, 1, 1});
  out.color = palette::translucent(palette::kOmega, kAlpha);
  const auto point = [diameter](int parallel, int meridian) {
    const double polar = M_PI * parallel / kParallels, around = 2 * M_PI * meridian / kMeridians;
    return toPoint(
        0.5 * diameter *
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

HandleEvent eventOf(HandleEvent::Kind kind, view::Axis axis = {}, view::ConservedQuantity keep = {}) {
  HandleEvent out;
  out.kind = kind;
  out.axis = axis;
  out.keep = keep;
  return out;
}

}  // namespace

SpinHandles::SpinHandles(ros::NodeHandle private_handle)
    : server_(private_handle.resolveName(names::kGrip)),
      update_(private_handle.advertise<visualization_msgs::InteractiveMarkerUpdate>(
          std::string(names::kGrip) + "/update", 100)) {
  using Kind = HandleEvent::Kind;
  const auto lead = menu_.insert("Lead Omega over the");
  keep_energy_ = entry(lead, "energy ellipsoid (E stays)", eventOf(Kind::keep, {}, view::ConservedQuantity::energy));
  keep_momentum_ =
      entry(lead, "momentum ellipsoid (|L| stays)", eventOf(Kind::keep, {}, view::ConservedQuantity::momentum));
  const auto spin = menu_.insert("Spin exactly about the axis of");
  entry(spin, "smallest moment", eventOf(Kind::axis, view::Axis::smallest));
  entry(spin, "intermediate moment", eventOf(Kind::axis, view::Axis::intermediate));
  entry(spin, "largest moment", eventOf(Kind::axis, view::Axis::largest));
  const auto near = menu_.insert("Spin near the axis of");
  entry(near, "smallest moment: stable", eventOf(Kind::near, view::Axis::smallest));
  entry(near, "intermediate moment: flips", eventOf(Kind::near, view::Axis::intermediate));
  entry(near, "largest moment: stable", eventOf(Kind::near, view::Axis::largest));
  entry(std::nullopt, "Spin exactly on the separatrix (to rounding)", eventOf(Kind::separatrix));
  entry(std::nullopt, "Reset: the scene's own spins", eventOf(Kind::reset));
  showKept(view::ConservedQuantity::energy);
}

MenuHandler::EntryHandle SpinHandles::entry(const std::optional<MenuHandler::EntryHandle>& parent,
                                            const std::string& title, const HandleEvent& event) {
  const MenuHandler::FeedbackCallback chosen = [this](const Feedback& feedback) { add(feedback); };
  const auto out = parent ? menu_.insert(*parent, title, chosen) : menu_.insert(title, chosen);
  meaning_[out] = event;
  return out;
}

void SpinHandles::make(const std::string& body, const Placed& at) {
  InteractiveMarker handle;
  handle.header.frame_id = at.frame;
  handle.name = body;
  handle.scale = static_cast<float>(kDiameter * at.radius);
  handle.pose = poseAt(at.point);

  InteractiveMarkerControl control;
  control.name = "lead";
  control.description = "drag: lead Omega about; right click: spins to choose from. ";
  // In the plane of the screen. MENU beside it would take the left button too.
  control.interaction_mode = InteractiveMarkerControl::MOVE_3D;
  control.orientation.w = 1;
  control.always_visible = true;
  control.markers.push_back(ball(kDiameter * at.radius));
  handle.controls.push_back(control);

  server_.insert(handle, [this](const Feedback& feedback) { add(feedback); });
  menu_.apply(server_, body);
}

void SpinHandles::place(const std::string& body, const Placed& at) {
  const auto there = placed_.find(body);
  const bool is_new = there == placed_.end() || there->second.frame != at.frame || there->second.radius != at.radius;
  if (!is_new && there->second.point == at.point) return;
  placed_[body] = at;
  if (is_new) {
    make(body, at);
  } else {
    server_.setPose(body, poseAt(at.point));
  }
}

void SpinHandles::remove(const std::string& body) {
  if (placed_.erase(body) > 0) server_.erase(body);
}

void SpinHandles::removeAll() {
  placed_.clear();
  server_.clear();
}

void SpinHandles::showKept(view::ConservedQuantity keep) {
  const bool energy = keep == view::ConservedQuantity::energy;
  menu_.setCheckState(keep_energy_, energy ? MenuHandler::CHECKED : MenuHandler::UNCHECKED);
  menu_.setCheckState(keep_momentum_, energy ? MenuHandler::UNCHECKED : MenuHandler::CHECKED);
  menu_.reApply(server_);
}

void SpinHandles::update(const session::Session& session) {
  if (update_.getNumSubscribers() == 0) return;
  const auto& bodies = session.bodies();
  const std::size_t pause = (bodies.size() + kPlacedEachTick - 1) / kPlacedEachTick;
  if (++ticks_since_update_ < pause && session.drag().state() == session::SpinDrag::State::free) return;
  ticks_since_update_ = 0;
  for (std::size_t i = 0; i < std::min(bodies.size(), kMostHandles); ++i) {
    const session::Body& body = session.drawn(i);
    BodyTopics& topics = topicsOf(body);
    if (body.state().omega_body.isZero(0) || !topics.picture().hasPictures()) {
      remove(body.name());
    } else {
      place(body.name(), {topics.frames().model, session::omegaPoint(body), topics.frame().unit});
    }
  }
  server_.applyChanges();
}

// The server moves the handle to any place that a hand reports. It calls back while it holds its own lock, so nothing
// is sent in between.
void SpinHandles::putBack(const std::string& body) {
  const auto found = placed_.find(body);
  if (found != placed_.end()) server_.setPose(body, poseAt(found->second.point));
}

void SpinHandles::add(const Feedback& feedback) {
  HandleEvent out;
  switch (feedback->event_type) {
    case InteractiveMarkerFeedback::MOUSE_DOWN:
      out.kind = HandleEvent::Kind::press;
      break;
    case InteractiveMarkerFeedback::POSE_UPDATE:
      out.kind = HandleEvent::Kind::lead;
      putBack(feedback->marker_name);
      break;
    case InteractiveMarkerFeedback::MOUSE_UP:
      out.kind = HandleEvent::Kind::let_go;
      break;
    case InteractiveMarkerFeedback::KEEP_ALIVE:
      out.kind = HandleEvent::Kind::hold;
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
  if (events_.size() < kMostEvents) events_.push_back(out);
}

std::vector<HandleEvent> SpinHandles::take() {
  std::vector<HandleEvent> out;
  out.swap(events_);
  return out;
}

}  // namespace poinsot::node
