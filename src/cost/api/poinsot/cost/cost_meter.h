#pragma once

#include "poinsot/core/motion.h"

namespace poinsot::cost {

/** The measured cost of a motion: CPU seconds per simulated second. */
class CostMeter {
 public:
  /**
   * Begins with a short trial run of a copy of the motion.
   * @param rate at which it will be asked for its state [Hz].
   */
  CostMeter(Motion motion, double rate);

  /**
   * Adds the cost of the last tick. Now and then a copy of the motion is run for some further ticks. Where these are
   * short, a few in a row give the figure, because the cost of a single one is mostly that of cold caches.
   * @param cpu [s], the difference of two calls of threadCpuTime().
   * @param motion now at `time`, to which it was moved by `simulated` [s, either direction].
   */
  void add(double cpu, double simulated, double time, const Motion& motion);

  /** Returns the latest figure. */
  double cost() const { return cost_; }

  /** Returns the cost of the steps alone, from the trial run: this part grows with the speed of play. 0 without steps.
   */
  double steppingCost() const { return stepping_cost_; }

 private:
  double stepping_cost_ = 0;
  double cost_;
  double cpu_ = 0, simulated_ = 0;  ///< since the figure was last renewed
  int ticks_ = 0;                   ///< likewise
};

}  // namespace poinsot::cost
