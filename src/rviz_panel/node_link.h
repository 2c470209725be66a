#pragma once

#include <poinsot/BodyDescription.h>
#include <poinsot/BodyState.h>
#include <poinsot/NodeStatus.h>
#include <poinsot/SceneLayout.h>

#include <ros/publisher.h>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>
#include <string>

#include "worker.h"

namespace poinsot::rviz_panel {

/**
 * The panel's connection to ROS: the node's status, one body's state, and requests to the node. Where bodies are heard
 * but no node, a recording is being played.
 *
 * It lives on one thread, from which all its signals come, and never waits: workers do what may wait for the node or
 * for the master (service calls, subscribing). While a node is silent, it is looked for every two seconds with new
 * subscriptions: those from before a restart of the master would hear nothing.
 */
class NodeLink : public QObject {
  Q_OBJECT

 public:
  explicit NodeLink(QObject* parent = nullptr);
  ~NodeLink() override;

  /**
   * The node to listen to; a relative name is resolved as ROS does, in RViz's own namespace. A name that ROS does not
   * allow is refused.
   */
  void setNode(const QString& name);
  /** Its name as it was given, and as it was resolved. */
  QString givenNode() const { return given_; }
  QString node() const { return QString::fromStdString(node_); }

  /** The body whose state and description are wanted; empty: none. */
  void setBody(const QString& body);
  QString body() const { return QString::fromStdString(body_); }

  /** Whether the node's status arrived within the last 1.5 s. */
  bool alive() const { return alive_; }
  /** Whether bodies have been heard without a node. */
  bool hearsRecording() const { return recording_; }
  /** Whether the node has taken more than a second over a service call. */
  bool waiting() const;

  /** Tells the user why what was asked for is not sent. */
  void refuse(const QString& why) { Q_EMIT refused(why); }
  void setPaused(bool paused);
  void step();
  void reset();
  void loadScene(const QString& scene);
  /** `step` in seconds; 0: chosen by the node. */
  void setMethod(const QString& body, const QString& method, double step);

  // Topics: no more than twenty messages a second each, of which the last one is always sent.
  void setSpeed(double speed) { outbox_.speed = speed; }
  void seek(double time) { outbox_.seek = time; }
  /** Where the viewer's eye is [m], in the world frame; not sent again while it is there. */
  void setEye(const std::array<double, 3>& eye);
  /** Whether the viewer's background is light; not sent again while it stays so. */
  void setLightBackground(bool light);

 Q_SIGNALS:
  void found();
  void lost();
  /** While no node is heard: the bodies whose states somebody offers, such as a player of recordings. */
  void bodiesOffered(const QStringList& bodies);
  void statusReceived(const poinsot::NodeStatus& status);
  void stateReceived(const poinsot::BodyState& state);
  void descriptionReceived(const poinsot::BodyDescription& description);
  void layoutReceived(const poinsot::SceneLayout& layout);
  /** The outcome of a service call, in the node's words. */
  void done(const QString& message);
  void refused(const QString& message);
  /** A reset is asked for: t is to be 0, and to run forwards. */
  void resetting();

 private:
  struct Connection;

  void poll();
  void onStatus(const NodeStatus& status);
  void onState(const BodyState& state);
  /** Gives up what was asked of the node. */
  void giveUp();
  void connectAnew();
  void follow();
  template <typename Service>
  void call(const char* name, const typename Service::Request& request);

  QString given_;
  std::string node_;
  std::string body_;
  bool alive_ = false;
  bool recording_ = false;
  bool connecting_ = false;
  QElapsedTimer since_status_;
  QElapsedTimer since_attempt_;
  QElapsedTimer since_state_;
  struct Calls {
    int open = 0;         ///< that have not been answered
    QElapsedTimer since;  ///< the oldest of them, or the last answer
  } calls_;
  struct Outbox {
    std::optional<double> speed, seek;              ///< to be sent
    std::optional<std::array<double, 3>> told_eye;  ///< has been sent
    std::optional<bool> told_light_background;      ///< likewise
  } outbox_;
  QTimer timer_;
  std::shared_ptr<Connection> connection_;
  Worker subscribing_;
  Worker calling_;
};

}  // namespace poinsot::rviz_panel
