/** Checks whether `accuracy:` is kept, and compares its cost with that of the cheapest method and step: prints
 * Markdown. */
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "exhaustive.h"
#include "poinsot/core/method.h"
#include "poinsot/cost/choice.h"
#include "poinsot/cost/cpu_time.h"
#include "poinsot/cost/method_costs.h"

namespace {

using namespace poinsot;
using cost::threadCpuTime;

constexpr double kRate = 60, kHorizon = 100;  // Hz, s
constexpr int kBodies = 30;
constexpr unsigned kSeed = 1758;
constexpr int kJudgedDigits = 11;  // of the steppers' accuracy

/** CPU seconds per simulated second to compute the state at every tick: the fastest of several runs. */
double measuredCost(MotionSetup setup, const std::string& method, std::optional<double> step) {
  setup.method = method;
  setup.step = step;
  const Motion start(setup);
  double best = 1e9;
  const int ticks = 300;
  [[maybe_unused]] volatile double sink = 0;
  for (int r = 0; r < 7; ++r) {
    Motion motion = start;
    const double begin = threadCpuTime();
    for (int i = 1; i <= ticks; ++i) sink = motion.at(i / kRate).attitude.w();
    best = std::min(best, (threadCpuTime() - begin) / (ticks / kRate));
  }
  return best;
}

/** In the search: steps cost at least 15 ns each. */
double leastCost(const std::string&, double step, double) {
  return 15e-9 / step;
}

struct Row {
  int chosen = 0, kept = 0, refused = 0, refused_wrongly = 0;
  double worst_error = 0, worst_cost = 0, median_cost = 0;
  std::map<std::string, int> methods;
};

/** @param with_costs also measures them, and searches all methods and steps for a cheaper way. */
Row measure(const std::vector<MotionSetup>& bodies, double accuracy, bool with_closed_form, bool with_costs) {
  std::vector<std::string> candidates;
  if (with_closed_form) candidates.push_back(kClosedForm);
  for (const Method& method : freeMethods()) candidates.push_back(method.name);
  const std::vector<double> times = exhaustive::randomTimes(kHorizon, 3000, 5);
  Row row;
  std::vector<double> ratios;
  for (const MotionSetup& body : bodies) {
    cost::Choice choice;
    try {
      choice = cost::choose(body, {accuracy, kHorizon, kRate, candidates}, cost::nominalCosts());
    } catch (const cost::Unreachable&) {
      ++row.refused;
    }
    const bool chosen = !choice.method.empty();
    if (with_costs) {
      const double cost = chosen ? measuredCost(body, choice.method, choice.step) : 1e9;
      double cheapest = cost;
      for (const auto& way : exhaustive::waysToKeep(body, accuracy, kHorizon, kRate, leastCost, chosen ? cost : 0.01)) {
        cheapest = std::min(cheapest, measuredCost(body, way.method, way.step));
      }
      if (!chosen) row.refused_wrongly += cheapest < 1e9;
      if (with_closed_form) cheapest = std::min(cheapest, measuredCost(body, kClosedForm, std::nullopt));
      if (chosen) ratios.push_back(cost / cheapest);
    }
    if (!chosen) continue;
    ++row.chosen;
    ++row.methods[choice.method];
    MotionSetup setup = body;
    setup.method = choice.method;
    setup.step = choice.step;
    const double error = choice.step ? exhaustive::errorAt(setup, times, 10) : choice.verified_error;
    row.kept += error <= accuracy;
    row.worst_error = std::max(row.worst_error, error / accuracy);
  }
  if (!ratios.empty()) {
    std::sort(ratios.begin(), ratios.end());
    row.worst_cost = ratios.back();
    row.median_cost = ratios[ratios.size() / 2];
  }
  return row;
}

int usage(int code) {
  std::fprintf(
      code ? stderr : stdout,
      "usage: accuracy_choice [--without-costs]\n\n"
      "accuracy: on %d random bodies against an exhaustive search, as Markdown tables (minutes).\n"
      "Steppers are judged down to 1e-11 rad; below it the tables only show.\n"
      "--without-costs  leaves out what is measured in time, and the search: what is left is the same in every run.\n"
      "Exit status: 0; 1 when an accuracy is not kept, one that can be is refused, or a choice costs more than\n"
      "twice the cheapest; 2 for bad use.\n",
      kBodies);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && (!std::strcmp(argv[1], "--help") || !std::strcmp(argv[1], "-h"))) return usage(0);
  const bool with_costs = argc == 1;
  if (!with_costs && (argc != 2 || std::strcmp(argv[1], "--without-costs"))) return usage(2);
  const std::vector<MotionSetup> bodies = exhaustive::randomBodies(kBodies, kSeed);
  bool good = true;
  for (const bool with_closed_form : {true, false}) {
    std::printf("%s:\n\n", with_closed_form ? "Free to choose" : "With `method: stepper`");
    std::printf("| accuracy [rad] | chosen | kept | greatest error / accuracy |%s methods |\n",
                with_costs ? " cost / cheapest: median | worst |" : "");
    std::printf("|---|---|---|---|---|%s\n", with_costs ? "---|---|" : "");
    for (int digits = 1; digits <= 13; ++digits) {
      char text[16];
      std::snprintf(text, sizeof text, "1e-%d", digits);
      const Row row = measure(bodies, std::stod(text), with_closed_form, with_costs);
      std::string names;
      for (const auto& [name, count] : row.methods) {
        names += (names.empty() ? "" : ", ") + name + " " + std::to_string(count);
      }
      std::printf("| %s | %d of %d | %d | %.2f |", text, row.chosen, kBodies, row.kept, row.worst_error);
      if (with_costs) std::printf(" %.2f | %.2f |", row.median_cost, row.worst_cost);
      std::printf(" %s |\n", names.c_str());
      std::fflush(stdout);
      good = good && row.kept == row.chosen;
      // Beyond it, the result depends on rounding, and so do the steps that suffice.
      if (!with_closed_form && digits > kJudgedDigits) continue;
      good = good && row.refused_wrongly == 0 && row.worst_cost <= 2;
    }
    std::printf("\n");
  }
  return good ? 0 : 1;
}
