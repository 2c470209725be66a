#include "node_link.h"

#include <geometry_msgs/PointStamped.h>
#include <poinsot/LoadScene.h>
#include <poinsot/SetMethod.h>
#include <ros/callback_queue.h>
#include <ros/master.h>
#include <ros/names.h>
#include <ros/node_handle.h>
#include <std_msgs/Float64.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <utility>

#include "poinsot/ros/names.h"

namespace poinsot::rviz_panel {
namespace {

namespace names = node::names;

constexpr int kPollEvery = 50;       // ms
constexpr int kSilence = 1500;       // ms, after which a node counts as gone
constexpr int kAttemptEvery = 2000;  // ms, from when the last attempt was ready to hear
constexpr int kStateQueue = 2000;

}  // namespace

/** Subscribers and publishers: made, changed and destroyed by the worker, listened to on the link's thread. */
struct NodeLink::Connection {
  Connection(NodeLink* to, std::string name)
      : link(to), node(std::move(name)), handle(ros::names::parentNamespace(node)), private_handle(node) {
    handle.setCallbackQueue(&queue);
    private_handle.setCallbackQueue(&queue);
    speed = private_handle.advertise<std_msgs::Float64>(names::kSpeed, 10);
    seek = private_handle.advertise<std_msgs::Float64>(names::kSeek, 10);
    viewpoint = private_handle.advertise<geometry_msgs::PointStamped>(names::kViewpoint, 10);
    status = private_handle.subscribe<NodeStatus>(
        names::kStatus, 10, [to](const NodeStatus::ConstPtr& message) { to->onStatus(*message); });
  }

  void watch(const std::string& body) {
    state.shutdown();
    description.shutdown();
    if (body.empty()) return;
    NodeLink* const to = link;
    state = handle.subscribe<BodyState>(
        names::topic(body, names::kState), kStateQueue,
        [to](const BodyState::ConstPtr& message) { Q_EMIT to->stateReceived(*message); }, ros::VoidConstPtr(),
        ros::TransportHints().tcpNoDelay());
    description = handle.subscribe<BodyDescription>(
        names::topic(body, names::kDescription), 1,
        [to](const BodyDescription::ConstPtr& message) { Q_EMIT to->descriptionReceived(*message); });
  }

  NodeLink* link;  // used in callbacks only, which only the link itself calls
  std::string node;
  ros::CallbackQueue queue;
  ros::NodeHandle handle;
  ros::NodeHandle private_handle;
  ros::Publisher speed, seek, viewpoint;
  ros::Subscriber status, state, description;
};

NodeLink::NodeLink(QObject* parent)
    : QObject(parent), mailbox_(std::make_shared<Mailbox>()), calls_([this](bool is_done, const QString& message) {
        if (is_done) {
          Q_EMIT done(message);
        } else {
          Q_EMIT refused(message);
        }
      }) {
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &NodeLink::poll);
  timer_.start(kPollEvery);
}

NodeLink::~NodeLink() {
  calls_.forget();
  subscribing_.post([connection = std::move(connection_)]() mutable { connection.reset(); });
}

void NodeLink::setNode(const QString& name) {
  const std::string wanted = name.trimmed().toStdString();
  std::string resolved;
  std::string error;
  if (wanted.empty()) {
    error = "it is empty";
  } else if (ros::names::validate(wanted, error)) {
    try {
      resolved = ros::names::resolve(wanted);
    } catch (const ros::InvalidNameException& invalid) {
      error = invalid.what();
    }
  }
  if (resolved.empty()) {
    Q_EMIT refused(
        QString("Expected a node's name, such as /poinsot, got “%1”: %2").arg(name, QString::fromStdString(error)));
    return;
  }
  if (resolved == node_) return;
  node_ = resolved;
  body_.clear();
  giveUp();
  connectAnew();
}

void NodeLink::setBody(const QString& body) {
  if (body.toStdString() == body_) return;
  body_ = body.toStdString();
  follow();
}

void NodeLink::follow() {
  if (!connection_) return;
  subscribing_.post([connection = connection_, body = body_] {
    if (body.empty() || ros::master::check()) connection->watch(body);
  });
}

void NodeLink::onStatus(const NodeStatus& status) {
  since_status_.start();
  if (!std::exchange(alive_, true)) {
    eye_.reset();
    Q_EMIT found();
  }
  Q_EMIT statusReceived(status);
}

void NodeLink::giveUp() {
  alive_ = false;
  calls_.forget();
  Q_EMIT lost();
}

void NodeLink::poll() {
  mailbox_->read();
  calls_.read();
  if (connection_) {
    const std::shared_ptr<Connection> connection = connection_;  // a slot may ask for another node
    connection->queue.callAvailable(ros::WallDuration(0));
  }
  for (Outgoing* outgoing : {&speed_, &seek_, &viewpoint_}) outgoing->flush();
  if (since_status_.isValid() && !since_status_.hasExpired(kSilence)) return;
  if (alive_) giveUp();
  if (!connecting_ && (!since_attempt_.isValid() || since_attempt_.hasExpired(kAttemptEvery))) connectAnew();
}

void NodeLink::connectAnew() {
  if (connecting_) return;  // adopting what is being made, one sees that another is wanted
  connecting_ = true;
  since_attempt_.start();
  subscribing_.post(
      [this, mailbox = mailbox_, node = node_, body = body_, old = std::exchange(connection_, nullptr)]() mutable {
        old.reset();
        std::shared_ptr<Connection> fresh;
        if (ros::master::check()) {  // without a master, subscribing would wait for it
          fresh = std::make_shared<Connection>(this, node);
          fresh->watch(body);
        }
        mailbox->post([this, fresh, body]() mutable {
          connecting_ = false;
          since_attempt_.start();
          if (fresh && fresh->node != node_) {
            fresh.swap(connection_);
            connectAnew();
            return;
          }
          connection_ = std::move(fresh);
          if (body != body_) follow();
        });
      });
}

template <typename Message>
void NodeLink::publish(Outgoing& outgoing, ros::Publisher Connection::*publisher, const Message& message) {
  outgoing.set([this, publisher, message] {
    if (!connection_ || (connection_.get()->*publisher).getNumSubscribers() == 0) return false;
    (connection_.get()->*publisher).publish(message);
    return true;
  });
}

void NodeLink::setSpeed(double speed) {
  std_msgs::Float64 message;
  message.data = speed;
  publish(speed_, &Connection::speed, message);
}

void NodeLink::seek(double time) {
  std_msgs::Float64 message;
  message.data = time;
  publish(seek_, &Connection::seek, message);
}

void NodeLink::setEye(const std::array<double, 3>& eye) {
  if (eye_ == eye) return;
  eye_ = eye;
  geometry_msgs::PointStamped message;
  message.header.stamp = ros::Time::now();
  message.header.frame_id = names::kWorld;
  message.point.x = eye[0];
  message.point.y = eye[1];
  message.point.z = eye[2];
  publish(viewpoint_, &Connection::viewpoint, message);
}

void NodeLink::setPaused(bool paused) {
  std_srvs::SetBool::Request request;
  request.data = paused;
  call<std_srvs::SetBool>(names::kPause, request);
}

void NodeLink::step() {
  call<std_srvs::Trigger>(names::kStep, {});
}

void NodeLink::reset() {
  seek_.drop();  // asked for before
  call<std_srvs::Trigger>(names::kReset, {});
}

void NodeLink::loadScene(const QString& scene) {
  LoadScene::Request request;
  request.scene = scene.toStdString();
  call<LoadScene>(names::kLoadScene, request);
}

void NodeLink::setMethod(const QString& body, const QString& method, double step) {
  SetMethod::Request request;
  request.body = body.toStdString();
  request.method = method.toStdString();
  request.step = step;
  call<SetMethod>(names::kSetMethod, request);
}

}  // namespace poinsot::rviz_panel
