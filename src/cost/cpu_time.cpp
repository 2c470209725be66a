#include "poinsot/cost/cpu_time.h"

#include <time.h>

#include <algorithm>

namespace poinsot::cost {
namespace {

constexpr int kReadings = 200;

double measureClock() {
  double least = 1;
  for (int i = 0; i < kReadings; ++i) {
    const double begin = threadCpuTime();
    least = std::min(least, threadCpuTime() - begin);
  }
  return least;
}

}  // namespace

double threadCpuTime() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double clockCost() {
  static const double cost = measureClock();
  return cost;
}

}  // namespace poinsot::cost
