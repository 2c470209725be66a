#include "closed_form_benchmarks.h"

#include <benchmark/benchmark.h>

#include <string>

#include "poinsot/core/closed_form.h"
#include "regimes.h"

namespace poinsot::benchmarks {
namespace {

constexpr double kSpacing = 1.0 / 60;  // s, of the grids

ClosedForm closedForm(const Start& start) {
  return {start.moments, start.attitude, start.omega};
}

/** One set-up after another, for different starts. */
void setup(benchmark::State& state, const Regime& regime) {
  std::size_t i = 0;
  for (auto _ : state) {
    ClosedForm form = closedForm(regime.starts[i]);
    benchmark::DoNotOptimize(form);
    if (++i == regime.starts.size()) i = 0;
  }
}

/** One body at random times, so that neither branch prediction nor reuse helps. */
void at(benchmark::State& state, const Regime& regime) {
  const ClosedForm form = closedForm(regime.starts.front());
  std::size_t i = 0;
  for (auto _ : state) {
    ClosedForm::State there = form.at(regime.times[i]);
    benchmark::DoNotOptimize(there);
    if (++i == regime.times.size()) i = 0;
  }
}

/** Whole grids, each with another start time; an iteration is one state. */
void samplePerState(benchmark::State& state, const Regime& regime, Eigen::Index count) {
  const ClosedForm form = closedForm(regime.starts.front());
  ClosedForm::Samples table(count, 7);
  std::size_t i = 0;
  while (state.KeepRunningBatch(count)) {
    form.sample(regime.times[i], kSpacing, table);
    benchmark::DoNotOptimize(table.data());
    benchmark::ClobberMemory();
    if (++i == regime.times.size()) i = 0;
  }
}

void add(const Regime& regime, const std::string& suffix) {
  benchmark::RegisterBenchmark(("closed_form/setup" + suffix).c_str(), setup, regime);
  benchmark::RegisterBenchmark(("closed_form/at" + suffix).c_str(), at, regime);
}

}  // namespace

void addClosedForm() {
  add(regime("general"), "");
  benchmark::RegisterBenchmark("closed_form/sample_per_state", samplePerState, regime("general"), 6000);
  for (const Regime& regime : regimes()) {
    add(regime, "/" + regime.name);
    for (const int count : {6000, 100}) {
      const std::string name = "closed_form/sample_per_state/" + regime.name + "/" + std::to_string(count);
      benchmark::RegisterBenchmark(name.c_str(), samplePerState, regime, count);
    }
  }
}

}  // namespace poinsot::benchmarks
