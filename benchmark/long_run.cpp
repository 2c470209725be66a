#include "long_run.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

#include "hard_case_judge.h"
#include "poinsot/core/method.h"

namespace {

using namespace poinsot;

/** The peak memory of this process [kB]; -1 where the system does not tell. */
long peakMemory() {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line)) {
    if (line.rfind("VmHWM:", 0) == 0) return std::stol(line.substr(6));
  }
  return -1;
}

bool printRow(const Method& method, const HardCase& full) {
  const long before = peakMemory();
  const auto begin = std::chrono::steady_clock::now();
  const Measured after = measure(method, full);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const long memory = peakMemory();
  HardCase part = full;
  part.steps = full.steps / 100;
  const Measured earlier = measure(method, part);
  const Promise promise = promiseOf(method, full, judgeStep(method, full.moments, full.omega, full.step));
  const std::vector<std::string> complaints = broken(promise, after);
  std::printf("| %s | %s | %.0e | %.0e, %.0e | %.1e, %.1e | %.0f | %ld → %ld%s |\n", method.name, full.name.c_str(),
              after.norm, earlier.momentum, after.momentum, earlier.energy, after.energy, seconds, before, memory,
              complaints.empty() ? "" : " **BROKEN**");
  std::fflush(stdout);
  for (const std::string& complaint : complaints) {
    std::fprintf(stderr, "hard_cases: %s, %s: %s\n", full.name.c_str(), method.name, complaint.c_str());
  }
  return complaints.empty() && memory == before;
}

}  // namespace

bool printLongRuns() {
  std::printf(
      "\n## 1e8 steps\n\n"
      "Greatest changes within 1e6 steps and within 1e8. What is conserved does not drift: rounding errors do not add "
      "up "
      "with n.\n"
      "The energy of a method that does not conserve it drifts as its order allows. Memory: VmHWM of the process "
      "before\n"
      "and after.\n\n"
      "| method | body | norm | L at 1e6, 1e8 | E at 1e6, 1e8 | CPU [s] | memory [kB] "
      "|\n|---|---|---|---|---|---|---|\n");
  bool good = true;
  for (const Method& method : freeMethods()) {
    for (const HardCase& body : longRuns()) good = printRow(method, body) && good;
  }
  return good;
}
