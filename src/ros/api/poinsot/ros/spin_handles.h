#pragma once

#include <interactive_markers/interactive_marker_server.h>
#include <interactive_markers/menu_handler.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "poinsot/session/session.h"

namespace poinsot::node {

/**
 * The interactive markers by which one takes hold of Ω in RViz: one a body, a ball around the point Ω of the picture in
 * body axes, with a menu. They only say what hands do; what comes of it is the session's affair.
 *
 * What hands do waits for take(): the server of interactive markers calls back while it holds its own lock, so nothing
 * is sent and no marker is made or erased in between.
 */
class SpinHandles {
 public:
  explicit SpinHandles(const ros::NodeHandle& private_handle);

  /** At a tick: puts the handle of each body to where its Ω is drawn, if anybody can see it. */
  void update(const session::Session& session);
  void removeAll();
  /** Marks the ellipsoid on which Ω is led in the menus. */
  void showKept(view::ConservedQuantity keep);
  /** What was done since the last call, in order. */
  std::vector<session::HandleEvent> take();

 private:
  /** Puts the handle of a body there, makes it if need be. @param point in the frame [m], finite. */
  void place(const std::string& body, const std::string& frame, const Eigen::Vector3d& point);
  void remove(const std::string& body);
  using Feedback = visualization_msgs::InteractiveMarkerFeedbackConstPtr;
  void make(const std::string& body, const std::string& frame, const Eigen::Vector3d& point);
  void add(const Feedback& feedback);
  /** A hand has moved the handle; where it is, is the session's affair. */
  void putBack(const std::string& body);
  interactive_markers::MenuHandler::EntryHandle entry(interactive_markers::MenuHandler::EntryHandle parent,
                                                      const std::string& title, const session::HandleEvent& event);

  ros::NodeHandle handle_;
  interactive_markers::InteractiveMarkerServer server_;
  interactive_markers::MenuHandler menu_;
  interactive_markers::MenuHandler::EntryHandle keep_energy_ = 0, keep_momentum_ = 0;
  std::map<interactive_markers::MenuHandler::EntryHandle, session::HandleEvent> meaning_;  ///< of the menu's entries
  ros::Publisher update_;                          ///< the server's own topic, to count who listens
  std::map<std::string, std::string> frames_;      ///< of the handles that there are
  std::map<std::string, Eigen::Vector3d> places_;  ///< where they were put last
  std::vector<session::HandleEvent> events_;
  std::size_t ticks_since_update_ = 0;
};

}  // namespace poinsot::node
