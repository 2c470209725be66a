// What test_instructions.py counts instructions of, under valgrind --tool=callgrind --collect-atstart=no. Each count is
// a dump with a name, "body/what".
//
//   probe free SCENE STEPS        moves each free body as the scene says, and by hand
//   probe others STATES SCENE...  moves all bodies of each scene together, and counts them one at a time
//   probe run SCENE SECONDS RATE  runs each body through, and nothing else: for profilers; prints CPU ns per simulated
//   s
//
// Exit: 0; 1 when two ways that should give one state do not; 2 for bad use.
#include <valgrind/callgrind.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "poinsot/core/method.h"
#include "poinsot/core/motion.h"
#include "poinsot/core/rotation.h"
#include "poinsot/scene/motion_setup.h"
#include "poinsot/scene/reader.h"
#include "steppers/rk4.h"

namespace {

using namespace poinsot;

[[maybe_unused]] volatile double sink = 0;

/** Counts what is executed in `use`, no part of it inlined elsewhere. */
template <class Use>
[[gnu::noinline]] void collected(const Use& use) {
  CALLGRIND_TOGGLE_COLLECT;
  use();
  CALLGRIND_TOGGLE_COLLECT;
}

void dump(const std::string& name) {
  CALLGRIND_DUMP_STATS_AT(name.c_str());
}

template <class Use>
void count(const std::string& name, const Use& use) {
  CALLGRIND_ZERO_STATS;
  collected(use);
  dump(name);
}

struct Ways {
  std::string name;
  double step;
  std::int64_t steps;
  Eigen::Vector3d moments;
  RotationState start;
};

Ways waysOf(const scene::Body& body, std::int64_t steps) {
  const Eigen::Quaterniond axes = body.inertia.axes();
  return {body.name, body.step.value_or(0), steps, body.inertia.moments(),
          RotationState::fromOmega(body.inertia.moments(), body.attitude * axes, axes.conjugate() * body.omega_body)};
}

void expectSame(const std::string& name, const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  if (!(angleBetween(a, b) <= 1e-14)) throw std::runtime_error(name + ": two ways give two states");
}

/** The loop that a reader of steppers/rk4.h would write: each step inline, no call at all. */
RotationState rk4ByHand(const Ways& w) {
  const steppers::Rk4 scheme(w.moments);
  RotationState s = w.start;
  for (std::int64_t n = 0; n < w.steps; ++n) scheme.step(s, w.step);
  return s;
}

/** A free body under a stepper. */
void countSteps(const scene::Body& body, std::int64_t steps) {
  const Ways w = waysOf(body, steps);
  const double end = static_cast<double>(steps) * w.step;       // exact: steps are powers of two
  MotionState seen = Motion(scene::motionSetup(body)).at(end);  // what is done once in a process is done now
  Motion motion(scene::motionSetup(body));
  count(w.name + "/scene", [&] { seen = motion.at(end); });
  const Eigen::Quaterniond expected = seen.attitude * body.inertia.axes();

  const std::unique_ptr<Stepper> stepper = findMethod(body.method)->make(w.moments);
  RotationState state = w.start;
  count(w.name + "/stepper", [&] { stepper->advance(state, 0, w.step, steps); });
  expectSame(w.name, state.attitude, expected);
  if (body.method == "rk4") {
    count(w.name + "/by_hand", [&] { state = rk4ByHand(w); });
    expectSame(w.name, state.attitude, expected);
  }

  // What must be noticed.
  RotationState more = w.start;
  count(w.name + "/stepper_and_2_percent", [&] { stepper->advance(more, 0, w.step, steps + steps / 50); });
  const Torques nothing(body.inertia);
  RotationState watched = w.start;
  count(w.name + "/stepper_and_absent_torque", [&] {
    stepper->advance(watched, 0, w.step, steps);
    for (std::int64_t n = 0; n < steps; ++n) {
      sink = nothing
                 .at(static_cast<double>(n) * w.step, nothing.constant(0), watched.attitude,
                     watched.omegaPrincipal(w.moments), Eigen::Vector3d::Zero())
                 .x();
    }
  });
}

/** A state in closed form as one would compose it by hand, of a body whose axes are the principal ones. */
MotionState stateByHand(const ClosedForm& exact, double t) {
  MotionState out;
  const ClosedForm::State state = exact.at(t);
  const Eigen::Vector3d& moments = exact.moments();
  const Invariants invariants =
      invariantsOf(moments, RotationState::fromOmega(moments, state.attitude, state.omega_principal));
  out.time = t;
  out.attitude = state.attitude;
  out.omega_body = state.omega_principal;
  out.omega_world = state.attitude * state.omega_principal;
  out.momentum_world = invariants.momentum_world;
  out.kinetic_energy = invariants.kinetic_energy;
  const bool finite = out.attitude.coeffs().allFinite() && out.omega_body.allFinite() && out.omega_world.allFinite() &&
                      std::isfinite(out.kinetic_energy) && std::isfinite(invariants.momentum_squared);
  if (!finite) throw std::range_error("not finite");
  return out;
}

/** A free body in closed form: states, with all that MotionState says. */
void countStates(const scene::Body& body, std::int64_t states) {
  const Ways w = waysOf(body, states);
  constexpr double kRate = 64;
  Motion motion(scene::motionSetup(body));
  sink = motion.at(1).time;
  count(w.name + "/scene", [&] {
    for (std::int64_t k = 0; k < states; ++k) sink = motion.at(static_cast<double>(k) / kRate).kinetic_energy;
  });
  const ClosedForm exact(w.moments, w.start.attitude, w.start.omegaPrincipal(w.moments));
  count(w.name + "/by_hand", [&] {
    for (std::int64_t k = 0; k < states; ++k) sink = stateByHand(exact, static_cast<double>(k) / kRate).kinetic_energy;
  });
  expectSame(w.name, stateByHand(exact, 3).attitude, motion.at(3).attitude);
  count(w.name + "/closed_form_alone", [&] {
    for (std::int64_t k = 0; k < states; ++k) sink = exact.at(static_cast<double>(k) / kRate).omega_principal.x();
  });
}

void countFree(const std::string& file, std::int64_t steps) {
  for (const scene::Body& body : scene::readFile(file).bodies) {
    if (body.step) {
      countSteps(body, steps);
    } else {
      countStates(body, steps);
    }
  }
}

void countOthers(const std::string& file, std::int64_t states) {
  const scene::Scene scene = scene::readFile(file);
  for (std::size_t counted = 0; counted < scene.bodies.size(); ++counted) {
    std::vector<Motion> motions;
    for (const scene::Body& body : scene.bodies) motions.emplace_back(scene::motionSetup(body));
    CALLGRIND_ZERO_STATS;
    for (std::int64_t k = 1; k <= states; ++k) {
      const double t = static_cast<double>(k) / 60;
      for (std::size_t i = 0; i < motions.size(); ++i) {
        const auto move = [&] { sink = motions[i].at(t).kinetic_energy; };
        if (i == counted) {
          collected(move);
        } else {
          move();
        }
      }
    }
    dump(std::filesystem::path(file).stem().string() + "/" + scene.bodies[counted].name);
  }
}

/** From the start to the end several times; the fastest of them is printed, not of pieces. */
void run(const std::string& file, double seconds, double rate) {
  for (const scene::Body& body : scene::readFile(file).bodies) {
    double cpu = std::numeric_limits<double>::infinity();
    for (int r = 0; r < 5; ++r) {
      Motion motion(scene::motionSetup(body));
      const std::clock_t begin = std::clock();
      collected([&] {
        for (double k = 1; k <= seconds * rate; ++k) sink = motion.at(k / rate).kinetic_energy;
      });
      cpu = std::min(cpu, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    std::printf("%s %.0f\n", body.name.c_str(), 1e9 * cpu / seconds);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (words.size() == 3 && words[0] == "free") {
      countFree(words[1], std::stoll(words[2]));
    } else if (words.size() >= 3 && words[0] == "others") {
      for (std::size_t i = 2; i < words.size(); ++i) countOthers(words[i], std::stoll(words[1]));
    } else if (words.size() == 4 && words[0] == "run") {
      run(words[1], std::stod(words[2]), std::stod(words[3]));
    } else {
      std::fprintf(stderr, "probe free SCENE STEPS | probe others STATES SCENE... | probe run SCENE SECONDS RATE\n");
      return 2;
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "probe: %s\n", error.what());
    return 1;
  }
  return 0;
}
