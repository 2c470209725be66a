/** CSV of initial states and times on stdin → CSV of states on stdout, by any method. */
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_line.h"
#include "csv_rows.h"
#include "more_columns.h"
#include "poinsot/core/closed_form.h"
#include "poinsot/core/inertia.h"
#include "poinsot/core/method.h"
#include "poinsot/core/no_convergence.h"
#include "poinsot/core/rotation.h"
#include "poinsot/core/step_limits.h"
#include "worst_errors.h"

namespace {

using poinsot::tools::BadUse;
using poinsot::tools::CsvError;
using poinsot::tools::CsvRow;
using poinsot::tools::MoreColumns;
using poinsot::tools::parseNumber;

constexpr int kNo = 1;               // exit code
constexpr double kMostSteps = 1e12;  // of one row: hours
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
    "Output columns: id,t,qw,qx,qy,qz,O1,O2,O3 with 17 significant digits, qw >= 0; more by --columns.\n\n"
    "The closed form takes the numbers for exact and goes to any t at once. Every other method is a stepper: it "
    "needs\n"
    "--step S and takes ceil(|t|/S) equal steps to reach t exactly; more than 1e12 are refused. Where it does not "
    "follow\n"
    "a row's body at that step, a line on stderr warns of it, and the row is written nevertheless. Where rows end "
    "further\n"
    "than 0.1 rad from the closed form, or their energy changes by more than a tenth, a line gives the worst of them.\n"
    "Exit status: 0; 1 when a state cannot be computed or written; 2 for bad use or input. Output comes whole or not "
    "at all.";

/** A result that cannot be computed or written, although the input is right. */
struct NoResult : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Task {
  long line;
  std::string id;
  Eigen::Vector3d moments;
  Eigen::Quaterniond given;     ///< the attitude as the input gives it, of any length but zero
  Eigen::Quaterniond attitude;  ///< unit
  Eigen::Vector3d omega;
  double t;
};

/** Returns the unit quaternion of a quaternion. Long doubles round all but about 1 in 1000 results correctly. */
Eigen::Quaterniond normalised(double w, double x, double y, double z) {
  const long double lw = w, lx = x, ly = y, lz = z;
  const long double norm = std::sqrt(lw * lw + lx * lx + ly * ly + lz * lz);
  const auto share = [norm](long double part) { return static_cast<double>(part / norm); };
  return Eigen::Quaterniond(share(lw), share(lx), share(ly), share(lz));
}

Task readTask(const CsvRow& row) {
  double v[11];
  for (int i = 0; i < 11; ++i) {
    const std::string& cell = row.cells[i + 1];
    const std::optional<double> number = parseNumber(cell);
    if (!number) throw CsvError(row.line, kColumns[i + 1] + ": expected a finite number, got \"" + cell + '"');
    v[i] = *number;
  }
  try {
    poinsot::PrincipalInertia::fromMoments({v[0], v[1], v[2]});
  } catch (const std::invalid_argument& error) {
    throw CsvError(row.line, error.what());
  }
  if (v[3] == 0 && v[4] == 0 && v[5] == 0 && v[6] == 0) {
    throw CsvError(row.line, "q0w, q0x, q0y, q0z: expected a quaternion other than zero, got zeros");
  }

  return {row.line,
          row.cells[0],
          {v[0], v[1], v[2]},
          {v[3], v[4], v[5], v[6]},
          normalised(v[3], v[4], v[5], v[6]),
          {v[7], v[8], v[9]},
          v[10]};
}

/** Returns n = ⌈|t|/step⌉. */
double stepsFor(const Task& task, double step) {
  const double n = std::ceil(std::abs(task.t) / step);
  if (!(n <= kMostSteps)) throw CsvError(task.line, "t: expected at most 1e12 steps, got more");
  return n;
}

/** How rows are propagated. */
struct Way {
  const poinsot::Method* method;  ///< nullptr: the closed form
  double step;                    ///< longest step of a stepper [s]
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

/** Returns a warning for a row whose steps are too long for its body; empty when they are not. */
std::string warning(const Task& task, const Way& way) {
  if (!way.method || task.t == 0) return "";
  const double step = task.t / stepsFor(task, way.step);
  const poinsot::StepJudgement judgement = poinsot::judgeStep(*way.method, task.moments, task.omega, step);
  if (judgement.grade != poinsot::StepJudgement::Grade::hopeless) return "";
  return "propagate: line " + std::to_string(task.line) + ": do not trust this row: " + judgement.reason + "\n";
}

/** Returns the kinetic energy [J]. */
double energyOf(const Task& task) {
  return 0.5 * task.omega.dot(task.moments.cwiseProduct(task.omega));
}

/** The errors of a row. */
struct Errors {
  double attitude = 0;      ///< from the closed form [rad]; NaN where that has no state
  double energy_drift = 0;  ///< relative to the start
};

Errors errorsOf(const Task& start, const Task& end, const Way& way) {
  Errors out;
  const double before = energyOf(start);
  if (before > 0) out.energy_drift = energyOf(end) / before - 1;
  if (!way.method || end.t == 0) return out;
  Task truth = start;
  try {
    evaluate(truth);
    out.attitude = poinsot::angleBetween(end.attitude, truth.attitude);
  } catch (const std::exception&) {
    out.attitude = std::numeric_limits<double>::quiet_NaN();
  }
  return out;
}

/** Appends the columns that were asked for besides the state. */
void printMore(const Task& task, const Errors& errors, const MoreColumns& columns, std::string& out) {
  char numbers[4 * 32];
  if (columns.energy) {
    const Eigen::Vector3d own = task.moments.cwiseProduct(task.omega);
    const Eigen::Vector3d momentum = task.attitude * own + Eigen::Vector3d::Zero();  // + 0: no "-0"
    std::snprintf(numbers, sizeof numbers, ",%.17g,%.17g,%.17g,%.17g", energyOf(task), momentum[0], momentum[1],
                  momentum[2]);
    out += numbers;
  }
  if (columns.errors) {
    std::snprintf(numbers, sizeof numbers, ",%.17g,%.17g", errors.attitude, errors.energy_drift);
    out += numbers;
  }
}

void print(const Task& task, std::string& out) {
  const double sign = task.attitude.w() < 0 ? -1 : 1;
  const Eigen::Vector4d q = sign * task.attitude.coeffs() + Eigen::Vector4d::Zero();  // + 0: no "-0"
  char numbers[8 * 32];
  std::snprintf(numbers, sizeof numbers, ",%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g", task.t, q[3], q[0], q[1],
                q[2], task.omega[0], task.omega[1], task.omega[2]);
  out += task.id + numbers;
}

std::vector<std::string> allMethodNames() {
  std::vector<std::string> names = {poinsot::kClosedForm};
  for (const poinsot::Method& method : poinsot::freeMethods()) names.push_back(method.name);
  return names;
}

Way readWay(const std::string& method_name, const std::optional<double>& step) {
  if (method_name == poinsot::kClosedForm) {
    if (!step) return {nullptr, std::numeric_limits<double>::infinity()};
    throw BadUse("--step", "a stepper beside it (" + poinsot::methodNames(poinsot::freeMethods()) + ")",
                 "closed_form, which takes no step");
  }
  if (!step) throw BadUse("--step", "a positive finite number (s) for " + method_name, "none");
  return {poinsot::findMethod(method_name, poinsot::freeMethods()), *step};
}

struct Output {
  std::string table, warnings;
};

Output run(const Way& way, const MoreColumns& columns) {
  std::cin.peek();
  if (std::ferror(stdin)) throw std::invalid_argument(std::string("cannot read the input: ") + std::strerror(errno));
  std::vector<Task> tasks;
  for (const CsvRow& row : poinsot::tools::readCsvRows(std::cin, kColumns)) tasks.push_back(readTask(row));
  if (way.method) {
    for (const Task& task : tasks) stepsFor(task, way.step);  // refuses before the long work begins
  }

  Output out{"id,t,qw,qx,qy,qz,O1,O2,O3" + headerOf(columns) + "\n", ""};
  poinsot::tools::WorstErrors worst;
  for (Task& task : tasks) {
    const Task start = task;
    out.warnings += warning(task, way);
    propagate(task, way);
    print(task, out.table);
    const bool judged = way.method && task.t != 0;
    const Errors errors = judged || columns.errors ? errorsOf(start, task, way) : Errors();
    if (judged && !std::isnan(errors.attitude)) worst.add(task.t, errors.attitude, errors.energy_drift);
    printMore(task, errors, columns, out.table);
    out.table += '\n';
  }
  if (worst.lost()) out.warnings += "propagate: over these rows " + worst.text() + "\n";
  return out;
}

void write(const Output& out) {
  std::fputs(out.warnings.c_str(), stderr);
  const std::string& table = out.table;
  if (std::fwrite(table.data(), 1, table.size(), stdout) != table.size() || std::fflush(stdout) != 0) {
    throw NoResult(std::string("cannot write the output: ") + std::strerror(errno));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(kAbout, "propagate");
  std::string method = poinsot::kClosedForm;
  std::string columns = "states";
  std::optional<double> step;
  app.add_option("--method", method, "The method")
      ->check(poinsot::tools::oneOf(allMethodNames()))
      ->capture_default_str();
  poinsot::tools::addPositive(app, "--step", step, "s", "Longest step of a stepper [s]");
  app.add_option("--columns", columns, poinsot::tools::kColumnsHelp)->check(poinsot::tools::notEmpty());
  if (const auto code = poinsot::tools::parse(app, argc, argv)) return *code;
  return poinsot::tools::exitCodeOf<NoResult>("propagate", kNo, poinsot::tools::kBadUse, [&] {
    write(run(readWay(method, step), poinsot::tools::readColumns(columns)));
  });
}
