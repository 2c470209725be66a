#pragma once

#include <visualization_msgs/MarkerArray.h>

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
 * Which markers the viewers of one topic have, by namespace and id. What is to go is deleted by these, never with all
 * others on the topic: other nodes may draw there as well.
 */
class MarkerTracker {
 public:
  /** What was put in the namespaces of a body is to go, unless the next array puts it again. */
  void withdraw(const std::string& body);
  void withdrawAll();

  /** So is what a node that has ended may have left in the body's name. */
  void withdrawLeftovers(const std::string& body);

  /** Has the array delete what is to go before it puts anything. Notes what it puts and deletes. */
  void follow(visualization_msgs::MarkerArray& array);

 private:
  using Key = std::pair<std::string, int>;
  std::set<Key> there_;
  std::set<Key> to_go_;
};

}  // namespace poinsot::node
