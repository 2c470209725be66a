#pragma once

#include <rosbag/bag.h>
#include <tf2_msgs/TFMessage.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/ros/markers/body_picture.h"
#include "poinsot/ros/names.h"
#include "poinsot/scene/scene.h"
#include "poinsot/session/moving_body.h"

namespace poinsot::node {

/**
 * A bag of what the node would have published while it played a scene at speed 1, made without a ROS master: the same
 * messages on the same topics but /diagnostics, in one segment. The same scene gives the same bytes: stamps begin at
 * 1 s, not at the wall's time, and `cost` is NaN, not measured.
 */
class SceneBag {
 public:
  /** The latest simulation time that a stamp can hold [s]. */
  static constexpr double kLatest = 4.294e9;

  struct Options {
    bool markers = true;
  };

  /**
   * @param file is overwritten.
   * @param scene with a method for every body.
   * All members throw rosbag::BagException where the file cannot be written.
   */
  SceneBag(const std::string& file, const scene::Scene& scene, const Options& options);
  ~SceneBag();
  SceneBag(const SceneBag&) = delete;
  SceneBag& operator=(const SceneBag&) = delete;

  /**
   * Everything at t [s], 0 ≤ t ≤ kLatest, which never decreases. A time whose stamp, in whole nanoseconds, is that of
   * the time before it is left out. Throws std::runtime_error where a body has no state there.
   */
  void write(double t);

  /** The bodies at the last time that was written. */
  std::size_t bodyCount() const { return entries_.size(); }
  const session::MovingBody& body(std::size_t i) const { return entries_[i].body; }

  /** Ends the file. One that was not closed is no bag. */
  void close();

 private:
  template <class Message>
  void put(const std::string& topic, const Message& message);
  template <class Message>
  void putLatched(const std::string& topic, const Message& message);

  void writeStatic();
  void writeLayout();
  void writeStaticMarkers();
  void writeMoving(const session::Tick& tick);
  void clearLeftovers(bool& cleared, visualization_msgs::MarkerArray& markers) const;

  /** A body, and its picture. */
  struct Entry {
    Entry(const scene::Body& scene_body, BodyPicture::Detail detail);
    session::MovingBody body;
    names::Frames frames;
    std::unique_ptr<BodyPicture> picture;
  };

  std::unique_ptr<rosbag::Bag> bag_;
  std::vector<Entry> entries_;
  view::SceneLayout layout_;
  std::vector<scene::Drawing> drawings_;
  bool markers_;
  bool moving_cleared_ = false, still_cleared_ = false;  ///< of what another recording may have drawn
  bool some_body_steps_ = false;                         ///< then labels tell how well
  bool static_markers_repeated_ = false;
  std::optional<ros::Time> stamp_;  ///< of the last tick
  tf2_msgs::TFMessage transforms_;  ///< reused from tick to tick
};

}  // namespace poinsot::node
