#include "poinsot/ros/rebuild.h"

#include <ros/init.h>

#include <chrono>
#include <stdexcept>
#include <utility>

#include "poinsot/cost/settle.h"
#include "poinsot/ros/limits.h"
#include "poinsot/ros/number_text.h"

namespace poinsot::node {
namespace {

// A picture whose longest semi-axis is drawn within these lengths stays as it is; beyond, it is scaled anew [m].
constexpr std::chrono::seconds kPatience{1};  // with a job that was told to end
constexpr double kSmallestKept = 0.55, kLargestKept = 1.35;

std::optional<PictureFrame> ifItFits(const std::optional<PictureFrame>& keep, const scene::Body& body) {
  if (!keep) return std::nullopt;
  const Eigen::Vector3d momentum = body.inertia.moments().cwiseProduct(body.inertia.toPrincipal(body.omega_body));
  const double drawn =
      keep->scale.metres_per_radian_per_second * (momentum.stableNorm() / body.inertia.moments().minCoeff());
  if (drawn >= kSmallestKept && drawn <= kLargestKept) return keep;
  return std::nullopt;
}

void moveAhead(Body& body, double time, const std::atomic<bool>& cancelled) {
  Motion& motion = body.motion();
  const double steps = motion.stepsTo(time);
  if (!(steps <= kMostSteps)) {
    throw std::runtime_error(tooManySteps(body.name(), time, steps, *motion.setup().step));
  }
  cost::prepare(motion, time, cancelled);
  motion.at(time);  // throws where there is nothing to publish
}

Rebuild::Result make(Rebuild::Order order, const ros::NodeHandle& handle, const std::atomic<bool>& cancelled) {
  Rebuild::Result out;
  scene::Scene part;
  for (const std::size_t i : order.bodies) part.bodies.push_back(order.scene.bodies[i]);
  out.said = cost::settleMethods(part, order.rate, cancelled);
  for (std::size_t k = 0; k < order.bodies.size(); ++k) {
    cost::throwIf(cancelled);
    const scene::Body& body = part.bodies[k];
    order.scene.bodies[order.bodies[k]] = body;
    out.bodies.push_back(std::make_unique<Body>(body, order.frame_prefix, order.rate, handle,
                                                k < order.keep.size() ? ifItFits(order.keep[k], body) : std::nullopt));
    moveAhead(*out.bodies.back(), order.time, cancelled);
  }
  out.scene = std::move(order.scene);
  out.indices = std::move(order.bodies);
  return out;
}

}  // namespace

std::string tooManySteps(const std::string& body, double time, double steps, double step) {
  return "body \"" + body + "\": to t = " + shown(time) + " s there are " + shown(steps) + " steps of " + shown(step) +
         " s; allowed: at most " + shown(kMostSteps) + ", nearer to t = 0";
}

Rebuild::~Rebuild() {
  cancel();
  if (!work_.valid()) return;
  // Where the master is gone, roscpp tries to advertise a new body's topics until ROS shuts down.
  while (work_.wait_for(kPatience) != std::future_status::ready) ros::requestShutdown();
}

void Rebuild::start(Order order, const ros::NodeHandle& handle) {
  cancelled_ = false;
  work_ = std::async(std::launch::async, [this, order = std::move(order), handle]() mutable {
    return make(std::move(order), handle, cancelled_);
  });
}

void Rebuild::goOn(Result made, double time) {
  cancelled_ = false;
  work_ = std::async(std::launch::async, [this, made = std::move(made), time]() mutable {
    for (const auto& body : made.bodies) moveAhead(*body, time, cancelled_);
    return std::move(made);
  });
}

std::optional<Rebuild::Result> Rebuild::poll() {
  if (!work_.valid() || work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  return work_.get();
}

}  // namespace poinsot::node
