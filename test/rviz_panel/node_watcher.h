#pragma once

#include <geometry_msgs/PointStamped.h>
#include <poinsot/BodyDescription.h>
#include <poinsot/BodyState.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <std_msgs/Float64.h>

#include <QProcess>
#include <QString>
#include <string>

/** Listens to the node's topics beside the panel. */
class NodeWatcher {
 public:
  explicit NodeWatcher(const std::string& body);
  /** Takes in what has come since. */
  void hear();
  /** Forgets what it has heard, to see what comes from now on. */
  void forget();

  int states = 0;
  poinsot::BodyState state;        ///< the newest
  poinsot::BodyState first_state;  ///< since it was to forget
  poinsot::BodyDescription description;
  int seeks = 0;
  double seek = 0;
  int viewpoints = 0;
  geometry_msgs::PointStamped viewpoint;

 private:
  ros::CallbackQueue queue_;
  ros::NodeHandle handle_;
  std::vector<ros::Subscriber> subscribers_;
};

/** A program that ends with its owner, at the latest. */
class Program {
 public:
  Program(const QString& file, const QStringList& arguments);
  ~Program();
  void kill();
  /** Stops it where it stands, still connected to everybody; and lets it go on. */
  void freeze();
  void thaw();
  bool running() { return process_.state() == QProcess::Running; }

 private:
  QProcess process_;
};
