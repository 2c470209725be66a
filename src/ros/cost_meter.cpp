#include "poinsot/ros/cost_meter.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "poinsot/cost/cpu_time.h"

namespace poinsot::node {
namespace {

using cost::threadCpuTime;

constexpr int kTrialSteps = 2000;
constexpr int kTrialStates = 100;
constexpr double kLongestTrial = 1e9;  // s
constexpr double kRenewAfter = 1.0;    // simulated seconds
constexpr int kRenewAfterTicks = 20;
constexpr double kShortTick = 20e-6;  // CPU s
constexpr int kWarmingTicks = 5, kReplayedTicks = 20;

/** Cost of the ticks that come after `time`, if the motion has states there. */
std::optional<double> replayed(Motion motion, double time, double tick) {
  try {
    for (int i = 1; i <= kWarmingTicks; ++i) motion.at(time + i * tick);
    const double begin = threadCpuTime();
    for (int i = 1; i <= kReplayedTicks; ++i) motion.at(time + (kWarmingTicks + i) * tick);
    const double cpu = threadCpuTime() - begin - cost::clockCost();
    return std::max(cpu, 0.0) / (kReplayedTicks * std::abs(tick));
  } catch (const std::runtime_error&) {  // the tick that gets there says so
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
    } catch (const std::runtime_error&) {  // torques may drive it out of the range of doubles before
      simulated *= 0.5;
      if (simulated < *motion.setup().step) throw;
    }
  }
}

void CostMeter::add(double cpu, double simulated, double time, const Motion& motion) {
  if (simulated == 0) return;  // paused: nothing was moved
  cpu_ += std::max(cpu - cost::clockCost(), 0.0);
  simulated_ += std::abs(simulated);
  ++ticks_;
  if (simulated_ < kRenewAfter || ticks_ < kRenewAfterTicks) return;
  const double measured = cpu_ / simulated_;
  cost_ = cpu_ / ticks_ < kShortTick ? replayed(motion, time, simulated).value_or(measured) : measured;
  cpu_ = simulated_ = ticks_ = 0;
}

}  // namespace poinsot::node
