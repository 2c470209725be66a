#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace poinsot::node {

/** The namespaces in which a body draws, whatever it is and whatever acts on it: how many ids there are, from 0 on. */
std::map<std::string, int> markerSpaces(const std::string& body);

/** Namespace and id, by which a viewer knows a marker. */
using MarkerKey = std::pair<std::string, int>;

/** On which one picture is drawn: the markers that viewers are to be sent, and which they have then. */
class Canvas {
 public:
  void put(const visualization_msgs::Marker& marker);

  /** Puts it where it is to be shown, else removes the one that is there. */
  void show(bool shown, const visualization_msgs::Marker& marker);

  /** Puts DELETE, in the markers' own frames, for first_id ≤ id < end_id, where they are there. */
  void remove(const std::string& ns, int first_id, int end_id = std::numeric_limits<int>::max());

  /** What was put since the last time. */
  std::vector<visualization_msgs::Marker> take() { return std::exchange(markers_, {}); }

 private:
  std::vector<visualization_msgs::Marker> markers_;
  std::map<MarkerKey, std::string> there_;  ///< the frame of each
};

/**
 * Which markers viewers have of a topic. What is to go is deleted by namespace and id, never with all others on the
 * topic: other nodes may draw there as well.
 */
class MarkerTracker {
 public:
  /** What was put in the namespaces of a body is to go, unless the next array puts it again. */
  void withdraw(const std::string& body);
  void withdrawAll() { to_go_.insert(there_.begin(), there_.end()); }
  /**
   * So is what a node that has ended may have left in these bodies' names; not of more than 100 bodies, whose deletions
   * would be megabytes.
   */
  void withdrawLeftovers(const std::vector<std::string>& bodies);

  /** All that has gone is to go once more: who has missed the array with its deletion is told again. */
  void withdrawAgain() { to_go_.insert(gone_.begin(), gone_.end()); }
  /** Nobody needs to be told again. */
  void forgetGone() { gone_.clear(); }

  /** Has the array delete what is to go before it puts anything. Notes what it puts and deletes. */
  void follow(visualization_msgs::MarkerArray& array);

 private:
  std::set<MarkerKey> there_, to_go_, gone_;
};

}  // namespace poinsot::node
