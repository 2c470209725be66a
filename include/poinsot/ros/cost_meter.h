#pragma once

#include "poinsot/core/motion.h"

namespace poinsot::node {

/** What a motion costs: CPU seconds per simulated second. */
class CostMeter {
 public:
  /** Begins with a short trial run of a copy of the motion. */
  explicit CostMeter(Motion motion);

  /** Adds what was measured: CPU time spent [s] on simulated time moved [s, either direction]. */
  void add(double cpu, double simulated);

  /** As measured lately. */
  double cost() const { return cost_; }

  /** Of the stepping alone, as the trial run showed: what a faster play would cost. */
  double trialCost() const { return trial_cost_; }

 private:
  double trial_cost_;
  double cost_;
  double cpu_ = 0, simulated_ = 0;  ///< since the figure was last renewed
};

/** CPU time of the calling thread [s]. */
double threadCpuTime();

}  // namespace poinsot::node
