#include "stepper_benchmarks.h"

#include <benchmark/benchmark.h>

#include <string>

#include "poinsot/core/method.h"
#include "regimes.h"

namespace poinsot::benchmarks {
namespace {

constexpr int kBatch = 1000;    // steps to one virtual call, as a simulation takes them
constexpr double kStep = 0.01;  // s; |Ω| is about 1 rad/s

/** An iteration is one step. */
void step(benchmark::State& state, const Method& method, const Start& start) {
  const auto stepper = method.make(start.moments);
  RotationState body = RotationState::fromOmega(start.moments, start.attitude, start.omega);
  while (state.KeepRunningBatch(kBatch)) {
    stepper->advance(body, 0, kStep, kBatch);
    benchmark::DoNotOptimize(body);
  }
}

}  // namespace

void addSteppers() {
  for (const Method& method : freeMethods()) {
    const std::string name = std::string("step/") + method.name;
    benchmark::RegisterBenchmark(name.c_str(), step, method, regime("general").starts.front());
    benchmark::RegisterBenchmark((name + "/near_separatrix").c_str(), step, method,
                                 regime("near_separatrix").starts.front());
  }
}

}  // namespace poinsot::benchmarks
