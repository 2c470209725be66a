#pragma once

#include "poinsot/core/motion.h"

namespace poinsot::node {

/** What a motion costs: CPU seconds per simulated second. */
class CostMeter {
 public:
  /**
   * Begins with a short trial run of a copy of the motion.
   * @param rate at which it will be asked for its state [Hz].
   */
  CostMeter(Motion motion, double rate);

  /** Adds what was measured: CPU time [s], by two calls of threadCpuTime(), of simulated time moved [s, either direction]. */
  void add(double cpu, double simulated);

  /** As measured lately. */
  double cost() const { return cost_; }

  /** Of the stepping alone, as the trial run showed: what a faster play costs more. 0 where there are no steps. */
  double steppingCost() const { return stepping_cost_; }

 private:
  double stepping_cost_ = 0;
  double cost_;
  double cpu_ = 0, simulated_ = 0;  ///< since the figure was last renewed
};

}  // namespace poinsot::node
