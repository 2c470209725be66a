#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace poinsot::node {

/** A namespace in which a body draws, and how many ids it may use there, from 0 on. */
struct MarkerSpace {
  std::string ns;
  int ids;
};

/** All in which a body draws, whatever it is and whatever acts on it. */
std::vector<MarkerSpace> markerSpaces(const std::string& body);

/**
 * Which markers viewers have, by namespace and id: of a topic, or of one picture on it. What is to go is deleted by
 * these, never with all others on the topic: other nodes may draw there as well.
 */
class MarkerTracker {
 public:
  /** Appends a marker. */
  void put(const visualization_msgs::Marker& marker, visualization_msgs::MarkerArray& out);

  /** Appends DELETE, in the markers' own frames, for those of a namespace with ids from `first_id` on, where there are
   * any. */
  void remove(const std::string& ns, int first_id, visualization_msgs::MarkerArray& out);
  void removeOne(const std::string& ns, int id, visualization_msgs::MarkerArray& out);

  /** What was put in the namespaces of a body is to go, unless the next array puts it again. */
  void withdraw(const std::string& body);
  void withdrawAll();
  /**
   * So is what a node that has ended may have left in these bodies' names; not of more than 100 bodies, whose deletions
   * would be megabytes.
   */
  void withdrawLeftovers(const std::vector<std::string>& bodies);

  /** All that has gone is to go once more: who has missed the array with its deletion is told again. */
  void withdrawAgain();
  /** Nobody needs to be told again. */
  void forgetGone() { gone_.clear(); }

  /** Has the array delete what is to go before it puts anything. Notes what it puts and deletes. */
  void follow(visualization_msgs::MarkerArray& array);

 private:
  using Key = std::pair<std::string, int>;
  using Frames = std::map<Key, std::string>;
  Frames::iterator remove(Frames::iterator it, visualization_msgs::MarkerArray& out);

  Frames there_;  ///< the frame of each
  std::set<Key> to_go_, gone_;
};

}  // namespace poinsot::node
