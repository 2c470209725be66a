// Measures the closed form and the methods. doc/benchmarks.md says what the names mean.
#include <benchmark/benchmark.h>

#include "closed_form_benchmarks.h"
#include "peer_benchmarks.h"
#include "stepper_benchmarks.h"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  poinsot::benchmarks::addPeers();
  poinsot::benchmarks::addClosedForm();
  poinsot::benchmarks::addSteppers();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
