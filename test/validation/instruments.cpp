#include "instruments.h"

#include <boost/math/tools/roots.hpp>
#include <cmath>

#include "cases.h"

namespace poinsot::validation {

namespace {

const double kTurn = 2 * std::acos(-1.0);

double difference(double to, double from) {
  return std::remainder(to - from, kTurn);
}

template <typename Function>
double root(const Function& function, double a, double b, double at_a, double at_b) {
  if (at_a == 0) return a;
  if (at_b == 0) return b;
  boost::uintmax_t most = 200;
  const auto bracket =
      boost::math::tools::toms748_solve(function, std::min(a, b), std::max(a, b), a < b ? at_a : at_b,
                                        a < b ? at_b : at_a, boost::math::tools::eps_tolerance<double>(52), most);
  return 0.5 * (bracket.first + bracket.second);
}

}  // namespace

double stride(const MotionSetup& setup) {
  const Eigen::Vector3d moments = setup.inertia.moments();
  return 0.1 * moments.minCoeff() / moments.cwiseProduct(setup.omega_body).norm();
}

Reading middleOmega(const MotionSetup& setup) {
  const Eigen::Vector3d moments = setup.inertia.moments();
  int low = 0, high = 0;
  for (int i = 1; i < 3; ++i) {
    if (moments[i] < moments[low]) low = i;
    if (moments[i] >= moments[high]) high = i;
  }
  const int middle = 3 - low - high;
  return [middle](const MotionState& state) { return state.omega_body[middle]; };
}

std::vector<double> signChanges(Motion& motion, const Reading& reading, std::size_t count, double stride, long most) {
  std::vector<double> times;
  const auto value = [&](double t) { return reading(motion.at(t)); };
  double t = 0, now = value(0);
  for (long i = 1; i <= most && times.size() < count; ++i) {
    const double next = static_cast<double>(i) * stride, then = value(next);
    if ((now < 0) != (then < 0)) times.push_back(root(value, t, next, now, then));
    t = next;
    now = then;
  }
  return times;
}

double periodBySignChanges(const MotionSetup& setup, const Reading& reading) {
  Motion motion(setup);
  const std::vector<double> times = signChanges(motion, reading, 3, stride(setup));
  return times.size() == 3 ? times[2] - times[0] : kNone;
}

Reading azimuthAboutMomentum(const MotionSetup& setup, const Eigen::Vector3d& body_axis) {
  const Eigen::Vector3d momentum = Motion(setup).at(0).momentum_world.normalized();
  const Eigen::Vector3d east = momentum.unitOrthogonal(), north = momentum.cross(east);
  return [=](const MotionState& state) {
    const Eigen::Vector3d axis = state.attitude * body_axis;
    return std::atan2(axis.dot(north), axis.dot(east));
  };
}

Reading turnAboutAxis(int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  return [=](const MotionState& state) {
    const Eigen::Vector3d momentum = state.attitude.conjugate() * state.momentum_world;
    // The body turns about the axis as L turns about it, as seen from the body, the other way round.
    return -std::atan2(momentum[j], momentum[i]);
  };
}

double turned(Motion& motion, const Reading& angle, double t0, double t1, double stride) {
  const long count = static_cast<long>(std::ceil(std::abs((t1 - t0) / stride)));
  double sum = 0, last = angle(motion.at(t0));
  for (long i = 1; i <= count; ++i) {
    const double next =
        angle(motion.at(i == count ? t1 : t0 + (t1 - t0) * static_cast<double>(i) / static_cast<double>(count)));
    sum += difference(next, last);
    last = next;
  }
  return sum;
}

double whenTurned(Motion& motion, const Reading& angle, double by, double stride, long most) {
  double t = 0, sum = 0, last = angle(motion.at(0));
  for (long i = 1; i <= most; ++i) {
    const double next = static_cast<double>(i) * stride, then = angle(motion.at(next)),
                 after = sum + difference(then, last);
    if (std::abs(after) >= by) {
      const double goal = std::copysign(by, after);
      const auto missing = [&](double at) { return sum + difference(angle(motion.at(at)), last) - goal; };
      return root(missing, t, next, sum - goal, after - goal);
    }
    t = next;
    sum = after;
    last = then;
  }
  return kNone;
}

}  // namespace poinsot::validation
