/** Measures what accuracy costs and prints CSV rows for the program work_precision, which shows them. */
#include <time.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "bodies.h"
#include "contestant.h"
#include "peers.h"
#include "poinsot/core/closed_form.h"
#include "poinsot/core/rotation.h"

namespace {

using namespace poinsot;
using namespace poinsot::work_precision;

constexpr int kBadUse = 2;
constexpr double kTickRate = 60;      // Hz
constexpr int kRequestedTimes = 100;  // of the mode "requests"
constexpr double kFloor = 2e-15;      // rad: smaller errors cannot be distinguished from the truth

enum class Mode { shot, ticks, requests };

struct Options {
  double horizon = 100;
  double budget = 0;    ///< CPU seconds that one run may take; a ladder ends with the first that takes more
  double patience = 0;  ///< CPU seconds for timing one run
  double ladder = 0;    ///< ratio of neighbouring steps
};

double cpuTime() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/** The greatest errors of the answers seen so far. */
class Judge {
 public:
  /** @param by_truth_alone true for the closed form, which does not judge itself. */
  Judge(const Problem& problem, bool by_truth_alone)
      : problem_(problem),
        by_truth_alone_(by_truth_alone),
        exact_(problem.moments, problem.attitude, problem.omega),
        energy_(energy(problem.omega)),
        momentum_(problem.attitude.normalized() * problem.moments.cwiseProduct(problem.omega)) {}

  /** Compares with the closed form, and with 25 digits if they are known for the time. */
  void look(const Answer& answer) {
    if (!answer.attitude.coeffs().allFinite() || !answer.omega.allFinite()) {
      attitude = INFINITY;
      return;
    }
    if (!by_truth_alone_) attitude = std::max(attitude, angle(answer, exact_.at(answer.time).attitude));
    for (const Truth& truth : truths()) {
      if (problem_.body == truth.body && truth.answer.time == answer.time) {
        const Eigen::Quaterniond since = expQuaternion(truth.answer.omega * answer.time_rest);
        attitude_of_truth = std::max(attitude_of_truth, angle(answer, truth.answer.attitude * since));
        attitude = std::max(attitude, attitude_of_truth);
        ++truths_met;
      }
    }
    const double size = answer.attitude.norm();
    norm_drift = std::max(norm_drift, std::abs(size - 1));
    energy_drift = std::max(energy_drift, std::abs(energy(answer.omega) - energy_) / energy_);
    const Eigen::Vector3d momentum = answer.attitude.normalized() * problem_.moments.cwiseProduct(answer.omega);
    momentum_drift = std::max(momentum_drift, (momentum - momentum_).norm() / momentum_.norm());
  }

  double attitude = 0, energy_drift = 0, momentum_drift = 0, norm_drift = 0;
  double attitude_of_truth = 0;  ///< against the 25 digits alone
  int truths_met = 0;

 private:
  static double angle(const Answer& answer, const Eigen::Quaterniond& truth) {
    return angleBetween(answer.attitude.normalized(), truth.normalized());
  }
  double energy(const Eigen::Vector3d& omega) const { return 0.5 * omega.dot(problem_.moments.cwiseProduct(omega)); }

  const Problem& problem_;
  bool by_truth_alone_;
  ClosedForm exact_;
  double energy_;
  Eigen::Vector3d momentum_;
};

class Measurement {
 public:
  Measurement(const Contestant& contestant, const Problem& problem, Mode mode, const Options& options)
      : contestant_(contestant), problem_(problem), mode_(mode), options_(options) {
    if (mode == Mode::ticks) count_ = static_cast<std::int64_t>(std::llround(options.horizon * kTickRate));
    if (mode == Mode::requests) count_ = kRequestedTimes;
    answers_.resize(static_cast<std::size_t>(count_));
  }

  /** Measures one point of the diagram; prints nothing for a run that fails. @return whether the ladder continues. */
  bool measure(double setting) {
    const double begin = cpuTime();
    Effort effort;
    Judge judge(problem_, closedForm());
    double once;
    try {
      const auto run = contestant_.start(problem_, setting);
      if (mode_ == Mode::shot) {
        judge.look(run->shot(
            options_.horizon, [&](const Answer& answer) { judge.look(answer); }, effort));
        if (closedForm()) lookAtTruths(*run, judge);
        effort = Effort();
        const double before = cpuTime();
        run->shot(options_.horizon, nullptr, effort);
        once = cpuTime() - before;
      } else {
        const double before = cpuTime();
        answer(*run, effort);
        once = cpuTime() - before;
        for (const Answer& each : answers_) judge.look(each);
      }
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s, %s, %.3g: %s\n", problem_.body.c_str(), contestant_.name().c_str(), setting,
                   error.what());
      return cpuTime() - begin < options_.budget;
    }
    const double cpu = timed(setting, once);
    print(setting, effort, judge, cpu);
    if (judge.attitude < 0.9 * best_) {
      best_ = judge.attitude;
      without_progress_ = 0;
    } else if (judge.attitude < 0.1) {
      ++without_progress_;
    }
    return once < options_.budget && best_ > kFloor && without_progress_ < 3;
  }

 private:
  bool closedForm() const { return contestant_.knob() == Contestant::Knob::none; }

  void lookAtTruths(Run& run, Judge& judge) const {
    Effort ignored;
    for (const Truth& truth : truths()) {
      if (problem_.body != truth.body || truth.answer.time > options_.horizon) continue;
      judge.look(run.shot(truth.answer.time, nullptr, ignored));
    }
    if (judge.truths_met == 0) throw std::runtime_error("no reference up to this horizon");
  }

  void answer(Run& run, Effort& effort) {
    const double interval = mode_ == Mode::ticks ? 1 / kTickRate : options_.horizon / kRequestedTimes;
    if (mode_ == Mode::requests && closedForm()) {
      for (std::int64_t i = 0; i < count_; ++i) {
        answers_[static_cast<std::size_t>(i)] = run.shot(static_cast<double>(i + 1) * interval, nullptr, effort);
      }
    } else {
      run.ticks(interval, count_, answers_.data(), effort);
    }
  }

  void all(double setting) {
    Effort effort;
    const auto run = contestant_.start(problem_, setting);
    if (mode_ == Mode::shot) {
      sink_ = run->shot(options_.horizon, nullptr, effort).attitude.w();
    } else {
      answer(*run, effort);
      sink_ = answers_.back().attitude.w();
    }
  }

  /** CPU time of set-up and run: the fastest of several, because disturbances only make a run slower. */
  double timed(double setting, double about) {
    const int batch = std::max(1, static_cast<int>(20e-6 / std::max(about, 1e-7)));
    double best = INFINITY, spent = 0;
    for (int r = 0; r < 200 && (r < 3 || spent < options_.patience); ++r) {
      const double begin = cpuTime();
      for (int i = 0; i < batch; ++i) all(setting);
      const double took = cpuTime() - begin;
      best = std::min(best, took / batch);
      spent += took;
    }
    return best;
  }

  void print(double setting, const Effort& effort, const Judge& judge, double cpu) const {
    static const char* const kModes[] = {"shot", "ticks", "requests"};
    const double span = options_.horizon;
    const double step = closedForm() ? NAN : span / static_cast<double>(std::max<std::int64_t>(effort.steps, 1));
    std::printf("%s,%s,%s,%s,%s,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.6g,%.6g,%lld,%lld,%lld,%.6g\n",
                problem_.body.c_str(), contestant_.name().c_str(), contestant_.package().c_str(),
                kModes[static_cast<int>(mode_)],
                contestant_.knob() == Contestant::Knob::step ? "step"
                : closedForm()                               ? "none"
                                                             : "tolerance",
                setting, step, span, judge.attitude, judge.energy_drift, judge.momentum_drift, judge.norm_drift,
                1e9 * cpu / static_cast<double>(std::max<std::int64_t>(effort.steps, 1)), cpu,
                static_cast<long long>(effort.steps), static_cast<long long>(effort.evaluations),
                static_cast<long long>(effort.exponentials), judge.truths_met > 0 ? judge.attitude_of_truth : NAN);
    std::fflush(stdout);
  }

  const Contestant& contestant_;
  const Problem& problem_;
  Mode mode_;
  const Options& options_;
  std::int64_t count_ = 0;
  std::vector<Answer> answers_;
  double best_ = INFINITY;
  int without_progress_ = 0;
  volatile double sink_ = 0;
};

void climb(const Contestant& contestant, const Problem& problem, Mode mode, const Options& options) {
  Measurement measurement(contestant, problem, mode, options);
  if (contestant.knob() == Contestant::Knob::none) {
    measurement.measure(0);
  } else if (contestant.knob() == Contestant::Knob::tolerance) {
    // Down to the limit of double precision; solvers refuse smaller tolerances.
    for (double digits = 2; digits <= 14.01 && measurement.measure(std::pow(10, -digits));
         digits += options.ladder > 1.9 ? 1 : 0.5) {
    }
  } else {
    const double fastest = std::max(problem.omega.norm(), 1e-3);
    double step = 2 / fastest;
    if (mode == Mode::ticks) step = std::min(step, 1 / kTickRate);
    if (mode == Mode::requests) step = std::min(step, options.horizon / kRequestedTimes);
    while (measurement.measure(step)) step /= options.ladder;
  }
}

/** Those named, or all. Throws for an unknown name. */
std::set<std::string> chosen(const std::vector<std::string>& wanted, const std::vector<std::string>& all,
                             const char* what) {
  std::string list;
  for (const std::string& name : all) list += (list.empty() ? "" : ", ") + name;
  for (const std::string& name : wanted) {
    if (std::find(all.begin(), all.end(), name) == all.end()) {
      throw std::invalid_argument("there is no " + std::string(what) + " \"" + name + "\"; there is " + list);
    }
  }
  return wanted.empty() ? std::set<std::string>(all.begin(), all.end())
                        : std::set<std::string>(wanted.begin(), wanted.end());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Measures methods and peers on free bodies: rows of CSV for work_precision.", "work_precision_measure");
  std::vector<std::string> body_names, method_names, mode_names = {"shot"};
  Options options;
  bool quick = false, list_bodies = false, list_contestants = false;
  app.add_option("--body", body_names, "only these")->delimiter(',');
  app.add_option("--method", method_names, "only these")->delimiter(',');
  app.add_option("--mode", mode_names, "shot, ticks, requests")
      ->delimiter(',')
      ->check(CLI::IsMember({"shot", "ticks", "requests"}));
  app.add_option("--horizon", options.horizon, "[s]: 10, 100, 1000")->check(CLI::IsMember({10.0, 100.0, 1000.0}));
  app.add_flag("--quick", quick, "coarser, in seconds");
  app.add_flag("--bodies", list_bodies, "only list the bodies: moments, attitude w x y z, Omega, in hex");
  app.add_flag("--contestants", list_contestants, "only list the methods: name, package, version, settings");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadUse;
  }
  if (list_bodies) {
    std::puts("body,mu1,mu2,mu3,q0w,q0x,q0y,q0z,O01,O02,O03");
    for (const Problem& p : bodies()) {
      std::printf("%s,%a,%a,%a,%a,%a,%a,%a,%a,%a,%a\n", p.body.c_str(), p.moments[0], p.moments[1], p.moments[2],
                  p.attitude.w(), p.attitude.x(), p.attitude.y(), p.attitude.z(), p.omega[0], p.omega[1], p.omega[2]);
    }
    return 0;
  }
  Contestants contestants;
  addPoinsot(contestants);
  addPeers(contestants);
  if (list_contestants) {
    for (const auto& c : contestants) {
      std::printf("%s\t%s\t%s\t%s\n", c->name().c_str(), c->package().c_str(), c->version().c_str(),
                  c->settings().c_str());
    }
    return 0;
  }
  options.budget = quick ? 2e-3 : 0.1;
  options.patience = quick ? 3e-4 : 10e-3;
  options.ladder = quick ? 4 : 1.5;
  std::set<std::string> body_set, method_set;
  try {
    std::vector<std::string> all;
    for (const Problem& p : bodies()) all.push_back(p.body);
    body_set = chosen(body_names, all, "body");
    all.clear();
    for (const auto& c : contestants) all.push_back(c->name());
    method_set = chosen(method_names, all, "method");
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "work_precision_measure: %s\n", error.what());
    return kBadUse;
  }
  std::puts(
      "body,method,package,mode,knob,setting,step,horizon,max_error_rad,energy_drift,momentum_drift,norm_drift,ns_per_"
      "step,"
      "cpu_s,steps,evaluations,exponentials,reference_error_rad");
  std::fflush(stdout);
  for (const std::string& mode_name : mode_names) {
    const Mode mode = mode_name == "shot" ? Mode::shot : mode_name == "ticks" ? Mode::ticks : Mode::requests;
    for (const Problem& problem : bodies()) {
      if (!body_set.count(problem.body)) continue;
      for (const auto& contestant : contestants) {
        if (!method_set.count(contestant->name())) continue;
        climb(*contestant, problem, mode, options);
        std::printf("# done %s %s %s\n", mode_name.c_str(), problem.body.c_str(), contestant->name().c_str());
        std::fflush(stdout);
      }
    }
  }
  return 0;
}
