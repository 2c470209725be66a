#include "node_link.h"

#include <geometry_msgs/PointStamped.h>
#include <poinsot/LoadScene.h>
#include <poinsot/SetMethod.h>
#include <ros/callback_queue.h>
#include <ros/master.h>
#include <ros/names.h>
#include <ros/node_handle.h>
#include <ros/service.h>
#include <std_msgs/Bool.h>
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
constexpr int kLongCall = 1000;      // ms
constexpr int kMostCalls = 20;       // waiting to be answered
constexpr int kStateQueue = 2000;
const char* const kUsualNode = "poinsot";

/** Sends a number that waits to be sent, if somebody listens. */
void send(std::optional<double>& number, ros::Publisher& publisher) {
  if (!number || publisher.getNumSubscribers() == 0) return;
  std_msgs::Float64 message;
  message.data = *number;
  publisher.publish(message);
  number.reset();
}

/** Returns the bodies of a namespace whose states somebody offers to publish. Asks the master. */
QStringList offeredBodies(const std::string& ns) {
  ros::master::V_TopicInfo topics;
  ros::master::getTopics(topics);
  const std::string before = ns == "/" ? ns : ns + "/";
  const std::string after = std::string("/") + names::kState;
  QStringList out;
  for (const ros::master::TopicInfo& topic : topics) {
    if (topic.datatype != ros::message_traits::datatype<BodyState>()) continue;
    const std::size_t rest = before.size() + after.size();
    if (topic.name.size() <= rest || topic.name.compare(0, before.size(), before) != 0) continue;
    const std::string body = topic.name.substr(before.size(), topic.name.size() - rest);
    if (names::topic(body, names::kState) == topic.name.substr(before.size())) out << QString::fromStdString(body);
  }
  out.sort();
  return out;
}

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
    background = private_handle.advertise<std_msgs::Bool>(names::kLightBackground, 10);
    status = private_handle.subscribe<NodeStatus>(
        names::kStatus, 10, [to](const NodeStatus::ConstPtr& message) { to->onStatus(*message); });
    layout = private_handle.subscribe<SceneLayout>(
        names::kLayout, 1, [to](const SceneLayout::ConstPtr& message) { Q_EMIT to->layoutReceived(*message); });
  }

  void watch(const std::string& body) {
    state.shutdown();
    description.shutdown();
    if (body.empty()) return;
    NodeLink* const to = link;
    state = handle.subscribe<BodyState>(
        names::topic(body, names::kState), kStateQueue,
        [to](const BodyState::ConstPtr& message) { to->onState(*message); }, ros::VoidConstPtr(),
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
  ros::Publisher speed, seek, viewpoint, background;
  ros::Subscriber status, layout, state, description;
};

NodeLink::NodeLink(QObject* parent) : QObject(parent), given_(kUsualNode), node_(ros::names::resolve(kUsualNode)) {
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &NodeLink::poll);
  timer_.start(kPollEvery);
}

NodeLink::~NodeLink() {
  calling_.drop();
  subscribing_.post([connection = std::move(connection_)]() mutable {
    connection.reset();
    return nullptr;
  });
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
        QString("Expected a node's name, such as poinsot, got “%1”: %2").arg(name, QString::fromStdString(error)));
    return;
  }
  given_ = name.trimmed();
  if (resolved == node_) return;
  node_ = resolved;
  body_.clear();
  recording_ = false;
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
    return nullptr;
  });
}

void NodeLink::onStatus(const NodeStatus& status) {
  since_status_.start();
  if (!std::exchange(alive_, true)) {
    outbox_.told_eye.reset();
    outbox_.told_light_background.reset();
    recording_ = false;
    Q_EMIT found();
  }
  Q_EMIT statusReceived(status);
}

void NodeLink::onState(const BodyState& state) {
  since_state_.start();
  // A node that is there would have been heard by now.
  if (!alive_ && !connecting_ && since_attempt_.hasExpired(kSilence)) recording_ = true;
  Q_EMIT stateReceived(state);
}

void NodeLink::giveUp() {
  alive_ = false;
  outbox_.speed.reset();
  outbox_.seek.reset();
  calling_.drop();
  calls_.open = 0;
  Q_EMIT lost();
}

bool NodeLink::waiting() const {
  return calls_.open > 0 && calls_.since.hasExpired(kLongCall);
}

void NodeLink::poll() {
  subscribing_.read();
  calling_.read();
  if (const std::shared_ptr<Connection> connection = connection_) {  // kept, as a slot may ask for another node
    connection->queue.callAvailable(ros::WallDuration(0));
    send(outbox_.speed, connection->speed);
    send(outbox_.seek, connection->seek);
  }
  if (since_status_.isValid() && !since_status_.hasExpired(kSilence)) return;
  if (alive_) giveUp();
  if (recording_ && since_state_.isValid() && !since_state_.hasExpired(kAttemptEvery)) return;  // it is heard well
  if (!connecting_ && (!since_attempt_.isValid() || since_attempt_.hasExpired(kAttemptEvery))) connectAnew();
}

void NodeLink::connectAnew() {
  if (connecting_) return;  // adopting what is being made, one sees that another is wanted
  connecting_ = true;
  since_attempt_.start();
  subscribing_.post([this, node = node_, body = body_, old = std::exchange(connection_, nullptr)]() mutable {
    old.reset();
    std::shared_ptr<Connection> fresh;
    QStringList offered;
    if (ros::master::check()) {  // without a master, subscribing would wait for it
      fresh = std::make_shared<Connection>(this, node);
      fresh->watch(body);
      offered = offeredBodies(ros::names::parentNamespace(node));
    }
    return [this, fresh, body, offered]() mutable {
      connecting_ = false;
      since_attempt_.start();
      connection_ = std::move(fresh);  // moved, so that the worker may destroy it
      if (connection_ && connection_->node != node_) {
        connectAnew();
      } else if (body != body_) {
        follow();
      }
      if (!alive_ && !offered.isEmpty()) Q_EMIT bodiesOffered(offered);
    };
  });
}

void NodeLink::setEye(const std::array<double, 3>& eye) {
  if (outbox_.told_eye == eye || !connection_ || connection_->viewpoint.getNumSubscribers() == 0) return;
  outbox_.told_eye = eye;
  geometry_msgs::PointStamped message;
  message.header.stamp = ros::Time::now();
  message.header.frame_id = names::kWorld;
  message.point.x = eye[0];
  message.point.y = eye[1];
  message.point.z = eye[2];
  connection_->viewpoint.publish(message);
}

void NodeLink::setLightBackground(bool light) {
  if (outbox_.told_light_background == light || !connection_ || connection_->background.getNumSubscribers() == 0)
    return;
  outbox_.told_light_background = light;
  std_msgs::Bool message;
  message.data = light;
  connection_->background.publish(message);
}

template <typename Service>
void NodeLink::call(const char* name, const typename Service::Request& request) {
  if (calls_.open >= kMostCalls) {
    Q_EMIT refused("The node has not answered yet; wait a moment.");
    return;
  }
  if (calls_.open++ == 0) calls_.since.start();
  calling_.post([this, service = node_ + "/" + name, question = request]() mutable {
    typename Service::Response answer;
    const bool reached = ros::service::call(service, question, answer);
    if (!reached) answer.message = "No answer from " + service + ".";
    return [this, is_done = reached && answer.success, message = QString::fromStdString(answer.message)] {
      --calls_.open;
      calls_.since.start();
      if (is_done) {
        Q_EMIT done(message);
      } else {
        Q_EMIT refused(message);
      }
    };
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
  Q_EMIT resetting();
  outbox_.seek.reset();                                      // asked for before
  if (connection_) send(outbox_.speed, connection_->speed);  // so that t runs forwards from its start on
  call<std_srvs::Trigger>(names::kReset, {});
}

void NodeLink::loadScene(const QString& scene) {
  LoadScene::Request request;
  request.scene = scene.toStdString();
  outbox_.seek.reset();  // asked for before
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
