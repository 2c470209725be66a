// Listens to a running node as a stranger would, and audits what comes. Parameters, private:
//   ~duration [s, wall clock] (5)   ~bodies (list of names)   ~namespaces (of the nodes: list or one string) ("/")
//   ~expect_failure (regular expression that the explanation of a failed check must match; empty: all must pass)
//   ~without (list: markers, odometry, tf)   ~losses (share of messages that the network may lose) (0.01)

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <limits>
#include <map>
#include <regex>
#include <sstream>

#include "poinsot/audit/audit.h"

namespace {

using poinsot::audit::Audit;
using poinsot::audit::Options;
using poinsot::audit::Report;

constexpr double kPatience = 15;  // s, wall clock, until every topic has spoken
constexpr std::uint32_t kQueue = 20000;

class Listener {
 public:
  explicit Listener(const Options& options) : audit_(options) {}

  template <typename Message>
  void listen(const std::string& topic) {
    heard_[topic] = 0;
    subscribe<Message>(topic, [this, topic](const Message& message) { audit_.add(message, topic); });
  }

  void listenToTf(const std::string& topic, bool is_static) {
    heard_[topic] = 0;
    subscribe<tf2_msgs::TFMessage>(topic,
                                   [this, is_static](const tf2_msgs::TFMessage& m) { audit_.add(m, is_static); });
  }

  /** The topics that have said nothing yet. */
  std::string silent() const {
    std::string names;
    for (const auto& [topic, count] : heard_) {
      if (count == 0) names += " " + topic;
    }
    return names;
  }

  Report report() const { return audit_.report(); }

 private:
  template <typename Message, typename Add>
  void subscribe(const std::string& topic, const Add& add) {
    const boost::function<void(const boost::shared_ptr<const Message>&)> hear =
        [this, topic, add](const boost::shared_ptr<const Message>& message) {
          ++heard_[topic];
          add(*message);
        };
    subscribers_.push_back(
        node_.subscribe<Message>(topic, kQueue, hear, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
  }

  ros::NodeHandle node_;
  Audit audit_;
  std::map<std::string, int> heard_;
  std::vector<ros::Subscriber> subscribers_;
};

/** A list parameter, or one string, whose names may be separated by commas or spaces. */
std::vector<std::string> listOf(const ros::NodeHandle& node, const std::string& name,
                                const std::vector<std::string>& otherwise) {
  std::vector<std::string> list;
  std::string one;
  if (node.getParam(name, list)) return list;
  if (!node.getParam(name, one)) return otherwise;
  for (char& c : one) {
    if (c == ',' || c == '[' || c == ']') c = ' ';
  }
  std::istringstream words(one);
  while (words >> one) list.push_back(one);
  return list.empty() ? otherwise : list;
}

/** Wall clock: simulated time may stand still. */
template <typename Done>
void spinUntil(const Done& done, double seconds) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (ros::ok() && ros::WallTime::now() < end && !done()) {
    ros::spinOnce();
    ros::WallDuration(0.002).sleep();
  }
}

TEST(AuditLive, Stream) {
  const ros::NodeHandle parameters("~");
  const std::vector<std::string> bodies = listOf(parameters, "bodies", {});
  ASSERT_FALSE(bodies.empty()) << "~bodies names nothing to listen to";

  Options options;
  // Subscriptions begin and end when they please: judge where topics overlap.
  options.ends = std::numeric_limits<double>::infinity();
  options.losses = parameters.param("losses", 0.01);
  for (const std::string& what : listOf(parameters, "without", {})) {
    if (what == "markers") options.markers = false;
    if (what == "odometry") options.odometry = false;
    if (what == "tf") options.tf = false;
  }

  Listener listener(options);
  for (std::string ns : listOf(parameters, "namespaces", {"/"})) {
    if (ns.empty() || ns.back() != '/') ns += "/";
    if (ns[0] != '/') ns = "/" + ns;
    for (const std::string& body : bodies) {
      listener.listen<poinsot::BodyState>(ns + body + "/state");
      listener.listen<poinsot::BodyDescription>(ns + body + "/description");
      if (options.odometry) listener.listen<nav_msgs::Odometry>(ns + body + "/odometry");
    }
    if (!options.markers) continue;
    listener.listen<visualization_msgs::MarkerArray>(ns + "markers");
    listener.listen<visualization_msgs::MarkerArray>(ns + "markers_static");
  }
  if (options.tf) {
    listener.listenToTf("/tf", false);
    listener.listenToTf("/tf_static", true);
  }

  spinUntil([&listener] { return listener.silent().empty(); }, kPatience);
  EXPECT_EQ(listener.silent(), "") << "nothing came on these topics";
  spinUntil([] { return false; }, parameters.param("duration", 5.0));

  const Report report = listener.report();
  std::ostringstream printed;
  printed << report;
  std::cout << printed.str();
  for (const std::string& body : bodies) {
    bool judged = false;
    for (const auto& check : report.checks) {
      const std::string tail = "/" + body;
      judged = judged || (check.body.size() >= tail.size() &&
                          check.body.compare(check.body.size() - tail.size(), tail.size(), tail) == 0);
    }
    EXPECT_TRUE(judged) << "nothing was judged of " << body;
  }

  const std::string expected = parameters.param("expect_failure", std::string());
  if (expected.empty()) {
    std::string failed;
    for (const auto& check : report.failures()) {
      failed += "\n" + check.body + ": " + check.name + ": " + check.detail;
    }
    EXPECT_TRUE(report.passed()) << failed;
    return;
  }
  bool found = false;
  for (const auto& check : report.failures()) found = found || std::regex_search(check.detail, std::regex(expected));
  EXPECT_TRUE(found) << "no failed check says \"" << expected << "\"";
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "audit_live");
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
