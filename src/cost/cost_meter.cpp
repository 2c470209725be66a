#include "poinsot/cost/cost_meter.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "poinsot/cost/cpu_time.h"

namespace poinsot::cost {
namespace {

constexpr int kTrialSteps = 2000;
constexpr int kTrialStates = 100;
constexpr double kLongestTrial = 1e9;  // s
constexpr double kRenewAfter = 1.0;    // simulated seconds
constexpr int kRenewAfterTicks = 20;
constexpr double kShortTick = 20e-6;  // CPU s
constexpr double kLongTick = 1e-3;    // CPU s: too long to be an effect of caches
constexpr int kWarmingTicks = 5, kReplayedTicks = 20;

/** Returns the CPU time of `ticks` ticks after `time`, and advances `time` to the last of them. */
double timed(Motion& motion, double& time, double tick, int ticks) {
  const double begin = threadCpuTime();
  for (int i = 0; i < ticks; ++i) motion.at(time += tick);
  return std::max(threadCpuTime() - begin - clockCost(), 0.0);
}

/** Returns the cost of the ticks after `time`, if they are short and the motion has states there. */
std::optional<double> replayed(Motion motion, double time, double tick) {
  try {
    double least = timed(motion, time, tick, 1);
    for (int i = 1; i < kWarmingTicks; ++i) least = std::min(least, timed(motion, time, tick, 1));
    if (least > kShortTick) return std::nullopt;
    return timed(motion, time, tick, kReplayedTicks) / (kReplayedTicks * std::abs(tick));
  } catch (const std::runtime_error&) {  // the tick that reaches this time will report it
    return std::nullopt;
  }
}

}  // namespace

CostMeter::CostMeter(Motion motion, double rate) {
  if (motion.inClosedForm()) {
    const double begin = threadCpuTime();
    for (int i = 0; i < kTrialStates; ++i) motion.at(i / rate);
    cost_ = rate * (threadCpuTime() - begin) / kTrialStates;
    return;
  }
  double simulated = std::min(kTrialSteps * *motion.setup().step, kLongestTrial);
  while (true) {
    try {
      Motion trial(motion);
      const double begin = threadCpuTime();
      trial.at(simulated);
      cost_ = stepping_cost_ = (threadCpuTime() - begin) / simulated;
      return;
    } catch (const std::runtime_error&) {  // torques may drive it out of the range of doubles earlier
      simulated *= 0.5;
      if (simulated < *motion.setup().step) throw;
    }
  }
}

void CostMeter::add(double cpu, double simulated, double time, const Motion& motion) {
  if (simulated == 0) return;  // paused
  cpu_ += std::max(cpu - clockCost(), 0.0);
  simulated_ += std::abs(simulated);
  ++ticks_;
  if (simulated_ < kRenewAfter || ticks_ < kRenewAfterTicks) return;
  const double measured = cpu_ / simulated_;
  // The mean tick: the last one alone may be very short, at a pause.
  const double tick = std::copysign(simulated_ / ticks_, simulated);
  cost_ = cpu_ / ticks_ > kLongTick ? measured : replayed(motion, time, tick).value_or(measured);
  cpu_ = simulated_ = ticks_ = 0;
}

}  // namespace poinsot::cost
