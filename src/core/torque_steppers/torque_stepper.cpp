#include "torque_steppers/torque_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poinsot::torque_steppers {

Work TorqueStepper::advance(RotationState& state, std::int64_t first, double step, std::int64_t count) const {
  RotationState moved = state;  // a step may throw
  Work work;
  for (std::int64_t n = first; n < first + count; ++n) {
    work += advanceFrom(moved, static_cast<double>(n) * step, step);
  }
  state = moved;
  return work;
}

Work TorqueStepper::advanceFrom(RotationState& state, double time, double length) const {
  const std::vector<double>& switches = torques_.switches();
  if (switches.empty()) return step(state, time, length, torques_.constant(0));

  const double end = time + length;
  // A switch that differs from an end of the step by rounding only lies at that end.
  const double near = 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(time), std::abs(end));
  const double low = std::min(time, end) + near, high = std::max(time, end) - near;
  const auto first = std::upper_bound(switches.begin(), switches.end(), low);
  const auto last = std::lower_bound(first, switches.end(), high);
  const auto count = last - first;
  RotationState moved = state;  // step() may throw
  Work work;
  double from = time;
  for (std::ptrdiff_t i = 0; i <= count; ++i) {
    const bool at_end = i == count;
    const double to = at_end ? end : length > 0 ? first[i] : last[-1 - i];
    const double part = at_end ? length - (from - time) : to - from;
    work += step(moved, from, part, torques_.constant(torques_.intervalAt(0.5 * (from + to))));
    from = to;
  }
  state = moved;
  return work;
}

}  // namespace poinsot::torque_steppers
