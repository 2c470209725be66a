#include "node_link.h"

#include <geometry_msgs/PointStamped.h>
#include <poinsot/LoadScene.h>
#include <poinsot/SetMethod.h>
#include <ros/callback_queue.h>
#include <ros/master.h>
#include <ros/names.h>
#include <ros/node_handle.h>
#include <ros/service.h>
#include <std_msgs/Float64.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <utility>

#include "poinsot/ros/names.h"

namespace poinsot::rviz_panel {
namespace {

namespace names = node::names;

constexpr int kPollEvery = 50;              // ms
constexpr int kSilence = 1500;              // ms, after which a node counts as gone
constexpr int kAttemptEvery = 2000;         // ms, from when the last attempt was ready to hear
constexpr int kPatienceForListener = 3000;  // ms, after which what nobody listened to is dropped
constexpr int kLongCall = 1000;             // ms
constexpr int kMostCalls = 20;              // waiting to be answered
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
    status = private_handle.subscribe<NodeStatus>(names::kStatus, 10, [to](const NodeStatus::ConstPtr& message) {
      to->since_status_.start();
      const bool is_new = !std::exchange(to->alive_, true);
      if (is_new) Q_EMIT to->found();
      Q_EMIT to->statusReceived(*message);
    });
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

NodeLink::NodeLink(QObject* parent) : QObject(parent), mailbox_(std::make_shared<Mailbox>()) {
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &NodeLink::poll);
  timer_.start(kPollEvery);
}

NodeLink::~NodeLink() {
  calling_.drop();
  subscribing_.post([connection = std::move(connection_)]() mutable { connection.reset(); });
}

void NodeLink::setNode(const QString& name) {
  std::string error;
  const std::string wanted = name.trimmed().toStdString();
  if (wanted.empty() || !ros::names::validate(wanted, error)) {
    Q_EMIT refused(wanted.empty()
                       ? "A node's name is needed, such as /poinsot."
                       : QString("“%1” cannot be a node's name: %2").arg(name, QString::fromStdString(error)));
    return;
  }
  std::string resolved;
  try {
    resolved = ros::names::resolve(wanted);
  } catch (const ros::InvalidNameException& invalid) {
    Q_EMIT refused(QString("“%1” cannot be a node's name: %2").arg(name, invalid.what()));
    return;
  }
  if (resolved == node_) return;
  node_ = resolved;
  body_.clear();
  alive_ = false;
  calling_.drop();
  calls_ = 0;
  ++generation_;
  Q_EMIT lost();
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

bool NodeLink::waiting() const {
  return calls_ > 0 && since_call_.hasExpired(kLongCall);
}

void NodeLink::poll() {
  mailbox_->read();
  if (connection_) {
    const std::shared_ptr<Connection> connection = connection_;  // a slot may ask for another node
    connection->queue.callAvailable(ros::WallDuration(0));
  }
  for (Outgoing* outgoing : {&speed_, &seek_, &viewpoint_}) flush(*outgoing);
  if (since_status_.isValid() && !since_status_.hasExpired(kSilence)) return;
  if (std::exchange(alive_, false)) {
    calling_.drop();
    calls_ = 0;
    ++generation_;
    Q_EMIT lost();
  }
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

void NodeLink::set(Outgoing& outgoing, std::function<bool()> send) {
  outgoing.send = std::move(send);
  outgoing.since_set.start();
  if (!outgoing.since_sent.isValid() || outgoing.since_sent.hasExpired(kPollEvery)) flush(outgoing);
}

void NodeLink::flush(Outgoing& outgoing) {
  if (!outgoing.send) return;
  if (outgoing.send()) {
    outgoing.send = nullptr;
    outgoing.since_sent.start();
  } else if (outgoing.since_set.hasExpired(kPatienceForListener)) {
    outgoing.send = nullptr;
  }
}

template <typename Message>
void NodeLink::publish(Outgoing& outgoing, ros::Publisher Connection::*publisher, const Message& message) {
  set(outgoing, [this, publisher, message] {
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

void NodeLink::setViewpoint(double x, double y, double z) {
  geometry_msgs::PointStamped message;
  message.header.stamp = ros::Time::now();
  message.header.frame_id = names::kWorld;
  message.point.x = x;
  message.point.y = y;
  message.point.z = z;
  publish(viewpoint_, &Connection::viewpoint, message);
}

template <typename Service>
void NodeLink::call(const char* name, const typename Service::Request& request) {
  if (calls_ >= kMostCalls) {
    Q_EMIT refused("The node has not answered yet; wait a moment.");
    return;
  }
  if (calls_++ == 0) since_call_.start();
  calling_.post([this, mailbox = mailbox_, full = node_ + "/" + name, request, generation = generation_] {
    typename Service::Request question = request;
    typename Service::Response answer;
    const bool reached = ros::service::call(full, question, answer);
    mailbox->post([this, full, reached, answer, generation] {
      if (generation != generation_) return;  // of a node that was given up meanwhile
      --calls_;
      since_call_.start();
      if (!reached) {
        Q_EMIT refused(QString("No answer from %1.").arg(QString::fromStdString(full)));
      } else if (answer.success) {
        Q_EMIT done(QString::fromStdString(answer.message));
      } else {
        Q_EMIT refused(QString::fromStdString(answer.message));
      }
    });
  });
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
  seek_.send = nullptr;  // asked for before
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
