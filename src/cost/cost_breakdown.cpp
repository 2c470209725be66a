#include "poinsot/cost/cost_breakdown.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "poinsot/core/method.h"
#include "poinsot/core/motion.h"
#include "poinsot/cost/cpu_time.h"

namespace poinsot::cost {
namespace {

constexpr int kRepetitions = 12;             // the fastest counts, because disturbances only slow down
constexpr int kStretches = 8;                // of the motion
constexpr std::int64_t kStretch = 64;        // steps of a body under torques
constexpr std::int64_t kFreeStretch = 1024;  // of a free body, which takes them in batches
constexpr std::int64_t kSampledSteps = 16384;
constexpr std::size_t kMostStates = 1024;  // in a stretch
constexpr int kCalls = 256;                // to measure what takes no step
constexpr double kPiece = 256;             // steps and states of a run that are measured together
constexpr double kLongRuns = 0.25;         // CPU s: not repeated any more

/** Returns the CPU time of a call [s]. */
template <class Use>
double timeOf(Use use) {
  const double begin = threadCpuTime();
  use();
  return std::max(threadCpuTime() - begin - clockCost(), 0.0);
}

/** The fastest of several measurements [s]. */
struct Fastest {
  double time = std::numeric_limits<double>::infinity();
  template <class Use>
  void measure(Use use) {
    time = std::min(time, timeOf(use));
  }
};

/** Sums over all stretches: of the whole steps, and of the states beyond them. */
struct Times {
  double steps = 0, states = 0;
};

/** Returns the effects of the given types, which are numbered as in effectTypes() without translation. */
std::vector<Effect> only(const std::vector<Effect>& effects, const std::set<std::size_t>& types) {
  std::vector<Effect> out;
  for (const Effect& effect : effects) {
    if (types.count(effect.index())) out.push_back(effect);
  }
  return out;
}

std::set<std::size_t> typesIn(const std::vector<Effect>& effects) {
  std::set<std::size_t> types;
  for (const Effect& effect : effects) types.insert(effect.index());
  return types;
}

[[maybe_unused]] volatile double sink = 0;

/** A few stretches of one body's motion, which are measured repeatedly. */
class Stretches {
 public:
  Stretches(const MotionSetup& setup, double duration, double rate) : setup_(setup), step_(*setup.step) {
    const std::int64_t most = setup.effects.empty() ? kFreeStretch : kStretch;
    const auto steps = static_cast<std::int64_t>(std::clamp(duration / step_, 1.0, double{kSampledSteps}));
    length_ = std::min(most, steps);
    const std::int64_t count = std::clamp<std::int64_t>(steps / length_, 1, kStretches);
    Motion motion(setup);
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t first = count == 1 ? 0 : i * (steps - length_) / (count - 1);
      sink = motion.at(timeOfStep(first)).time;
      starts_.push_back({first, motion, {}, looks(first, rate)});
    }
    if (!setup.effects.empty()) findRotationStates();
  }

  /** Return the steps and states of all stretches together. */
  double steps() const { return static_cast<double>(length_) * static_cast<double>(starts_.size()); }
  double states() const {
    double sum = 0;
    for (const Start& start : starts_) sum += static_cast<double>(start.looks.size());
    return sum;
  }

  /** Measures the motion itself. */
  Times ofMotion() const {
    Times sum;
    for (const Start& start : starts_) {
      const auto fresh = [&] {
        Motion motion = start.motion;
        sink = motion.at(timeOfStep(start.first)).time;
        return motion;
      };
      Fastest steps, states;
      for (int r = 0; r < kRepetitions; ++r) {
        Motion motion = fresh();
        steps.measure([&] { sink = motion.at(timeOfStep(start.first + length_)).time; });
        motion = fresh();
        states.measure([&] {
          for (const Look& look : start.looks) sink = motion.at(timeOfStep(start.first + look.step) + look.rest).time;
        });
      }
      add(start, steps, states, sum);
    }
    return sum;
  }

  /** Measures steps and torques alone, for each choice among the effects, in turn so that disturbances affect all. */
  std::vector<Times> underTorques(const std::vector<std::set<std::size_t>>& choices) const {
    std::vector<Bound> bound;
    for (const auto& types : choices) bound.push_back(boundTo(only(setup_.effects, types)));
    std::vector<Times> sums(choices.size());
    for (const Start& start : starts_) {
      std::vector<Fastest> steps(choices.size()), states(choices.size());
      for (int r = 0; r < kRepetitions; ++r) {
        for (std::size_t k = 0; k < choices.size(); ++k) {
          steps[k].measure([&] { takeSteps(*bound[k].stepper, start); });
          states[k].measure([&] { takeLooks(bound[k], start); });
        }
      }
      for (std::size_t k = 0; k < choices.size(); ++k) add(start, steps[k], states[k], sums[k]);
    }
    return sums;
  }

  /** Returns the evaluations of the torque by whole steps, and those by partial steps and states. */
  std::pair<double, double> evaluations() const {
    const Bound all = boundTo(setup_.effects);
    std::pair<double, double> sum(0, 0);
    for (const Start& start : starts_) {
      sum.first += static_cast<double>(takeSteps(*all.stepper, start).torques);
      sum.second += static_cast<double>(takeLooks(all, start).torques);
    }
    return sum;
  }

 private:
  /** A time at which a state is asked for. */
  struct Look {
    std::int64_t step;  ///< of the stretch
    double rest;        ///< beyond it [s]
  };
  /** The body's method and the torques on it. */
  struct Bound {
    Torques torques;
    std::shared_ptr<const Stepper> stepper;
  };
  struct Start {
    std::int64_t first;  ///< step
    Motion motion;       ///< already at that step
    RotationState state;
    std::vector<Look> looks;
  };

  double timeOfStep(std::int64_t n) const { return static_cast<double>(n) * step_; }

  /** Returns the ticks within a stretch. Where a tick spans many steps, one state a step stands for them. */
  std::vector<Look> looks(std::int64_t first, double rate) const {
    const auto place = [this](double t) {
      const double n = std::floor(t / step_);
      return Look{static_cast<std::int64_t>(n), std::max(0.0, std::fma(-n, step_, t))};
    };
    std::vector<Look> out;
    if (step_ * rate > 1) {
      for (double k = std::floor(timeOfStep(first) * rate) + 1; out.size() < kMostStates; ++k) {
        Look look = place(k / rate);
        look.step = std::max<std::int64_t>(look.step - first, 0);
        if (look.step >= length_) break;
        out.push_back(look);
      }
    } else {
      for (std::int64_t i = 1; i <= length_; ++i) out.push_back({i, place(static_cast<double>(i) / rate).rest});
    }
    return out;
  }

  void add(const Start& start, const Fastest& steps, const Fastest& states, Times& sum) const {
    const double stepped = static_cast<double>(start.looks.back().step) / static_cast<double>(length_);
    sum.steps += steps.time;
    sum.states += states.time - stepped * steps.time;
  }

  Bound boundTo(const std::vector<Effect>& effects) const {
    const Torques torques = sumOf(setup_.inertia, effects);
    return {torques, findMethod(setup_.method)->make(torques)};
  }

  void findRotationStates() {
    const Eigen::Vector3d omega_principal = setup_.inertia.toPrincipal(setup_.omega_body);
    RotationState state = RotationState::fromOmega(
        setup_.inertia.moments(), setup_.attitude.normalized() * setup_.inertia.axes(), omega_principal);
    const Bound all = boundTo(setup_.effects);
    if (all.torques.slug()) state.slug_omega = omega_principal;
    StepperTrajectory trajectory(all.stepper, state, step_);
    for (Start& start : starts_) start.state = trajectory.at(start.first);
  }

  Work takeSteps(const Stepper& stepper, const Start& start) const {
    RotationState state = start.state;
    const Work work = stepper.advance(state, start.first, step_, length_);
    sink = state.attitude.w();
    return work;
  }

  /** Does the part of Motion::at() that depends on torques. Returns its work, without the whole steps. */
  Work takeLooks(const Bound& bound, const Start& start) const {
    const auto& [torques, stepper] = bound;
    RotationState state = start.state;
    Work work;
    std::int64_t i = 0;
    for (const Look& look : start.looks) {
      for (; i < look.step; ++i) stepper->advance(state, start.first + i, step_, 1);
      RotationState there = state;
      const double begin = timeOfStep(start.first + i), t = begin + look.rest;
      if (look.rest > 0) work += stepper->advanceFrom(there, begin, look.rest);
      const Eigen::Vector3d omega = there.omegaPrincipal(torques.moments());
      const Torques::Constant& constant = torques.constant(torques.intervalAt(t));
      sink = torques.at(t, constant, there.attitude, omega, there.slug_omega).x();
      ++work.torques;
    }
    return work;
  }

  MotionSetup setup_;
  double step_;
  std::int64_t length_;
  std::vector<Start> starts_;
};

/** Returns the time of a state with translation less that of one without, where neither takes a step [s]. */
double translationTime(const MotionSetup& setup) {
  MotionSetup without = setup;
  without.translation.reset();
  Motion motions[2] = {Motion(setup), Motion(without)};
  Fastest times[2];
  for (int r = 0; r < 2 * kRepetitions; ++r) {
    for (int k = 0; k < 2; ++k) {
      times[k].measure([&] {
        for (int i = 0; i < kCalls; ++i) sink = motions[k].at(0).position.x();
      });
    }
  }
  return (times[0].time - times[1].time) / kCalls;
}

/** Returns the cost of all states over the duration [CPU s per simulated s]; the fastest of several runs of each piece.
 */
double runTime(const MotionSetup& setup, double duration, double rate) {
  const auto ticks = static_cast<std::int64_t>(std::max(1.0, std::ceil(duration * rate * (1 - 1e-12))));
  const double steps_per_tick = setup.step ? 1 / (*setup.step * rate) : 0;
  const auto piece = static_cast<std::int64_t>(std::clamp(kPiece / (1 + steps_per_tick), 1.0, kPiece));
  const Motion start(setup);
  std::vector<Fastest> pieces((ticks + piece - 1) / piece);
  const double begin = threadCpuTime();
  for (int r = 0; r < kRepetitions && (r == 0 || threadCpuTime() - begin < kLongRuns); ++r) {
    Motion motion = start;
    std::int64_t k = 1;
    for (Fastest& fastest : pieces) {
      const std::int64_t end = std::min(ticks, k + piece - 1);
      fastest.measure([&] {
        for (; k <= end; ++k) sink = motion.at(static_cast<double>(k) / rate).time;
      });
    }
  }
  double sum = 0;
  for (const Fastest& fastest : pieces) sum += fastest.time;
  return sum * rate / static_cast<double>(ticks);
}

/** Fills in the part of each type of torque, by its place in Effect. */
void findShares(const MotionSetup& setup, const Stretches& stretches, std::vector<CostBreakdown::Part>& parts) {
  const std::set<std::size_t> present = typesIn(setup.effects);
  const std::vector<std::size_t> types(present.begin(), present.end());
  // None, the first, the first two, … all; then all but the first, all but the first two, … the last.
  std::vector<std::set<std::size_t>> choices;
  for (std::size_t k = 0; k <= types.size(); ++k) choices.emplace_back(types.begin(), types.begin() + k);
  for (std::size_t k = 1; k < types.size(); ++k) choices.emplace_back(types.begin() + k, types.end());
  const std::vector<Times> times = stretches.underTorques(choices);

  const std::size_t all = types.size();
  const auto firstFew = [&](std::size_t k) { return times[k]; };
  const auto withoutFirst = [&](std::size_t k) { return k == 0 ? times[all] : k == all ? times[0] : times[all + k]; };
  for (std::size_t k = 0; k < all; ++k) {
    const auto mean = [&](double Times::*what) {
      return 0.5 * (firstFew(k + 1).*what - firstFew(k).*what + withoutFirst(k).*what - withoutFirst(k + 1).*what);
    };
    CostBreakdown::Part& part = parts[2 + types[k]];  // after free motion and translation
    part.in_force = true;
    part.per_step = mean(&Times::steps) / stretches.steps();
    part.per_state = mean(&Times::states) / stretches.states();
  }
}

template <class... Types>
std::vector<std::string> namesOf(const std::variant<Types...>*) {
  return {Translation::kName, Types::kName...};
}

}  // namespace

const std::vector<std::string>& effectTypes() {
  static const std::vector<std::string> names = namesOf(static_cast<const Effect*>(nullptr));
  return names;
}

double CostBreakdown::perStep() const {
  double sum = 0;
  for (const Part& part : parts) sum += part.per_step;
  return sum;
}

double CostBreakdown::perState() const {
  double sum = 0;
  for (const Part& part : parts) sum += part.per_state;
  return sum;
}

CostBreakdown measureCosts(const MotionSetup& setup, double duration, double rate) {
  CostBreakdown out;
  out.states = rate;
  out.parts.push_back({"free_motion", true});
  for (const std::string& name : effectTypes()) out.parts.push_back({name, false});
  runTime(setup, std::min(duration, 16 / rate), rate);  // warms caches
  out.run = runTime(setup, duration, rate);
  double per_step = 0, per_state = out.run / rate;
  if (setup.step) {
    out.steps = 1 / *setup.step;
    const Stretches stretches(setup, duration, rate);
    const Times times = stretches.ofMotion();
    per_step = times.steps / stretches.steps();
    per_state = times.states / stretches.states();
    if (!setup.effects.empty()) {
      findShares(setup, stretches, out.parts);
      const auto [whole, others] = stretches.evaluations();
      out.torque_evaluations = whole / stretches.steps() * out.steps + others / stretches.states() * rate;
    }
  }
  if (setup.translation) {
    out.parts[1].in_force = true;
    out.parts[1].per_state = translationTime(setup);
  }
  out.parts[0].per_step = per_step - out.perStep();  // the rest, which no effect causes
  out.parts[0].per_state = per_state - out.perState();
  return out;
}

}  // namespace poinsot::cost
