#include "poinsot/ros/cost_meter.h"

#include <algorithm>
#include <cmath>

#include "poinsot/cost/cpu_time.h"

namespace poinsot::node {
namespace {

using cost::threadCpuTime;

constexpr int kTrialSteps = 2000;
constexpr int kTrialStates = 100;
constexpr double kLongestTrial = 1e9;  // s
constexpr double kRenewAfter = 1.0;    // simulated seconds

}  // namespace

CostMeter::CostMeter(Motion motion, double rate) {
  if (motion.inClosedForm()) {
    const double begin = threadCpuTime();
    for (int i = 0; i < kTrialStates; ++i) motion.at(i / rate);
    cost_ = rate * (threadCpuTime() - begin) / kTrialStates;
    return;
  }
  const double simulated = std::min(kTrialSteps * *motion.setup().step, kLongestTrial);
  const double begin = threadCpuTime();
  motion.at(simulated);
  cost_ = stepping_cost_ = (threadCpuTime() - begin) / simulated;
}

void CostMeter::add(double cpu, double simulated) {
  if (simulated == 0) return;  // paused: nothing was moved
  cpu_ += std::max(cpu - cost::clockCost(), 0.0);
  simulated_ += std::abs(simulated);
  if (simulated_ < kRenewAfter) return;
  cost_ = cpu_ / simulated_;
  cpu_ = simulated_ = 0;
}

}  // namespace poinsot::node
