#include "exhaustive.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "poinsot/core/method.h"

namespace poinsot::exhaustive {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr int kTimes = 300;

/** From the components of the quotient, not from its cosine. */
double angle(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Eigen::Quaterniond q = a.conjugate() * b;
  return 2 * std::atan2(q.vec().norm(), std::abs(q.w()));
}

}  // namespace

std::vector<MotionSetup> randomBodies(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> normal;
  std::vector<MotionSetup> out;
  for (int i = 0; i < count; ++i) {
    // The second moments of mass along the axes may be any positive numbers.
    const Eigen::Vector3d mass(0.05 + unit(random), 0.05 + unit(random), 0.05 + unit(random));
    const Eigen::Vector3d moments(mass[1] + mass[2], mass[2] + mass[0], mass[0] + mass[1]);
    const auto turn = [&] {
      return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
    };
    const Eigen::Matrix3d axes = turn().toRotationMatrix();
    MotionSetup setup;
    setup.inertia = PrincipalInertia::fromTensor(axes * moments.asDiagonal() * axes.transpose());
    setup.attitude = turn();
    const Eigen::Vector3d direction(normal(random), normal(random), normal(random));
    setup.omega_body = std::pow(10, 2 * unit(random) - 1) * direction.normalized();
    out.push_back(setup);
  }
  return out;
}

double errorAt(const MotionSetup& setup, const std::vector<double>& times, double enough) {
  MotionSetup exact_setup = setup;
  exact_setup.method = kClosedForm;
  exact_setup.step.reset();
  Motion motion(setup), exact(exact_setup);
  double worst = 0;
  try {
    for (const double t : times) {
      const double error = angle(motion.at(t).attitude, exact.at(t).attitude);
      if (!(error <= worst)) worst = error;
      if (!(worst <= enough)) return worst;
    }
  } catch (const std::runtime_error&) {
    return kInfinite;
  }
  return worst;
}

std::vector<double> randomTimes(double horizon, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, horizon);
  std::vector<double> times(count);
  for (double& t : times) t = unit(random);
  times.push_back(horizon);
  std::sort(times.begin(), times.end());
  return times;
}

std::vector<Way> waysToKeep(const MotionSetup& setup, double accuracy, double horizon, double rate,
                            double (*least_cost)(const std::string& method, double step, double rate), double most) {
  const std::vector<double> times = randomTimes(horizon, kTimes, 7);
  std::vector<Way> out;
  for (const Method& method : freeMethods()) {
    MotionSetup candidate = setup;
    candidate.method = method.name;
    double step = std::max(1 / rate, 2 / setup.omega_body.norm());
    for (; least_cost(method.name, step, rate) < most; step *= 0.9) {
      candidate.step = step;
      if (errorAt(candidate, times, accuracy) > accuracy) continue;
      out.push_back({method.name, step});
      break;
    }
  }
  return out;
}

}  // namespace poinsot::exhaustive
