// Every method in every hard case. The bounds follow from its row of the table of methods alone, so that a
// method added later is held to it as well; doc/hard_cases.md shows the same figures.
#include <gtest/gtest.h>

#include "hard_case_judge.h"
#include "poinsot/core/method.h"
#include "poinsot/core/rotation.h"
#include "steppers/rotate.h"

namespace poinsot {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kShort = 0.05;  // rad a step, at the fastest rate of the orbit

std::string listed(const std::vector<std::string>& sentences) {
  std::string out;
  for (const std::string& sentence : sentences) out += sentence + "; ";
  return out;
}

class EveryMethodMeets : public ::testing::TestWithParam<Method> {};

TEST_P(EveryMethodMeets, everyHardCase) {
  const Method& method = GetParam();
  for (const HardCase& c : hardCases()) {
    const StepJudgement judgement = judgeStep(method, c.moments, c.omega, c.step);
    const Measured measured = measure(method, c);
    EXPECT_EQ(listed(broken(promiseOf(method, c, judgement), measured)), "") << c.name << ": " << judgement.reason;
    EXPECT_EQ(wronglyRefused(judgement, measured), "") << c.name;
    // Nobody gets away from promises by being hopeless where a step is short.
    const OrbitRates rates = orbitRates(c.moments, c.omega);
    if (rates.fastest() * std::abs(c.step) < kShort && rates.wobble < 10 * rates.turn) {
      EXPECT_EQ(judgement.grade, StepJudgement::Grade::sound) << c.name << ": " << judgement.reason;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(HardCases, EveryMethodMeets, ::testing::ValuesIn(freeMethods()),
                         [](const auto& instance) { return std::string(instance.param.name); });

/** Runs a scheme as simply as can be: no guard over it, nothing restored. */
template <class Scheme>
class PlainStepper final : public Stepper {
 public:
  explicit PlainStepper(const Vector3d& moments) : scheme_{moments} {}
  Work advanceFrom(RotationState& state, double, double length) const override { return advance(state, 0, length, 1); }
  Work advance(RotationState& state, std::int64_t, double step, std::int64_t count) const override {
    for (std::int64_t i = 0; i < count; ++i) scheme_.step(state, step);
    return Work();
  }

 private:
  Scheme scheme_;
};

template <class Scheme>
Method plain(int order, bool conserves_momentum) {
  const auto make = [](const Vector3d& moments) -> std::unique_ptr<Stepper> {
    return std::make_unique<PlainStepper<Scheme>>(moments);
  };
  return {"broken", order, conserves_momentum, false, false, false, make, nullptr};
}

/** Prints the figures of a method, case by case. */
std::string complaintsAbout(const Method& method) {
  std::string out;
  for (const HardCase& c : hardCases()) {
    const StepJudgement judgement = judgeStep(method, c.moments, c.omega, c.step);
    const std::string text = listed(broken(promiseOf(method, c, judgement), measure(method, c)));
    if (!text.empty()) out += c.name + ": " + text + "\n";
  }
  return out;
}

struct Sound {
  Vector3d moments;
  void step(RotationState& s, double h) const { steppers::rotate(s, h * s.omegaPrincipal(moments)); }
};

struct NeverNormalised {
  Vector3d moments;
  void step(RotationState& s, double h) const {
    const Quaterniond turn = expQuaternion(h * s.omegaPrincipal(moments));
    s.attitude = s.attitude * turn;
    s.momentum_principal = turn.conjugate() * s.momentum_principal;
  }
};

struct TurnsMomentumTheWrongWay {
  Vector3d moments;
  void step(RotationState& s, double h) const {
    const Vector3d theta = h * s.omegaPrincipal(moments), momentum = s.momentum_principal;
    steppers::rotate(s, theta);
    s.momentum_principal = expQuaternion(theta) * momentum;
  }
};

struct TurnsTheBodyTheWrongWay {
  Vector3d moments;
  void step(RotationState& s, double h) const { steppers::rotate(s, -h * s.omegaPrincipal(moments)); }
};

/** Buss's second-order method without its h²α/2. */
struct DropsATerm {
  Vector3d moments;
  void step(RotationState& s, double h) const {
    const Vector3d omega = s.omegaPrincipal(moments), alpha = s.momentum_principal.cross(omega).cwiseQuotient(moments);
    steppers::rotate(s, h * (omega + (h * h / 12) * alpha.cross(omega)));
  }
};

/** Looks right, and goes on from rest where it should have said that it cannot. */
struct HidesNan {
  Vector3d moments;
  void step(RotationState& s, double h) const {
    findMethod("rk4")->make(moments)->advance(s, 0, h, 1);
    if (s.momentum_principal.allFinite() && s.attitude.coeffs().allFinite()) return;
    s = RotationState();
  }
};

TEST(HardCases, catchesWhatNeverNormalises) {
  EXPECT_NE(complaintsAbout(plain<NeverNormalised>(1, true)).find("many steps: the error of the norm"),
            std::string::npos);
}

TEST(HardCases, catchesMomentumThatTurnsTheWrongWay) {
  const std::string complaints = complaintsAbout(plain<TurnsMomentumTheWrongWay>(1, true));
  EXPECT_NE(complaints.find("separatrix: the change of L"), std::string::npos) << complaints;
}

TEST(HardCases, catchesABodyThatTurnsTheWrongWay) {
  // Conserves L, and even E to first order: only the attitude tells, and judgeStep() before anything else.
  const Method method = plain<TurnsTheBodyTheWrongWay>(1, true);
  for (const HardCase& c : hardCases()) {
    const double angle = orbitRates(c.moments, c.omega).fastest() * std::abs(c.step);
    if (angle < 0.02 || angle > kShort) continue;
    EXPECT_EQ(judgeStep(method, c.moments, c.omega, c.step).grade, StepJudgement::Grade::hopeless) << c.name;
    EXPECT_NE(listed(broken(promiseOf(method, c, {}), measure(method, c))).find("the error of the attitude"),
              std::string::npos)
        << c.name;
  }
}

TEST(HardCases, catchesAMissingTerm) {
  const std::string complaints = complaintsAbout(plain<DropsATerm>(2, true));
  EXPECT_NE(complaints.find("many steps: the change of L"), std::string::npos) << complaints;
  EXPECT_NE(complaints.find("the change of E"), std::string::npos) << complaints;
}

TEST(HardCases, catchesTheDriftOfLByRounding) {
  const std::string complaints = complaintsAbout(plain<Sound>(1, true));
  EXPECT_NE(complaints.find("many steps: the change of L"), std::string::npos) << complaints;
  EXPECT_EQ(complaints.find("the error of the norm"), std::string::npos) << complaints;
}

TEST(HardCases, aStepThatHidesItsNanIsRefusedAllTheSame) {
  const Method method = plain<HidesNan>(4, false);
  for (const HardCase& c : hardCases()) {
    const auto expected = judgeStep(*findMethod("rk4"), c.moments, c.omega, c.step).grade;
    if (expected != StepJudgement::Grade::hopeless) continue;
    EXPECT_EQ(judgeStep(method, c.moments, c.omega, c.step).grade, expected) << c.name;
  }
}

TEST(HardCases, theClosedFormMeetsThemAll) {
  for (const HardCase& c : hardCases()) {
    EXPECT_EQ(listed(broken(promiseOfClosedForm(c), measureClosedForm(c))), "") << c.name;
  }
}

}  // namespace
}  // namespace poinsot
