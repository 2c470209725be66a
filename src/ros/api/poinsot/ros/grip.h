#pragma once

#include <interactive_markers/interactive_marker_server.h>
#include <interactive_markers/menu_handler.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <Eigen/Core>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "poinsot/view/spin_choices.h"

namespace poinsot::node {

/** What a hand did to a body's grip. */
struct Touch {
  enum class Kind {
    press,   ///< took hold
    lead,    ///< led the grip to `point`
    let_go,  ///< released it
    hold,    ///< still holds it
    keep,    ///< chose the ellipsoid on which Ω is led: `keep`
    axis,    ///< chose a spin exactly about `axis`
    near,    ///< chose a spin near `axis`
    separatrix,
    reset
  };
  Kind kind = Kind::hold;
  std::string body;
  std::string frame;                                ///< in which `point` is
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< [m]; not checked: it comes from outside
  view::Keep keep = view::Keep::energy;
  view::Axis axis = view::Axis::smallest;
};

/**
 * The interactive markers by which one takes hold of Ω in RViz: one a body, a ball around the point Ω of the picture in
 * body axes, with a menu. It only says what hands do; what comes of it is the node's affair.
 *
 * What hands do arrives on ROS's thread and waits for take().
 */
class Grip {
 public:
  explicit Grip(const ros::NodeHandle& private_handle);

  /** Whether anybody can see it. */
  bool watched() const { return update_.getNumSubscribers() > 0; }

  /** Puts the grip of a body there, makes it if need be. @param point in the frame [m], finite. */
  void place(const std::string& body, const std::string& frame, const Eigen::Vector3d& point);
  void remove(const std::string& body);
  void removeAll();
  /** Marks the ellipsoid on which Ω is led in the menus. */
  void showKept(view::Keep keep);
  /** Sends what has changed. */
  void apply();

  /** What was done since the last call, in order. */
  std::vector<Touch> take();

 private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedbackConstPtr;
  void make(const std::string& body, const std::string& frame, const Eigen::Vector3d& point);
  void add(const Feedback& feedback);
  /** A hand has moved the grip; where it is, is the node's affair. */
  void putBack(const std::string& body);
  interactive_markers::MenuHandler::EntryHandle entry(interactive_markers::MenuHandler::EntryHandle parent,
                                                      const std::string& title, const Touch& touch);

  ros::NodeHandle handle_;
  interactive_markers::InteractiveMarkerServer server_;
  interactive_markers::MenuHandler menu_;
  interactive_markers::MenuHandler::EntryHandle keep_energy_ = 0, keep_momentum_ = 0;
  std::map<interactive_markers::MenuHandler::EntryHandle, Touch> meaning_;  ///< of the menu's entries
  ros::Publisher update_;                          ///< the server's own topic, to count who listens
  std::map<std::string, std::string> frames_;      ///< of the grips that there are
  std::mutex mutex_;                               ///< of what follows; nothing of the server is called under it
  std::map<std::string, Eigen::Vector3d> places_;  ///< where they were put last
  std::vector<Touch> touches_;
};

}  // namespace poinsot::node
