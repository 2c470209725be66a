#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/ros/names.h"

namespace poinsot::node {

/** Returns all namespaces in which any body may draw, each with the number of its ids, which begin at 0. */
std::map<std::string, int> markerSpaces(const std::string& body);

/** Namespace and id, by which a viewer knows a marker. */
using MarkerKey = std::pair<std::string, int>;

/**
 * The canvas of one picture: the markers that viewers are to be sent, and which of them they have.
 *
 * Parts put markers in units of the picture, and the canvas makes metres of them: all lengths in the frames of the
 * pictures, and in any frame the widths of lines and arrows and the heights of letters. Places in the world and in
 * body axes, and the sizes of solids there, are in metres already.
 */
class Canvas {
 public:
  /** @param unit [m]. @param text by which letters are larger than usual. @param light the viewers' background. */
  void setUnits(const names::Frames& frames, double unit, double text, bool light);

  void put(const visualization_msgs::Marker& marker);

  /** Puts it where it is to be shown, else removes the one that is there. */
  void show(bool shown, const visualization_msgs::Marker& marker);

  /** Puts DELETE, in the markers' own frames, for first_id ≤ id < end_id, where they are there. */
  void remove(const std::string& ns, int first_id, int end_id = std::numeric_limits<int>::max());

  /** Returns what was put since the last call. */
  std::vector<visualization_msgs::Marker> take() { return std::exchange(markers_, {}); }

 private:
  std::set<std::string> picture_frames_;
  double unit_ = 1, text_ = 1;
  bool light_ = false;
  std::vector<visualization_msgs::Marker> markers_;
  std::map<MarkerKey, std::string> there_;  ///< the frame of each
};

/**
 * Which markers viewers have of a topic. What is to go is deleted by namespace and id, never with all others on the
 * topic: other nodes may draw there as well.
 */
class MarkerTracker {
 public:
  /** Marks what was put in the namespaces of a body for deletion, unless the next array puts it again. */
  void withdraw(const std::string& body);
  void withdrawAll() { to_go_.insert(there_.begin(), there_.end()); }
  /**
   * Marks what a node that has ended may have left of bodies of these names for deletion; not for more than 100 bodies,
   * whose deletions would be megabytes.
   */
  void withdrawLeftovers(const std::vector<std::string>& bodies);

  /** Marks all that was deleted for deletion once more, for viewers that missed it. */
  void withdrawAgain() { to_go_.insert(gone_.begin(), gone_.end()); }
  /** No deletion needs to be repeated. */
  void forgetGone() { gone_.clear(); }

  /** Puts the deletions of what is marked before the array's markers, and notes what it adds and deletes. */
  void follow(visualization_msgs::MarkerArray& array);

 private:
  std::set<MarkerKey> there_, to_go_, gone_;
};

}  // namespace poinsot::node
