/** CSV of initial states and times on stdin → CSV of states on stdout, by any method. */
#include <CLI/CLI.hpp>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <limits>
#include <optional>

#include "csv_rows.h"
#include "poinsot/core/closed_form.h"
#include "poinsot/core/inertia.h"
#include "poinsot/core/method.h"
#include "poinsot/core/no_convergence.h"
#include "poinsot/core/rotation.h"
#include "poinsot/core/step_limits.h"
#include "worst_errors.h"

namespace {

using poinsot::tools::CsvError;
using poinsot::tools::CsvRow;
using poinsot::tools::parseNumber;

constexpr int kNo = 1, kBadInput = 2;  // exit codes
constexpr double kMostSteps = 1e12;    // of one row: hours
const std::vector<std::string> kColumns = {"id",  "mu1", "mu2", "mu3", "q0w", "q0x",
                                           "q0y", "q0z", "O01", "O02", "O03", "t"};

const char kAbout[] =
    "Moves free rigid bodies: CSV of initial states and times on stdin, CSV of states on stdout.\n\n"
    "Input columns, found by the names in the header, others ignored; lines that begin with # and empty lines "
    "skipped;\n"
    "cells separated by commas, semicolons or tabs; decimal or C hexadecimal numbers with a point; UTF-8:\n"
    "  id                  passed through\n"
    "  mu1 mu2 mu3         principal moments of inertia [kg m^2]\n"
    "  q0w q0x q0y q0z     attitude at t = 0, principal axes -> world; normalised on reading\n"
    "  O01 O02 O03         angular velocity at t = 0, principal axes [rad/s]\n"
    "  t                   time of the state wanted [s], either sign\n"
    "Output columns: id,t,qw,qx,qy,qz,O1,O2,O3 with 17 significant digits, qw >= 0.\n\n"
    "The closed form takes the numbers for exact and goes to any t at once. Every other method is a stepper: it "
    "needs\n"
    "--step S and takes ceil(|t|/S) equal steps to reach t exactly; more than 1e12 are refused. Where it does not "
    "follow\n"
    "a row's body at that step, stderr says so, and the row comes all the same. Where the rows end further than 0.1 "
    "rad\n"
    "from the closed form, or their energy changes by more than a tenth, stderr is told the worst of them.\n"
    "Exit status: 0; 1 when a state cannot be computed or written; 2 for bad use or input. Output comes whole or not "
    "at all.";

/** A row that is fine as input but has no finite answer. */
struct NoResult : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Task {
  long line;
  std::string id;
  Eigen::Vector3d moments;
  Eigen::Quaterniond given;     ///< the attitude as it stands there, of any length but zero
  Eigen::Quaterniond attitude;  ///< unit
  Eigen::Vector3d omega;
  double t;
};

/** The unit quaternion nearest to the one given; in long double, so that the result is correctly rounded but for 1 in
 * 1000. */
Eigen::Quaterniond normalised(double w, double x, double y, double z) {
  const long double lw = w, lx = x, ly = y, lz = z;
  const long double norm = std::sqrt(lw * lw + lx * lx + ly * ly + lz * lz);
  const auto share = [norm](long double part) { return static_cast<double>(part / norm); };
  return Eigen::Quaterniond(share(lw), share(lx), share(ly), share(lz));
}

Task readTask(const CsvRow& row) {
  double v[11];
  for (int i = 0; i < 11; ++i) {
    try {
      v[i] = parseNumber(row.cells[i + 1]);
    } catch (const std::invalid_argument& error) {
      throw CsvError(row.line, kColumns[i + 1] + " " + error.what());
    }
  }
  try {
    poinsot::PrincipalInertia::fromMoments({v[0], v[1], v[2]});
  } catch (const std::invalid_argument& error) {
    throw CsvError(row.line, error.what());
  }
  if (v[3] == 0 && v[4] == 0 && v[5] == 0 && v[6] == 0) throw CsvError(row.line, "the quaternion is zero");
  return {row.line,
          row.cells[0],
          {v[0], v[1], v[2]},
          {v[3], v[4], v[5], v[6]},
          normalised(v[3], v[4], v[5], v[6]),
          {v[7], v[8], v[9]},
          v[10]};
}

/** n = ⌈|t|/S⌉ */
double stepsFor(const Task& task, double step) {
  const double n = std::ceil(std::abs(task.t) / step);
  if (!(n <= kMostSteps)) throw CsvError(task.line, "t would take more than 1e12 steps");
  return n;
}

/** How to get from a start to a time. */
struct Way {
  const poinsot::Method* method;  ///< nullptr: the closed form
  double step;                    ///< longest, of a stepper [s]
};

void step(Task& task, const Way& way) {
  const double n = stepsFor(task, way.step);
  auto state = poinsot::RotationState::fromOmega(task.moments, task.attitude, task.omega);
  way.method->make(task.moments)->advance(state, 0, task.t / n, static_cast<std::int64_t>(n));
  task.attitude = state.attitude;
  task.omega = state.omegaPrincipal(task.moments);
}

void evaluate(Task& task) {
  const auto state = poinsot::ClosedForm(task.moments, task.given, task.omega).at(task.t);
  task.attitude = state.attitude;
  task.omega = state.omega_principal;
}

/** Moves the task's attitude and omega to t. */
void propagate(Task& task, const Way& way) {
  if (task.t == 0) return;
  try {
    way.method ? step(task, way) : evaluate(task);
  } catch (const poinsot::NoConvergence& error) {
    throw NoResult("line " + std::to_string(task.line) + ": " + error.what());
  }
  if (!task.attitude.coeffs().allFinite() || !task.omega.allFinite()) {
    throw NoResult("line " + std::to_string(task.line) + ": the state became infinite or undefined");
  }
}

/** What stderr is told of a row whose steps are too long for its body; empty when they are not. */
std::string warning(const Task& task, const Way& way) {
  if (!way.method || task.t == 0) return "";
  const double step = task.t / stepsFor(task, way.step);
  const poinsot::StepJudgement judgement = poinsot::judgeStep(*way.method, task.moments, task.omega, step);
  if (judgement.grade != poinsot::StepJudgement::Grade::hopeless) return "";
  return "propagate: line " + std::to_string(task.line) + ": do not trust this row: " + judgement.reason + "\n";
}

/**
 * Adds the errors of a stepper's row: of the attitude against the closed form, unless that has no state there, and of
 * the energy against that at the start.
 */
void judge(const Task& start, const Task& end, poinsot::tools::WorstErrors& worst) {
  Task truth = start;
  try {
    evaluate(truth);
  } catch (const std::exception&) {
    return;
  }
  const auto energy = [&](const Eigen::Vector3d& omega) { return omega.dot(end.moments.cwiseProduct(omega)); };
  const double before = energy(start.omega), after = energy(end.omega);
  worst.add(end.t, poinsot::angleBetween(end.attitude, truth.attitude), before > 0 ? after / before - 1 : 0);
}

void print(const Task& task, std::string& out) {
  const double sign = task.attitude.w() < 0 ? -1 : 1;
  const Eigen::Vector4d q = sign * task.attitude.coeffs() + Eigen::Vector4d::Zero();  // + 0: no "-0"
  char numbers[8 * 32];
  std::snprintf(numbers, sizeof numbers, ",%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", task.t, q[3], q[0], q[1],
                q[2], task.omega[0], task.omega[1], task.omega[2]);
  out += task.id + numbers;
}

double readStep(const std::string& text) {
  double step = 0;
  try {
    step = parseNumber(text);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string("--step ") + error.what());
  }
  if (!(step > 0)) throw std::invalid_argument("--step is " + text + "; it must be positive (seconds)");
  return step;
}

std::string allMethodNames() {
  return poinsot::kClosedForm + (", " + poinsot::methodNames(poinsot::freeMethods()));
}

Way readWay(const std::string& method_name, const std::optional<std::string>& step) {
  if (method_name == poinsot::kClosedForm) {
    if (step)
      throw std::invalid_argument("--step is for steppers (" + poinsot::methodNames(poinsot::freeMethods()) +
                                  "); closed_form takes none");
    return {nullptr, std::numeric_limits<double>::infinity()};
  }
  const poinsot::Method* method = poinsot::findMethod(method_name, poinsot::freeMethods());
  if (!method) throw std::invalid_argument("there is no method \"" + method_name + "\"; there is " + allMethodNames());
  if (!step) throw std::invalid_argument("method " + method_name + " needs --step");
  return {method, readStep(*step)};
}

struct Output {
  std::string table, warnings;
};

Output run(const Way& way) {
  std::cin.peek();
  if (std::ferror(stdin)) throw std::invalid_argument(std::string("cannot read the input: ") + std::strerror(errno));
  std::vector<Task> tasks;
  for (const CsvRow& row : poinsot::tools::readCsvRows(std::cin, kColumns)) tasks.push_back(readTask(row));
  if (way.method) {
    for (const Task& task : tasks) stepsFor(task, way.step);  // refuses before the long work begins
  }

  Output out{"id,t,qw,qx,qy,qz,O1,O2,O3\n", ""};
  poinsot::tools::WorstErrors worst;
  for (Task& task : tasks) {
    const Task start = task;
    out.warnings += warning(task, way);
    propagate(task, way);
    print(task, out.table);
    if (way.method && task.t != 0) judge(start, task, worst);
  }
  if (worst.lost()) out.warnings += "propagate: over these rows " + worst.text() + "\n";
  return out;
}

int fail(int code, const std::string& reason) {
  std::fprintf(stderr, "propagate: %s\n", reason.c_str());
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(kAbout, "propagate");
  std::string method = poinsot::kClosedForm;
  std::optional<std::string> step;
  app.add_option("--method", method, "One of " + allMethodNames())->capture_default_str();
  app.add_option("--step", step, "Longest step of a stepper [s], positive");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadInput;
  }

  Output out;
  try {
    out = run(readWay(method, step));
  } catch (const NoResult& error) {
    return fail(kNo, error.what());
  } catch (const std::exception& error) {
    return fail(kBadInput, error.what());
  }
  std::fputs(out.warnings.c_str(), stderr);
  const std::string& table = out.table;
  if (std::fwrite(table.data(), 1, table.size(), stdout) != table.size() || std::fflush(stdout) != 0) {
    return fail(kNo, std::string("cannot write the output: ") + std::strerror(errno));
  }
  return 0;
}
