#pragma once

#include <interactive_markers/interactive_marker_server.h>
#include <interactive_markers/menu_handler.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/session/session.h"

namespace poinsot::node {

/**
 * The interactive markers by which users take hold of Ω in RViz: one a body, a ball around the point Ω of the picture
 * in body axes, with a menu. They report what hands do; the session decides what follows.
 *
 * What hands do waits for take(): the server of interactive markers calls back while it holds its own lock, so nothing
 * is sent and no marker is made or erased in between.
 */
class SpinHandles {
 public:
  explicit SpinHandles(ros::NodeHandle private_handle);

  /** Puts the handle of each body where its Ω is drawn, if somebody listens. To be called at each tick. */
  void update(const session::Session& session);
  void removeAll();
  /** Marks in the menus the ellipsoid on which Ω is led. */
  void showKept(view::ConservedQuantity keep);
  /** Returns what hands have done since the last call, in order. */
  std::vector<session::HandleEvent> take();

 private:
  /** Where a handle stands. */
  struct Placed {
    std::string frame;
    Eigen::Vector3d point;  ///< in the frame [m], finite
    double radius;          ///< of the picture [m]
  };
  /** Puts the handle of a body there, and makes it where there is none. */
  void place(const std::string& body, const Placed& at);
  void remove(const std::string& body);
  using Feedback = visualization_msgs::InteractiveMarkerFeedbackConstPtr;
  void make(const std::string& body, const Placed& at);
  void add(const Feedback& feedback);
  /** Takes the handle back from where a hand has moved it. */
  void putBack(const std::string& body);
  /** Adds an entry to the menu. @param parent the entry below which it stands; nothing: none. */
  interactive_markers::MenuHandler::EntryHandle entry(
      const std::optional<interactive_markers::MenuHandler::EntryHandle>& parent, const std::string& title,
      const session::HandleEvent& event);

  interactive_markers::InteractiveMarkerServer server_;
  interactive_markers::MenuHandler menu_;
  interactive_markers::MenuHandler::EntryHandle keep_energy_ = 0, keep_momentum_ = 0;
  std::map<interactive_markers::MenuHandler::EntryHandle, session::HandleEvent> meaning_;  ///< of the menu's entries
  ros::Publisher update_;                 ///< the server's own topic, to count who listens
  std::map<std::string, Placed> placed_;  ///< by body: where its handle was put last
  std::vector<session::HandleEvent> events_;
  std::size_t ticks_since_update_ = 0;
};

}  // namespace poinsot::node
