#pragma once

#include <nav_msgs/Odometry.h>
#include <poinsot/BodyDescription.h>
#include <poinsot/BodyState.h>
#include <poinsot/SceneLayout.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_set>
#include <vector>

#include "poinsot/audit/recording.h"
#include "poinsot/audit/report.h"

namespace poinsot::audit {

struct Options {
  double drift = 1e-3;  ///< E and L may drift by no more than this, relatively, whatever the method allows

  // Which topics are expected; checks of the others are left out.
  bool tf = true, odometry = true, markers = true;

  /**
   * Topics of a recording begin and end at different times: a state before the first or after the last message of
   * another topic needs no partner there, within this much of the recording's ends [s].
   */
  double ends = 2;
  /** The share of partners that may be missing in between: 0 for bags, little for live listening. */
  double losses = 0;
};

/**
 * Judges a stream of messages from the messages alone, with physics of its own.
 *
 * Messages of one topic must come in the order in which they were sent, or in that of a bag; topics may be mixed in any
 * order. A message that comes again, as when a bag is played in a loop, is judged once. A body is known by the
 * namespace of its topics, `[ns/]<body>/state`; its frame is its odometry's child_frame_id, or, without odometry, the
 * frame whose name ends with the body's and which moves as its state does.
 */
class Audit {
 public:
  explicit Audit(Options options = {}) : options_(options) {}

  void add(const BodyState& message, const std::string& topic);
  void add(const BodyDescription& message, const std::string& topic);
  void add(const nav_msgs::Odometry& message, const std::string& topic);
  void add(const tf2_msgs::TFMessage& message, bool is_static);
  void add(const visualization_msgs::MarkerArray& message, const std::string& topic);
  /** A layout says which bodies have pictures: of others, none are expected. */
  void add(const SceneLayout& message);

  /** Returns whether neither a state nor a description has been received. */
  bool empty() const { return states_.empty() && descriptions_.empty(); }

  /** Returns the checks of all messages received so far. */
  Report report() const;

 private:
  std::map<std::string, Body> bodies() const;
  std::string frameOf(const Body& body) const;
  template <class Message>
  bool isRepeated(const Message& message, const std::string& topic);

  Options options_;
  std::map<std::string, Body> states_;  ///< by the topic's namespace; with their states only
  std::map<std::string, std::vector<Description>> descriptions_;
  std::map<std::string, Track<Odometry>> odometry_;
  std::map<std::string, std::vector<Drawing>> drawings_;  ///< by the topic's namespace
  std::optional<std::set<std::string>> with_pictures_;    ///< names of bodies, as layouts say
  Transforms transforms_;
  std::unordered_set<std::size_t> heard_;  ///< digests of the messages that must not be judged twice
};

}  // namespace poinsot::audit
