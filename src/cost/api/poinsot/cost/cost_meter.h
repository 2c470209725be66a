#pragma once

#include "poinsot/core/motion.h"

namespace poinsot::cost {

/** What a motion costs: CPU seconds per simulated second. */
class CostMeter {
 public:
  /**
   * Begins with a short trial run of a copy of the motion.
   * @param rate at which it will be asked for its state [Hz].
   */
  CostMeter(Motion motion, double rate);

  /**
   * Takes what the last tick cost. Now and then ticks are played on with a copy of the motion: where they prove short,
   * a few in a row are the figure, for one alone costs more for caches that others have filled than for the motion.
   * @param cpu [s], the difference of two calls of threadCpuTime().
   * @param motion now at `time`, to which it was moved by `simulated` [s, either direction].
   */
  void add(double cpu, double simulated, double time, const Motion& motion);

  /** As measured lately. */
  double cost() const { return cost_; }

  /** Of the stepping alone, as the trial run showed: what a faster play costs more. 0 where there are no steps. */
  double steppingCost() const { return stepping_cost_; }

 private:
  double stepping_cost_ = 0;
  double cost_;
  double cpu_ = 0, simulated_ = 0;  ///< since the figure was last renewed
  int ticks_ = 0;                   ///< likewise
};

}  // namespace poinsot::cost
