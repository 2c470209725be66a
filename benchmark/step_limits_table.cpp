#include "step_limits_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "draws.h"
#include "poinsot/core/closed_form.h"
#include "poinsot/core/method.h"
#include "poinsot/core/no_convergence.h"
#include "poinsot/core/rotation.h"
#include "poinsot/core/step_limits.h"

namespace {

using namespace poinsot;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;

struct Body {
  Vector3d moments, omega;
  std::vector<ClosedForm> places;  ///< the motion as it goes on from eight places of the orbit
};

/** Random real bodies with axes in any order and |Ω| = 1: two thirds tumble, one third spins a millionth off an axis.
 */
std::vector<Body> drawBodies() {
  Draws draws;
  std::vector<Body> bodies;
  for (int i = 0; i < 90; ++i) {
    Body body{draws.moments(), draws.direction(), {}};
    if (i % 3 == 0) {
      body.omega = Vector3d::Constant(1e-6);
      body.omega[i / 3 % 3] = 1;
    }
    const ClosedForm orbit(body.moments, Eigen::Quaterniond::Identity(), body.omega);
    for (int k = 0; k < 8; ++k) {
      const ClosedForm::State state = orbit.at(k / 8.0 * orbit.period());
      body.places.emplace_back(body.moments, state.attitude, state.omega_principal);
    }
    bodies.push_back(body);
  }
  return bodies;
}

/** The greatest error of the attitude [rad] in `steps` steps, from eight places of the orbit; π if there is no state.
 */
double worstError(const Stepper& stepper, const Body& body, double step, int steps) {
  double worst = 0;
  for (const ClosedForm& truth : body.places) {
    const ClosedForm::State start = truth.at(0);
    RotationState state = RotationState::fromOmega(body.moments, start.attitude, start.omega_principal);
    for (int n = 1; n <= steps; ++n) {
      try {
        stepper.advance(state, 0, step, 1);
      } catch (const NoConvergence&) {
        return kPi;
      }
      if (!state.attitude.coeffs().allFinite() || !state.momentum_principal.allFinite()) return kPi;
      worst = std::max(worst, angleBetween(truth.at(n * step).attitude, state.attitude));
    }
  }
  return worst;
}

struct Share {
  int bodies = 0;
  double least = kPi, most = 0;
  void add(double error) {
    ++bodies;
    least = std::min(least, error);
    most = std::max(most, error);
  }
};

}  // namespace

bool printStepLimits() {
  std::printf(
      "\n## What is refused, and rightly\n\n"
      "90 random bodies at each step, a third of them spun a millionth of a radian off an axis. The table has the "
      "number "
      "of bodies\n"
      "whose step passes, causes a warning, or is refused. For steps that pass or cause a warning, it has the worst "
      "error "
      "in a turn\n"
      "(or step) from eight places of the orbit; for refused steps, the least error of any body within three turns (or "
      "64 "
      "steps)\n"
      "[rad]. Tried up to Ωh = 1e6.\n\n"
      "| method | Ωh | let pass | worst in a turn | warned | worst in a turn | refused | least in three turns |\n"
      "|---|---|---|---|---|---|---|---|\n");
  const std::vector<Body> bodies = drawBodies();
  bool good = true;
  for (const Method& method : freeMethods()) {
    double refused_from = 0, least_refused = kPi;  // steps from which all bodies are refused share one line
    const auto print = [&](const std::string& step, const std::string& cells, bool right) {
      std::printf("| %s | %s | %s%s |\n", method.name, step.c_str(), cells.c_str(), right ? "" : " **WRONG**");
      good = good && right;
    };
    const auto number = [](const char* format, double value) {
      char text[48];
      std::snprintf(text, sizeof text, format, value);
      return std::string(text);
    };
    for (const double step : {0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 4.0, 10.0, 100.0, 1e4, 1e6}) {
      Share shares[3];
      for (const Body& body : bodies) {
        const auto stepper = method.make(body.moments);
        const auto grade = judgeStep(method, body.moments, body.omega, step).grade;
        const double turn = 2 * kPi / step;  // [steps]
        const bool refused = grade == StepJudgement::Grade::hopeless;
        const double steps = refused ? std::max(3 * turn, 64.0) : std::max(turn, 1.0);
        shares[static_cast<int>(grade)].add(worstError(*stepper, body, step, static_cast<int>(std::ceil(steps))));
      }
      if (shares[2].bodies == static_cast<int>(bodies.size())) {
        if (refused_from == 0) refused_from = step;
        least_refused = std::min(least_refused, shares[2].least);
        continue;
      }
      const auto shown = [&](const Share& share, double value) {
        return std::to_string(share.bodies) + " | " + (share.bodies ? number("%.1g", value) : "–");
      };
      // judgeStep() tries other places of the orbit, so errors may be a little above its 0.1 and 1 rad, or below 1 rad.
      // Once a step is refused for all bodies, no longer step may pass.
      const bool right = shares[0].most <= 0.2 && shares[1].most <= 1.5 && shares[2].least >= 0.5 && refused_from == 0;
      print(number("%g", step),
            shown(shares[0], shares[0].most) + " | " + shown(shares[1], shares[1].most) + " | " +
                shown(shares[2], shares[2].least),
            right);
    }
    if (refused_from > 0) {
      print(number("%g", refused_from) + " and more",
            "0 | – | 0 | – | " + std::to_string(bodies.size()) + " | " + number("%.1g", least_refused),
            least_refused >= 0.5);
    }
  }
  return good;
}
