/** Runs every method on every hard case and prints most of doc/hard_cases.md, as Markdown. */
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "hard_case_judge.h"
#include "long_run.h"
#include "poinsot/core/closed_form.h"
#include "poinsot/core/method.h"
#include "step_limits_table.h"

namespace {

using namespace poinsot;
using Grade = StepJudgement::Grade;

constexpr double kPi = 3.14159265358979323846;
constexpr double kRoundoff = 1e-14;
constexpr double kLost = 0.1;  // rad

struct Result {
  HardCase hard_case;
  std::string method;
  bool has_truth;  ///< false for the closed form, which is not compared with anything here
  bool conserves_momentum;
  StepJudgement judgement;
  Measured measured;
  Promise promise;

  bool refused() const { return judgement.grade == Grade::hopeless; }
};

/** Case by case, the closed form first. */
using Results = std::vector<std::vector<Result>>;

Results measureAll() {
  Results all;
  for (const HardCase& c : hardCases()) {
    std::vector<Result> row;
    row.push_back({c, kClosedForm, false, true, StepJudgement(), measureClosedForm(c), promiseOfClosedForm(c)});
    for (const Method& method : freeMethods()) {
      const StepJudgement judgement = judgeStep(method, c.moments, c.omega, c.step);
      row.push_back({c, method.name, true, method.conserves_momentum, judgement, measure(method, c),
                     promiseOf(method, c, judgement)});
    }
    all.push_back(row);
  }
  return all;
}

std::string figure(double value) {
  if (value == 0) return "0";
  char text[32];
  std::snprintf(text, sizeof text, value >= 0.095 && value < 100 ? "%.2g" : "%.0e", value);
  return text;
}

/** A figure, the letters that explain it, and whether it breaks its promise. */
std::string cell(const std::string& figures, const std::string& letters, bool kept) {
  return figures + (letters.empty() ? "" : " " + letters) + (kept ? "" : " **BROKEN**");
}

std::string notFinite(const Result& r) {
  return cell("∞ by " + std::to_string(r.measured.looked_at), "r", r.refused());
}

/** Whether a change comes from rounding to denormal numbers. */
bool heldByDenormals(const Result& r, double change) {
  return change < 1e-12 && r.hard_case.moments.cwiseProduct(r.hard_case.omega).stableNorm() < 1e-292;
}

std::string attitudeCell(const Result& r) {
  if (!r.has_truth) return "c";
  if (!r.measured.finite) return notFinite(r);
  std::string letters;
  if (r.refused()) letters = "r";
  if (r.judgement.grade == Grade::doubtful) letters = "w";
  if (letters.empty() && r.measured.attitude > 0.1) letters = "g";
  return cell(figure(std::min(r.measured.first_turn, kPi)) + ", " + figure(r.measured.attitude), letters,
              r.measured.first_turn <= r.promise.first_turn);
}

std::string momentumCell(const Result& r) {
  if (!r.measured.finite) return notFinite(r);
  std::string letters;
  if (r.measured.momentum > kRoundoff)
    letters = heldByDenormals(r, r.measured.momentum) ? "t" : r.refused() ? "r" : "d";
  return cell(figure(r.measured.momentum), letters, r.measured.momentum <= r.promise.momentum);
}

std::string energyCell(const Result& r) {
  if (!r.measured.finite) return notFinite(r);
  std::string letters;
  if (r.measured.energy > kRoundoff) {
    const bool on_top = r.conserves_momentum && r.measured.energy > 0.1 && r.measured.energy_at_end > 0.99;
    letters = r.refused() ? "r" : on_top ? "s" : heldByDenormals(r, r.measured.energy) ? "t" : "d";
  }
  return cell(figure(r.measured.energy), letters,
              r.measured.energy <= r.promise.energy && r.measured.energy_outside <= r.promise.energy_outside);
}

/** Prints a table for each six methods: more columns would not fit a page. */
void printTable(const Results& results, const std::function<std::string(const Result&)>& show) {
  constexpr std::size_t kMostColumns = 6;
  const std::size_t methods = results.front().size();
  for (std::size_t first = 0; first < methods; first += kMostColumns) {
    const std::size_t end = std::min(methods, first + kMostColumns);
    std::string head = "| case |", rule = "|---|";
    for (std::size_t i = first; i < end; ++i) head += " " + results.front()[i].method + " |", rule += "---|";
    std::printf("%s%s\n%s\n", first ? "\n" : "", head.c_str(), rule.c_str());
    for (const auto& row : results) {
      std::string line = "| " + row.front().hard_case.name + " |";
      for (std::size_t i = first; i < end; ++i) line += " " + show(row[i]) + " |";
      std::printf("%s\n", line.c_str());
    }
  }
}

/** Prints the worst case of each method; the others are alike. */
void printNorms(const Results& results) {
  std::printf("| method | greatest error | in the case |\n|---|---|---|\n");
  for (std::size_t i = 0; i < results.front().size(); ++i) {
    const Result* worst = nullptr;
    bool kept = true;
    for (const auto& row : results) {
      const Result& r = row[i];
      if (!r.measured.finite) continue;
      kept = kept && r.measured.norm <= r.promise.norm;
      if (!worst || r.measured.norm > worst->measured.norm) worst = &r;
    }
    if (!worst) continue;
    std::printf("| %s | %s | %s |\n", worst->method.c_str(), cell(figure(worst->measured.norm), "", kept).c_str(),
                worst->hard_case.name.c_str());
  }
}

std::string vector(const Eigen::Vector3d& v) {
  char text[128];
  std::snprintf(text, sizeof text, "%.6g, %.6g, %.6g", v[0], v[1], v[2]);
  return text;
}

void printCases() {
  std::printf("| case | moments | Ω [rad/s] | h [s] | steps | wh | what is hard |\n|---|---|---|---|---|---|---|\n");
  for (const HardCase& c : hardCases()) {
    const double wh = orbitRates(c.moments, c.omega).fastest() * std::abs(c.step);
    std::printf("| %s | %s | %s | %.3g | %lld | %.2g | %s |\n", c.name.c_str(), vector(c.moments).c_str(),
                vector(c.omega).c_str(), c.step, static_cast<long long>(c.steps), wh, c.hard.c_str());
  }
}

/** Prints the refusals and warnings; the methods of a case that are judged alike share a line. */
void printRefusals(const Results& results) {
  std::printf("| case | | why | methods, and the step that would do [s] |\n|---|---|---|---|\n");
  for (const auto& row : results) {
    std::vector<std::pair<std::string, std::string>> lines;  // grade and reason; the methods
    for (const Result& r : row) {
      if (r.judgement.grade == Grade::sound) continue;
      std::string reason = r.judgement.reason;
      if (reason.rfind(r.method + " ", 0) == 0) reason.erase(0, r.method.size() + 1);
      const std::string key = (r.refused() ? "refused | " : "warned | ") + reason;
      char step[32];
      std::snprintf(step, sizeof step, " %.2g", r.judgement.largest_sound);
      const std::string method = r.method + (r.judgement.largest_sound > 0 ? step : " –");
      const auto known = std::find_if(lines.begin(), lines.end(), [&](const auto& line) { return line.first == key; });
      if (known == lines.end()) {
        lines.emplace_back(key, method);
      } else {
        known->second += ", " + method;
      }
    }
    for (const auto& line : lines) {
      std::printf("| %s | %s | %s |\n", row.front().hard_case.name.c_str(), line.first.c_str(), line.second.c_str());
    }
  }
}

/** One method in all cases. The greatest changes are those of the cases that are not refused. */
struct Summary {
  int refused = 0, warned = 0, followed = 0;
  double momentum = 0, energy = 0, in_many_steps = 0;
};

Summary summaryOf(const Results& results, std::size_t method) {
  Summary out;
  for (const auto& row : results) {
    const Result& r = row[method];
    if (r.judgement.grade == Grade::doubtful) ++out.warned;
    if (r.hard_case.name == "many steps") out.in_many_steps = r.measured.attitude;
    if (r.refused()) {
      ++out.refused;
      continue;
    }
    if (r.measured.attitude <= kLost) ++out.followed;
    if (!heldByDenormals(r, r.measured.momentum)) out.momentum = std::max(out.momentum, r.measured.momentum);
    if (!heldByDenormals(r, r.measured.energy)) out.energy = std::max(out.energy, r.measured.energy);
  }
  return out;
}

/** Returns how many promises are made, and how many of them are broken. */
std::pair<std::size_t, std::size_t> countPromises(const Results& results) {
  std::size_t made = 0, bad = 0;
  for (const auto& row : results) {
    for (const Result& r : row) {
      const Promise& p = r.promise;
      for (const double bound : {p.norm, p.momentum, p.energy, p.energy_outside, p.first_turn})
        made += std::isfinite(bound);
      made += (p.must_be_finite ? 1 : 0) + (r.refused() ? 1 : 0);  // a step that is refused must lose the motion
      bad += broken(r.promise, r.measured).size() + (wronglyRefused(r.judgement, r.measured).empty() ? 0 : 1);
    }
  }
  return {made, bad};
}

void printSummary(const Results& results) {
  const auto [made, bad] = countPromises(results);
  std::printf(
      "%zu methods run in each of %zu hard cases; of %zu promises, which are listed below, %zu are broken. Where a "
      "method would "
      "lose the\nbody within a turn, the step is refused. Over many turns the errors of a stepper still add up, as the "
      "last "
      "column shows.\n\n",
      results.front().size(), results.size(), made, bad);
  std::printf(
      "| method | order | refused | warned | within 0.1 rad throughout | change of L | change of E | off in *many "
      "steps* "
      "[rad] |\n|---|---|---|---|---|---|---|---|\n");
  for (std::size_t i = 0; i < results.front().size(); ++i) {
    const Summary s = summaryOf(results, i);
    const Result& r = results.front()[i];
    const std::string order = r.has_truth ? std::to_string(findMethod(r.method)->order) : "exact";
    const std::string followed =
        r.has_truth ? std::to_string(s.followed) + " of " + std::to_string(results.size()) : "c";
    std::printf("| %s | %s | %d | %d | %s | %s | %s | %s |\n", r.method.c_str(), order.c_str(), s.refused, s.warned,
                followed.c_str(), figure(s.momentum).c_str(), figure(s.energy).c_str(),
                r.has_truth ? figure(s.in_many_steps).c_str() : "c");
  }
}

bool allKept(const Results& results) {
  bool good = true;
  for (const auto& row : results) {
    for (const Result& r : row) {
      for (const std::string& complaint : broken(r.promise, r.measured)) {
        std::fprintf(stderr, "hard_cases: %s, %s: %s\n", r.hard_case.name.c_str(), r.method.c_str(), complaint.c_str());
        good = false;
      }
      const std::string complaint = wronglyRefused(r.judgement, r.measured);
      if (complaint.empty()) continue;
      std::fprintf(stderr, "hard_cases: %s, %s: %s\n", r.hard_case.name.c_str(), r.method.c_str(), complaint.c_str());
      good = false;
    }
  }
  return good;
}

const char kInShort[] = R"(
*Refused* and *warned* count the cases in which the step is too long for the method. *Within 0.1 rad* counts those of the others, and of the
warned ones, in which the attitude is never further off. The changes of L and E, relative, are the greatest of the cases that are not
refused, but for those whose numbers are denormal. *Many steps* is 1500 turns at 200 steps a turn; the column has the greatest error of
the attitude there. What follows from it:

- The closed form (**c**) is the truth that the others are compared with. Tests compare it with references of 60 digits, to 2e-15 rad.
- At 200 steps a turn, `splitting6`, `dmv6`, `dmv8` and `dmv10` stay within 2e-11 rad for 1500 turns. No method of order 3 or less stays
  within 1e-3 rad.
- On the separatrix (the first case below), every stepper is at some time half a turn off, whatever it conserves: the last bit of Ω decides
  when, and whether, the body turns over.
- `lie_euler` keeps L to rounding and is lost all the same: its E grows until the body spins about its axis of smallest moment.
)";

const char kWhatMustHold[] = R"(## What must hold

For a method of order p, h its step, w the fastest rate of the orbit (the greatest |Ω|, or |L|(1/μ_min − 1/μ_max) if that
is more), n the number of steps, t = n·h, and κ = |Ω||L|/E, the factor by which a rounding of L affects E more than L:

| | a method that conserves it | one that does not |
|---|---|---|
| finite | always, unless the step is refused | the same |
| norm of q, error | 1e-15 after any number of steps | the same |
| L in world axes, relative | 4e-15 after any number of steps, also where the step is refused | 1e-15·κ(20 + √n) + C(wh)^p(1 + w\|t\|) |
| E, relative | 4e-15·κ after any number of steps | 1e-15·κ(20 + √n) + C(wh)^p(1 + w\|t\|); with L conserved never outside [L²/2μ_max, L²/2μ_min] |
| attitude, first turn | 10π(wh)^p rad a turn and 1e-16 rad a step (splittings 4e-16); never more than 0.1, or 1 where the step causes a warning | the same |

C = 2 for p = 1, else 0.2. The last two lines do not apply to a step that is refused. Denormal L is conserved to 1000 times the
smallest number, 5e-324. The closed form: norm 1e-15, L 4e-15, E 4e-15·κ, and always finite.
)";

const char kLetters[] = R"(
A figure without a letter keeps its promise; in the tables of L, E and the norm it is roundoff. Each table has up to six methods.
The letters:

- **c** the closed form is the truth here; tests compare it with references of 60 digits, to 2e-15 rad.
- **r** the step is refused, see below; the figures show why.
- **w** the step causes a warning, see below.
- **g** each turn is off by no more than the first figure, but by the end of the run the turns have added up to more
  than 0.1 rad.
- **d** not conserved, and changed by no more than the order allows.
- **s** the same; the body has ended about its axis of smallest moment, where E is greatest for its L.
- **t** conserved as well as denormal numbers allow.
- **∞ by n** after n steps there was no state: it was infinite or undefined, or an implicit method found no step. The step is
  refused, and every program that continues with it reports the error.
)";

int usage(int code) {
  std::fprintf(code ? stderr : stdout,
               "usage: hard_cases [--long]\n\n"
               "Runs every method on every hard case and prints Markdown tables.\n"
               "--long adds runs of 1e8 steps (minutes).\n"
               "Exit status: 0; 1 when a figure breaks what is promised; 2 for bad use.\n");
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  bool with_long_runs = false;
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "--help") || !std::strcmp(argv[i], "-h")) return usage(0);
    if (std::strcmp(argv[i], "--long")) return usage(2);
    with_long_runs = true;
  }
  const Results results = measureAll();
  std::printf("## In short\n\n");
  printSummary(results);
  std::printf("%s", kInShort);
  std::printf("\n%s", kWhatMustHold);
  std::printf("%s", kLetters);
  std::printf("\n## The cases\n\n");
  printCases();
  std::printf("\n## Attitude: error in the first turn (or step, if longer), and over the whole run [rad]\n\n");
  std::printf(
      "The first figure is the worst error per angle turned, at any time checked in the first turn, times a turn. "
      "After a "
      "small part\nof a turn (1e12, short step) it is magnified roundoff.\n\n");
  printTable(results, attitudeCell);
  std::printf("\n## L in world axes: greatest change, relative\n\n");
  printTable(results, momentumCell);
  std::printf("\n## E: greatest change, relative\n\n");
  printTable(results, energyCell);
  std::printf("\n## Norm of the attitude: greatest error where the state is finite\n\n");
  printNorms(results);
  std::printf("\n## Refused, and warned of\n\n");
  printRefusals(results);
  bool good = allKept(results);
  good = printStepLimits() && good;
  if (with_long_runs) good = printLongRuns() && good;
  return good ? 0 : 1;
}
