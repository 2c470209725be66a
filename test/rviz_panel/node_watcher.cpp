#include "node_watcher.h"

#include <signal.h>

NodeWatcher::NodeWatcher(const std::string& body) {
  handle_.setCallbackQueue(&queue_);
  subscribers_ = {handle_.subscribe<poinsot::BodyState>("/" + body + "/state", 1000,
                                                        [this](const poinsot::BodyState::ConstPtr& message) {
                                                          if (states++ == 0) first_state = *message;
                                                          state = *message;
                                                        }),
                  handle_.subscribe<poinsot::BodyDescription>(
                      "/" + body + "/description", 10,
                      [this](const poinsot::BodyDescription::ConstPtr& message) { description = *message; }),
                  handle_.subscribe<std_msgs::Float64>("/poinsot/seek", 1000,
                                                       [this](const std_msgs::Float64::ConstPtr& message) {
                                                         ++seeks;
                                                         seek = message->data;
                                                       }),
                  handle_.subscribe<geometry_msgs::PointStamped>(
                      "/poinsot/viewpoint", 1000, [this](const geometry_msgs::PointStamped::ConstPtr& message) {
                        ++viewpoints;
                        viewpoint = *message;
                      })};
}

void NodeWatcher::hear() {
  queue_.callAvailable(ros::WallDuration(0));
}

void NodeWatcher::forget() {
  hear();
  states = seeks = viewpoints = 0;
}

Program::Program(const QString& file, const QStringList& arguments) {
  process_.setProcessChannelMode(QProcess::ForwardedChannels);
  process_.start(file, arguments);
  process_.waitForStarted();
}

Program::~Program() {
  kill();
}

void Program::kill() {
  process_.kill();
  process_.waitForFinished();
}

void Program::freeze() {
  ::kill(static_cast<pid_t>(process_.processId()), SIGSTOP);
}

void Program::thaw() {
  ::kill(static_cast<pid_t>(process_.processId()), SIGCONT);
}
