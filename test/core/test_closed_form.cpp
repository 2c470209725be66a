// Quantities of a motion that the closed form gives besides its states, against published figures, formulas evaluated
// here and the motion itself; and what it refuses. The states are judged by test_closed_form_rows.cpp.
#include "poinsot/core/closed_form.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace poinsot {
namespace {

using Regime = ClosedForm::Regime;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegree = M_PI / 180;

const Eigen::Quaterniond kAttitude(-0.37, 0.74, -0.33, -0.46);  // of no particular length

struct Body {
  Eigen::Vector3d moments, omega;

  ClosedForm closedForm() const { return {moments, kAttitude, omega}; }
  Eigen::Vector3d momentum() const { return moments.cwiseProduct(omega); }
  double energy() const { return omega.dot(momentum()) / 2; }
  int middleAxis() const {
    int low = 0, high = 0;
    moments.minCoeff(&low);
    moments.maxCoeff(&high);
    return 3 - low - high;
  }
};

/** In general motion: about either axis, in all orders, from nearly round polhodes to near the separatrix. */
const std::vector<Body> kBodies = {
    {{1, 2, 3}, {0.7, 0.4, 0.9}},          {{1, 3, 2}, {1.5, -0.4, 0.3}},    {{2, 1, 3}, {0.3, -1.4, -0.2}},
    {{3, 1, 2}, {0.01, -0.02, 1}},         {{2, 3, 1}, {-1, 1e-4, 1e-4}},    {{3, 2, 1}, {0.6, -1, -1.1}},
    {{4, 5, 9}, {3.003, 0.5, -1}},         {{9, 4, 5}, {1, 2.9999997, 0.5}}, {{1, 1.01, 1.02}, {0.3, 0.4, -0.5}},
    {{1e-3, 1, 1.0005}, {0.5, 0.2, -0.3}}, {{0.1, 1, 8}, {0.5, 0.2, -0.3}},
};

std::string named(const Body& body) {
  std::ostringstream out;
  out << "moments " << body.moments.transpose() << ", omega " << body.omega.transpose();
  return out.str();
}

// --- The period

double periodOf(const Body& body) {
  return body.closedForm().period();
}

TEST(ClosedFormPeriod, nearTheUnstableAxis) {
  const auto near = [](double epsilon) { return periodOf({{1, 2, 3}, {epsilon, 1, epsilon}}); };
  EXPECT_NEAR(near(1e-2), 39.105734, 5e-7);
  EXPECT_NEAR(near(1e-4), 71.014506, 5e-7);
  EXPECT_NEAR(near(1e-8), 134.825617, 5e-7);
  EXPECT_NEAR(near(1e-12), 198.636727, 5e-7);
  EXPECT_NEAR(near(1e-100), 1602.481145, 5e-7);
}

TEST(ClosedFormPeriod, ofBodiesInTheLiterature) {
  EXPECT_NEAR(periodOf({{500, 200, 300}, {0.5, -0.4, 0.7}}), 11.931324, 5e-7);  // Basilisk's test body
  EXPECT_NEAR(periodOf({{3, 5, 9}, {0, 2. / 5, 0.01 / 9}}), 118.1109, 5e-5);    // Principia's Dzhanibekov body
  EXPECT_NEAR(periodOf({{0.3, 0.35, 0.4}, {0.1, 15, 0.1}}), 12.3349458, 5e-8);  // a plotted example
  const Body toutatis{{3.0836, 3.235, 1}, Eigen::Vector3d(14.51, 33.529, -98.709) * kDegree};  // days
  EXPECT_NEAR(periodOf(toutatis), 5.3685, 5e-5);
  EXPECT_EQ(toutatis.closedForm().encircledAxis(), 2);
  // Its long axis goes round L once less in each of these periods than the body turns.
  const double long_axis = std::abs(toutatis.closedForm().precessionRate() - 2 * M_PI / periodOf(toutatis));
  EXPECT_NEAR(2 * M_PI / long_axis, 7.4117, 5e-5);
}

TEST(ClosedFormPeriod, ofSymmetricBodies) {
  // Ω goes round the axis of symmetry at |μ₃ − μ₁|/μ₁ |Ω₃|. The rigid Earth: (C−A)/C = .0032737949.
  const double e = 0.0032737949;
  EXPECT_NEAR(periodOf({{1 - e, 1 - e, 1}, {1e-6, 0, 2 * M_PI}}), 304.46, 5e-3);  // sidereal days
  EXPECT_DOUBLE_EQ(periodOf({{2, 2, 1}, {0.3, -0.8, 1.5}}), 2 * M_PI / 0.75);
  EXPECT_DOUBLE_EQ(periodOf({{1, 4, 4}, {-0.5, 1e-9, 7}}), 2 * M_PI / 0.375);
  EXPECT_DOUBLE_EQ(periodOf({{1, 2, 1}, {3e-200, -2e-200, 0}}), 2 * M_PI / 2e-200);
}

TEST(ClosedFormPeriod, isInfiniteWhereOmegaDoesNotComeBackOrNeverLeaves) {
  for (const Body& body : std::vector<Body>{{{4, 5, 9}, {3, -1, 1}},
                                            {{1, 2, 3}, {0, 1, 0}},
                                            {{1, 2, 3}, {0, 0, -1}},
                                            {{1, 2, 3}, {0, 0, 0}},
                                            {{2, 2, 2}, {1, 2, 3}},
                                            {{2, 2, 1}, {1, 2, 0}}}) {
    EXPECT_EQ(periodOf(body), kInfinity) << named(body);
    EXPECT_TRUE(std::isnan(body.closedForm().montgomeryAngle())) << named(body);
  }
}

TEST(ClosedFormPeriod, bringsOmegaBackAndHalfOfItDoesNot) {
  for (const Body& body : kBodies) {
    const ClosedForm form = body.closedForm();
    const double period = form.period();
    for (const double t : {0.0, 0.13 * period, -3.7 * period}) {
      const Eigen::Vector3d omega = form.at(t).omega_principal;
      EXPECT_LE((form.at(t + period).omega_principal - omega).norm(), 1e-13 * omega.norm()) << named(body);
      Eigen::Vector3d moving = omega;  // what of it is not along the encircled axis
      moving[form.encircledAxis()] = 0;
      EXPECT_GT((form.at(t + period / 2).omega_principal - omega).norm(), moving.norm()) << named(body);
    }
  }
}

// --- Flips

/** When the component along the middle axis changes sign: from − to + or the other way; not merely touches zero. */
void expectFlipAfter(const Body& body, const ClosedForm& form, double t) {
  const double wait = form.timeToNextFlip(t);
  ASSERT_GT(wait, 0) << named(body);
  ASSERT_LE(wait, form.period() / 2 * (1 + 1e-14)) << named(body);
  const auto component = [&](double when) { return form.at(when).omega_principal[body.middleAxis()]; };
  const double early = 1e-6 * wait, before = component(t + wait - early);
  EXPECT_LT(before * component(t + wait + early), 0) << named(body) << " t " << t;
  // t + wait is a rounded time, and wait itself: an ulp each. Ω is right to 2e-15 of itself.
  const double late = 2.3e-16 * (std::abs(t) + 2 * wait);
  const double off = 2e-15 * form.at(t + wait).omega_principal.norm();
  EXPECT_LE(std::abs(component(t + wait)), std::abs(before) * late / early + off) << named(body) << " t " << t;
  for (double part = 1e-3; part < 1; part += 1e-3) {
    ASSERT_GT(component(t + part * wait) * before, 0) << named(body) << " t " << t << " part " << part;
  }
}

TEST(ClosedFormFlips, comeWhenSaidAndNotBefore) {
  std::vector<Body> bodies = kBodies;
  bodies.push_back({{1, 2, 3}, {1e-100, 1, 1e-100}});
  bodies.push_back({{4, 5, 9}, {std::nextafter(3, 4), -0.5, 1}});
  bodies.push_back({{6, 4, 3}, {-1, 1e-3, std::nextafter(2, 0)}});
  for (const Body& body : bodies) {
    const ClosedForm form = body.closedForm();
    for (const double periods : {0.0, 0.2, 0.45, 0.7, -0.9, 12.3, -40.6}) {
      expectFlipAfter(body, form, periods * form.period());
    }
  }
}

TEST(ClosedFormFlips, followEachOtherAtHalfAPeriod) {
  for (const Body& body : kBodies) {
    const ClosedForm form = body.closedForm();
    double t = form.timeToNextFlip(0);
    for (int i = 0; i < 20; ++i) {
      const double inside = t + form.period() / 8;
      const double next = inside + form.timeToNextFlip(inside);
      EXPECT_NEAR(next - t, form.period() / 2, 1e-13 * form.period() * (i + 1)) << named(body);
      t = next;
    }
  }
}

TEST(ClosedFormFlips, onTheSeparatrixThereIsOneOrNone) {
  // Ω₂ = √10 tanh(pt + v), p = √10/3, tanh v = Ω₂(0)/√10, or the same backwards.
  const double v = std::atanh(1 / std::sqrt(10)), p = std::sqrt(10) / 3;
  for (const double a : {3, -3}) {
    for (const double b : {1, -1}) {
      for (const double c : {1, -1}) {
        const Body body{{4, 5, 9}, {a, b, c}};
        const ClosedForm form = body.closedForm();
        const bool ahead = a * b * c < 0;  // Ω̇₂ = Ω₁Ω₃
        const double flip = (ahead ? 1 : -1) * v / p;
        if (ahead) {
          EXPECT_NEAR(form.timeToNextFlip(0), flip, 1e-15) << named(body);
        } else {
          EXPECT_EQ(form.timeToNextFlip(0), kInfinity) << named(body);
        }
        EXPECT_NEAR(form.timeToNextFlip(flip - 0.25), 0.25, 1e-15) << named(body);
        EXPECT_NEAR(form.timeToNextFlip(flip - 1000), 1000, 3e-13) << named(body);  // that far each ulp is 1e-13
        EXPECT_EQ(form.timeToNextFlip(flip + 0.25), kInfinity) << named(body);
        EXPECT_EQ(form.timeToNextFlip(1e300), kInfinity) << named(body);
      }
    }
  }
}

TEST(ClosedFormFlips, neverComeWhereThereIsNoMiddleAxisOrNoMotion) {
  for (const Body& body : std::vector<Body>{{{2, 2, 1}, {0.3, -0.8, 1.5}},
                                            {{1, 3, 3}, {0.3, -0.8, 1.5}},
                                            {{1, 2, 3}, {0, 1, 0}},
                                            {{1, 2, 3}, {1, 0, 0}},
                                            {{1, 2, 3}, {0, 0, 0}},
                                            {{2, 2, 2}, {1, 2, 3}}}) {
    for (const double t : {0.0, -3.0, 1e9}) EXPECT_EQ(body.closedForm().timeToNextFlip(t), kInfinity) << named(body);
  }
}

// --- The turn about L

/** ∮ (1 − cos θ) dφ of L in body axes over a period, θ and φ about the axis that the polhode goes round. */
double solidAngle(const Body& body, const ClosedForm& form) {
  const int axis = form.encircledAxis();
  const double side = body.omega[axis] < 0 ? -1 : 1;
  const Eigen::Vector3d a = side * Eigen::Vector3d::Unit(axis);
  // Equal weights at equal times: of a periodic function that converges faster than any power.
  constexpr int kPoints = 1 << 14;
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    const Eigen::Vector3d omega = form.at(i * form.period() / kPoints).omega_principal;
    const Eigen::Vector3d l = body.moments.cwiseProduct(omega), across = l - l.dot(a) * a;
    const double turning = a.dot(across.cross(l.cross(omega))) / across.squaredNorm();  // dφ/dt; dΛ/dt = Λ × Ω
    sum += across.squaredNorm() / (l.norm() * (l.norm() + l.dot(a))) * turning;         // 1 − cos θ
  }
  return sum * form.period() / kPoints;
}

TEST(ClosedFormMontgomery, isTwoETOverLLessTheSolidAngle) {
  for (const Body& body : kBodies) {
    const ClosedForm form = body.closedForm();
    const double wanted = 2 * body.energy() * form.period() / body.momentum().norm() - solidAngle(body, form);
    EXPECT_NEAR(form.montgomeryAngle(), wanted, 1e-12 * std::max(10.0, wanted)) << named(body);
  }
}

TEST(ClosedFormMontgomery, isTheTurnAboutLInAPeriod) {
  for (const Body& body : kBodies) {
    const ClosedForm form = body.closedForm();
    const Eigen::Quaterniond q0 = form.at(0).attitude;
    const Eigen::AngleAxisd turn(form.montgomeryAngle(), (q0 * body.momentum()).normalized());
    // The quaternion does not jump, so this holds of its sign too. The period is a rounded number.
    const double tolerance = 2e-15 + 3e-16 * (form.period() * body.omega.norm() + form.montgomeryAngle());
    EXPECT_LE((form.at(form.period()).attitude.coeffs() - (turn * q0).coeffs()).norm(), tolerance) << named(body);
  }
}

/** The turn about L from t = 0 on, followed in small steps: of the frame in which L in body axes is turned onto the
 * encircled axis by the shortest way. */
double turnFollowed(const Body& body, const ClosedForm& form, double end, int steps) {
  const int axis = form.encircledAxis();
  const Eigen::Vector3d a = (body.omega[axis] < 0 ? -1 : 1) * Eigen::Vector3d::Unit(axis);
  const auto frame = [&](const ClosedForm::State& state) -> Eigen::Quaterniond {
    const Eigen::Vector3d l = body.moments.cwiseProduct(state.omega_principal);
    return state.attitude * Eigen::Quaterniond::FromTwoVectors(a, l);
  };
  Eigen::Quaterniond last = frame(form.at(0));
  const Eigen::Vector3d direction = (form.at(0).attitude * body.momentum()).normalized();
  double sum = 0;
  for (int i = 1; i <= steps; ++i) {
    const Eigen::Quaterniond now = frame(form.at(end * i / steps)), step = now * last.conjugate();
    double half = std::atan2(step.vec().dot(direction), step.w());
    if (half > M_PI / 2) half -= M_PI;
    if (half < -M_PI / 2) half += M_PI;
    EXPECT_LT(std::abs(half), 0.5);  // else turns might be lost
    sum += 2 * half;
    last = now;
  }
  return sum;
}

TEST(ClosedFormPrecession, isTheMeanOverLongTimes) {
  for (const Body& body : kBodies) {
    const ClosedForm form = body.closedForm();
    EXPECT_DOUBLE_EQ(form.precessionRate(), form.montgomeryAngle() / form.period()) << named(body);
    // Exactly for whole periods; for other times within the variation of one period.
    const int steps = 5 * static_cast<int>(std::ceil(40 * form.montgomeryAngle() / M_PI));
    EXPECT_NEAR(turnFollowed(body, form, 5 * form.period(), 5 * steps), 5 * form.montgomeryAngle(),
                1e-11 * form.montgomeryAngle())
        << named(body);
    const double t = 31.4 * form.period();
    EXPECT_NEAR(turnFollowed(body, form, t, 32 * steps) / t, form.precessionRate(), 2 * M_PI / t) << named(body);
  }
}

TEST(ClosedFormPrecession, ofSymmetricBodiesIsLOverTheEqualMoments) {
  // There R is a turn at |L|/μ₁ about L, followed by one about the axis of symmetry; those at equal moments count as
  // the latter too: (μ₁ − μ₃)/μ₁ Ω₃ about it.
  const Body tall{{2, 2, 1}, {0.3, -0.8, 1.5}}, flat{{1, 1, 1.8}, {0.3, -0.8, 1.5}};
  for (const Body& body : {tall, flat}) {
    const double along = (body.moments[0] - body.moments[2]) / body.moments[0] * body.omega[2];
    EXPECT_DOUBLE_EQ(body.closedForm().precessionRate(), body.momentum().norm() / body.moments[0] + along)
        << named(body);
  }
}

TEST(ClosedFormPrecession, whereOmegaIsConstantOrTendsToAnAxis) {
  const auto rate = [](const Body& body) { return body.closedForm().precessionRate(); };
  EXPECT_DOUBLE_EQ(rate({{4, 5, 9}, {3, -1, 1}}), Eigen::Vector3d(12, -5, 9).norm() / 5);
  EXPECT_DOUBLE_EQ(rate({{1, 2, 3}, {0, -0.7, 0}}), 0.7);
  EXPECT_DOUBLE_EQ(rate({{1, 2, 3}, {0, 0, 0.7}}), 0.7);
  EXPECT_DOUBLE_EQ(rate({{2, 2, 1}, {3, -4, 0}}), 5);
  EXPECT_DOUBLE_EQ(rate({{2, 2, 2}, {2, -3, 6}}), 7);
  EXPECT_EQ(rate({{1, 2, 3}, {0, 0, 0}}), 0);
}

// --- Regimes

struct Known {
  Body body;
  Regime regime;
  int axis;
};

TEST(ClosedFormRegime, isDecidedExactly) {
  const double above = std::nextafter(3, 4), below = std::nextafter(3, 0), tiny = 5e-324;
  for (const Known& known : std::vector<Known>{
           {{{1, 2, 3}, {0.7, 0.4, 0.9}}, Regime::general, 2},
           {{{1, 2, 3}, {1, 0.1, 0.2}}, Regime::general, 0},
           {{{3, 1, 2}, {0.9, 0.7, 0.4}}, Regime::general, 0},
           {{{4, 5, 9}, {3, -1, 1}}, Regime::separatrix, -1},
           {{{4, 5, 9}, {-3, 0, 1}}, Regime::separatrix, -1},
           {{{9, 4, 5}, {1, 3, 1e-9}}, Regime::separatrix, -1},
           {{{3, 6, 4}, {2e-200, 1e-200, 1e-300}}, Regime::separatrix, -1},
           {{{4, 5, 9}, {above, -1, 1}}, Regime::general, 0},
           {{{4, 5, 9}, {below, -1, 1}}, Regime::general, 2},
           {{{4, std::nextafter(5, 6), 9}, {3, -1, 1}}, Regime::general, 0},
           {{{4, std::nextafter(5, 4), 9}, {3, -1, 1}}, Regime::general, 2},
           {{{1, 2, 3}, {0, 1, 0}}, Regime::steady, 1},
           {{{1, 2, 3}, {0, -1, tiny}}, Regime::general, 2},
           {{{1, 2, 3}, {tiny, 1, 0}}, Regime::general, 0},
           {{{1, 2, 3}, {tiny, 1, tiny}}, Regime::general, 2},
           {{{1, 2, 3}, {-2, 0, -0.0}}, Regime::steady, 0},
           {{{1, 2, 3}, {0, 0, 0}}, Regime::steady, -1},
           {{{2, 2, 1}, {0.3, -0.8, 1.5}}, Regime::general, 2},
           {{{2, 1, 2}, {0.3, tiny, 1.5}}, Regime::general, 1},
           {{{2, 2, 1}, {0.3, -0.8, 0}}, Regime::steady, -1},
           {{{2, 2, 1}, {0, 0, 1}}, Regime::steady, 2},
           {{{2, 2, 1}, {0, 1, 0}}, Regime::steady, 1},
           {{{2, 2, 2}, {0.3, -0.8, 1}}, Regime::steady, -1},
           {{{2, 2, 2}, {0, -0.8, 0}}, Regime::steady, 1},
           {{{1, 1 + 2e-16, 1 + 5e-16}, {0.3, -0.8, 1}}, Regime::general, 2},
       }) {
    const ClosedForm form = known.body.closedForm();
    EXPECT_EQ(form.regime(), known.regime) << named(known.body);
    EXPECT_EQ(form.encircledAxis(), known.axis) << named(known.body);
  }
}

using Exact = boost::multiprecision::cpp_bin_float_100;  // 334 bits: as good as exact

/** F − 2Eμₖ = Σ μᵢ(μᵢ − μₖ)Ωᵢ² */
Exact discriminant(const Body& body, int k) {
  Exact sum = 0;
  for (int i = 0; i < 3; ++i) {
    const Exact moment(body.moments[i]), omega(body.omega[i]);
    sum += moment * (moment - Exact(body.moments[k])) * omega * omega;
  }
  return sum;
}

TEST(ClosedFormSeparatrixDistance, byTheFormula) {
  for (const Body& body : kBodies) {
    const ClosedForm form = body.closedForm();
    const int axis = form.encircledAxis(), middle = body.middleAxis(), other = 3 - axis - middle;
    const Exact squared = (Exact(body.moments[axis]) - body.moments[other]) * discriminant(body, middle) /
                          ((Exact(body.moments[axis]) - body.moments[middle]) * discriminant(body, other));
    const double wanted = std::sqrt(static_cast<double>(squared));
    EXPECT_NEAR(form.separatrixDistance() / wanted, 1, 1e-15) << named(body);
  }
}

TEST(ClosedFormSeparatrixDistance, isRelativelyExactHoweverSmall) {
  // k'² = 2ε²/(1 + 3ε²)
  for (const double epsilon : {1e-3, 1e-8, 1e-30, 1e-150, 1e-200, 1e-300}) {
    const double wanted = std::sqrt(2 / (1 + 3 * epsilon * epsilon));
    const Body body{{1, 2, 3}, {epsilon, 1, -epsilon}};
    EXPECT_NEAR(body.closedForm().separatrixDistance() / epsilon / wanted, 1, 1e-15) << epsilon;
  }
  // F − 2Eμ₂ = 4(3 − Ω₁)(3 + Ω₁), exactly. About axis 3: F − 2Eμ₁ = 5Ω₂² + 45.
  for (const double off : {4.5e-16, 1e-15, 1e-12, 1e-6}) {
    const double o1 = 3 - off;
    const double squared = 5 * 4 * (3 - o1) * (3 + o1) / (4 * (5 * 0.25 + 45));
    EXPECT_NEAR((Body{{4, 5, 9}, {o1, 0.5, -1}}.closedForm().separatrixDistance()) / std::sqrt(squared), 1, 1e-15);
  }
}

TEST(ClosedFormSeparatrixDistance, isOneOnCirclesAndNoneOnTheSeparatrix) {
  const auto distance = [](const Body& body) { return body.closedForm().separatrixDistance(); };
  EXPECT_EQ(distance({{4, 5, 9}, {3, -1, 1}}), 0);
  EXPECT_EQ(distance({{4, 5, 9}, {0, -1, 0}}), 0);
  EXPECT_EQ(distance({{4, 5, 9}, {0, 0, 1}}), 1);
  EXPECT_EQ(distance({{4, 5, 9}, {0, 0, 0}}), 1);
  EXPECT_EQ(distance({{2, 2, 1}, {0.3, -0.8, 1.5}}), 1);
  EXPECT_EQ(distance({{2, 2, 1}, {0.3, -0.8, 0}}), 1);
  EXPECT_NEAR(distance({{1, 2, 3}, {1e-9, 1e-9, 1}}), 1, 1e-15);
}

// --- States

TEST(ClosedFormState, ofTheTumblingBrick) {
  // NASA/TM-2015-218675 vol. II, check-case 2, recomputed from its inputs; slug·ft², deg/s.
  const Body brick{{.001894220, .006211019, .007194665}, Eigen::Vector3d(10, 20, 30) * kDegree};
  const Eigen::Vector3d omega = brick.closedForm().at(30).omega_principal / kDegree;
  EXPECT_NEAR(omega[0], 12.618391, 5e-7);
  EXPECT_NEAR(omega[1], -17.397475, 5e-7);
  EXPECT_NEAR(omega[2], 31.119589, 5e-7);
}

/** Bodies of every regime. */
std::vector<Body> allKinds() {
  std::vector<Body> bodies = kBodies;
  for (const Body& body : std::vector<Body>{{{4, 5, 9}, {3, -1, 1}},
                                            {{1, 2, 3}, {1e-100, 1, -1e-100}},
                                            {{1, 2, 3}, {0, 1, 0}},
                                            {{2, 2, 1}, {0.3, -0.8, 1.5}},
                                            {{1.5, 1.5, 1.5}, {0.3, -0.8, 1.5}},
                                            {{1, 2, 3}, {0, 0, 0}}}) {
    bodies.push_back(body);
  }
  return bodies;
}

TEST(ClosedFormState, atZeroIsTheStart) {
  const Eigen::Quaterniond attitudes[] = {kAttitude,
                                          {1, 0, 0, 0},
                                          {0, 0, -1, 0},
                                          {0.1, 0.2, -0.3, 1e-300},
                                          {3e200, 1e200, 0, -2e200},
                                          {1e-310, -1e-310, 2e-310, 0}};
  for (const Body& body : allKinds()) {
    for (const Eigen::Quaterniond& q0 : attitudes) {
      for (const double zero : {0.0, -0.0}) {
        const ClosedForm::State state = ClosedForm(body.moments, q0, body.omega).at(zero);
        Eigen::Matrix<long double, 4, 1> wanted = q0.coeffs().cast<long double>().stableNormalized();
        const Eigen::Matrix<long double, 4, 1> got = state.attitude.coeffs().cast<long double>();
        if (wanted.dot(got) < 0) wanted = -wanted;
        EXPECT_LE((got - wanted).norm(), 4e-16) << named(body);
        EXPECT_LE((state.omega_principal - body.omega).norm(), 1e-15 * body.omega.norm()) << named(body);
      }
    }
  }
}

/** Whether it runs smoothly from row to row: no half turn of the quaternion between any two. */
void expectSmooth(const ClosedForm::Samples& samples, const Body& body) {
  for (Eigen::Index i = 1; i < samples.rows(); ++i) {
    ASSERT_GT(samples.row(i).head<4>().dot(samples.row(i - 1).head<4>()), 0.99) << named(body) << " row " << i;
  }
}

TEST(ClosedFormState, theSignOfTheQuaternionDoesNotJump) {
  for (const Body& body : allKinds()) {
    const ClosedForm form = body.closedForm();
    // Through several half-periods; 0.1 rad a step at most. Ω stays below |L|/μ and √(2E/μ) of the smallest moment.
    const double smallest = body.moments.minCoeff();
    const double fastest = std::min(body.momentum().norm() / smallest, std::sqrt(2 * body.energy() / smallest));
    const double reach = std::isfinite(form.period()) ? 3.3 * form.period() : 60;
    const double dt = fastest > 0 ? std::min(0.1 / fastest, reach / 1000) : 1;
    const auto n = static_cast<Eigen::Index>(2 * reach / dt);
    expectSmooth(form.sample(-reach, dt, n), body);
    ClosedForm::Samples singly(n, 7);
    for (Eigen::Index i = 0; i < n; ++i) {
      const ClosedForm::State state = form.at(-reach + static_cast<double>(i) * dt);
      const Eigen::Vector4d q(state.attitude.w(), state.attitude.x(), state.attitude.y(), state.attitude.z());
      singly.row(i) << q.transpose(), state.omega_principal.transpose();
    }
    expectSmooth(singly, body);
    expectSmooth(form.sample(1e9, dt, n), body);
  }
}

TEST(ClosedFormState, timesOfAGridAreNotRounded) {
  // 1e9 + j·0.1 is no double: to round it would turn the body by some 1e-8 rad. j·0.1 is one for j = 2ⁱ.
  for (const Body& body :
       std::vector<Body>{kBodies[0], kBodies[1], kBodies[4], kBodies[6], {{2, 2, 1}, {0.3, 0.8, 1.5}}}) {
    const ClosedForm form = body.closedForm();
    const ClosedForm::State start = form.at(1e9);
    const ClosedForm from_there(body.moments, start.attitude, start.omega_principal);
    const ClosedForm::Samples samples = form.sample(1e9, 0.1, 33);
    for (int j = 1; j <= 32; j *= 2) {
      const ClosedForm::State wanted = from_there.at(j * 0.1);
      const auto row = samples.row(j);
      const Eigen::Quaterniond q(row[0], row[1], row[2], row[3]);
      // The state at 1e9 s is rounded; that much it differs.
      EXPECT_LE((q.conjugate() * wanted.attitude).vec().norm(), 1e-14) << named(body) << " j " << j;
    }
  }
}

TEST(ClosedFormState, omegaBeyondDoublesIsInfiniteNotNaN) {
  // Ω₁ grows to some 1e310 rad/s.
  const ClosedForm form({1e-20, 1, 2}, kAttitude, {0, 1e300, 1e300});
  int infinite = 0, finite = 0;
  for (int i = -100; i <= 100; ++i) {
    const ClosedForm::State state = form.at(i * 1e-312);
    EXPECT_FALSE(state.omega_principal.hasNaN()) << i;
    EXPECT_NEAR(state.attitude.norm(), 1, 1e-15) << i;
    ++(state.omega_principal.allFinite() ? finite : infinite);
  }
  EXPECT_GT(infinite, 0);
  EXPECT_GT(finite, 0);
}

// --- Refusals

void expectRefused(const std::function<void()>& call, const std::vector<std::string>& mentioned) {
  try {
    call();
    FAIL() << "not refused; expected words: " << mentioned[0];
  } catch (const std::invalid_argument& error) {
    for (const std::string& word : mentioned) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << "\"" << word << "\" in: " << error.what();
    }
  }
}

TEST(ClosedFormRefuses, momentsOfNoBody) {
  for (int i = 0; i < 3; ++i) {
    const auto with = [i](double value) {
      return [i, value] {
        Eigen::Vector3d moments(1, 2, 3);
        moments[i] = value;
        ClosedForm(moments, kAttitude, {1, 2, 3});
      };
    };
    const std::string name = "moment " + std::to_string(i + 1);
    const std::string expected = name + ": expected a positive finite number (kg·m²), got ";
    expectRefused(with(0), {expected + "0"});
    expectRefused(with(-0.5), {expected + "-0.5"});
    expectRefused(with(kInfinity), {expected + "inf"});
    expectRefused(with(kNaN), {expected, "nan"});
  }
}

TEST(ClosedFormRefuses, omegaThatIsNotFinite) {
  for (int i = 0; i < 3; ++i) {
    for (const double bad : {kNaN, kInfinity, -kInfinity}) {
      Eigen::Vector3d omega(1, 0, -1);
      omega[i] = bad;
      expectRefused(
          [&] {
            ClosedForm({1, 2, 3}, kAttitude, omega);
          },
          {"component " + std::to_string(i + 1) + " of the angular velocity: expected a finite number (rad/s)",
           std::isnan(bad) ? "nan"
           : bad > 0       ? "got inf"
                           : "got -inf"});
    }
  }
}

TEST(ClosedFormRefuses, attitudesThatAreNone) {
  expectRefused([] { ClosedForm({1, 2, 3}, {0, 0, -0.0, 0}, {1, 2, 3}); }, {"0, 0, -0, 0", "other than zero"});
  for (int i = 0; i < 4; ++i) {
    for (const double bad : {kNaN, kInfinity}) {
      Eigen::Quaterniond q = kAttitude;
      q.coeffs()[i] = bad;
      expectRefused([&] { ClosedForm({1, 2, 3}, q, {1, 2, 3}); }, {std::isnan(bad) ? "nan" : "inf", "finite"});
    }
  }
}

TEST(ClosedFormRefuses, timesThatAreNotFinite) {
  for (const Body& body : allKinds()) {
    const ClosedForm form = body.closedForm();
    for (const double bad : {kNaN, kInfinity, -kInfinity}) {
      const std::string value = std::isnan(bad) ? "nan" : "inf";
      expectRefused([&] { form.at(bad); }, {value, "finite"});
      expectRefused([&] { form.timeToNextFlip(bad); }, {value, "finite"});
      expectRefused([&] { form.sample(bad, 1, 3); }, {value, "finite"});
      expectRefused([&] { form.sample(0, bad, 3); }, {value, "finite"});
    }
  }
}

}  // namespace
}  // namespace poinsot
