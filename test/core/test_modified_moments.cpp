// The modified moments of the discrete Moser–Veselov map against the first terms that Hairer and Vilmart published
// (J. Phys. A 39 (2006) 13225–13235), which the code does not use.
#include "steppers/modified_moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "draws.h"

namespace poinsot {
namespace {

using Eigen::Vector3d;

struct Body {
  Vector3d moments, momentum;

  explicit Body(Draws& draws) : moments(draws.moments()), momentum(draws.uniform(0.5, 2) * draws.direction()) {}
  double energy() const { return 0.5 * momentum.dot(momentum.cwiseQuotient(moments)); }

  /** 1/μ̃ as the code finds it. */
  template <int terms>
  Vector3d found(double h) const {
    const double size = momentum.norm(), half_angular = 0.5 * h * size;
    return steppers::modifiedInverses<terms>(moments, 2 * energy() / (size * size), half_angular) / half_angular;
  }

  /** The h² term of 1/μ̃ as published: s₃/μ + d₃. */
  Vector3d publishedTerm() const {
    const double H = energy(), C = 0.5 * momentum.squaredNorm(), product = moments.prod(), sum = moments.sum();
    const double s = -moments.cwiseInverse().sum() * H / 3 + sum / (6 * product) * C;
    const double d = sum / (6 * product) * H - C / (3 * product);
    return s * moments.cwiseInverse() + Vector3d::Constant(d);
  }
  Vector3d published(double h) const { return moments.cwiseInverse() + h * h * publishedTerm(); }
};

/** By how much the two disagree, relative to 1/μ. */
template <int terms>
double difference(const Body& body, double h) {
  return (body.found<terms>(h) - body.published(h)).cwiseProduct(body.moments).norm();
}

TEST(ModifiedMoments, differFromThePublishedFirstTermsByTheNextOnes) {
  Draws draws;
  double least = 100, most = 0;
  for (int i = 0; i < 50; ++i) {
    const Body body(draws);
    const double h = 0.04 * body.moments.minCoeff() / body.momentum.norm();
    for (const double ratio :
         {difference<2>(body, 2 * h) / difference<2>(body, h), difference<5>(body, 2 * h) / difference<5>(body, h)}) {
      least = std::min(least, ratio);
      most = std::max(most, ratio);
    }
    EXPECT_LE(difference<2>(body, h), 1e-6);
  }
  std::printf("the difference at twice the step: %.3f to %.3f times\n", least, most);
  EXPECT_GE(least, 15.5);
  EXPECT_LE(most, 16.5);
}

TEST(ModifiedMoments, theH2TermIsThePublishedOneToRoundoff) {
  Draws draws;
  double worst = 0;
  for (int i = 0; i < 50; ++i) {
    const Body body(draws);
    const double h = 0.2 * body.moments.minCoeff() / body.momentum.norm();
    // Five terms: (1/μ̃ − 1/μ)/h² is a polynomial in h² but for h⁸; at h, h/2, h/3, h/4 it is brought to h = 0.
    Vector3d term = Vector3d::Zero();
    for (int j = 1; j <= 4; ++j) {
      double weight = 1;
      for (int k = 1; k <= 4; ++k) weight *= k == j ? 1 : 1.0 * j * j / (j * j - k * k);
      const double step = h / j;
      term += weight * (body.found<5>(step) - body.moments.cwiseInverse()) / (step * step);
    }
    worst = std::max(worst, (term - body.publishedTerm()).norm() / body.publishedTerm().norm());
  }
  std::printf("the h² term: off by %.1e\n", worst);
  EXPECT_LE(worst, 2e-11);
}

TEST(ModifiedMoments, withoutATermBeyondTheFirstTheyAreTheMoments) {
  Draws draws;
  for (int i = 0; i < 50; ++i) {
    const Body body(draws);
    EXPECT_LE((body.found<1>(0.3) - body.moments.cwiseInverse()).cwiseProduct(body.moments).norm(), 1e-15);
  }
}

TEST(ModifiedMoments, areEvenInHAndDoNotDependOnTheOrderOfTheAxes) {
  Draws draws;
  for (int i = 0; i < 50; ++i) {
    Body body(draws);
    const Vector3d before = body.found<5>(0.1);
    body.moments = Vector3d(body.moments[2], body.moments[0], body.moments[1]);
    body.momentum = Vector3d(body.momentum[2], body.momentum[0], body.momentum[1]);
    const Vector3d after = body.found<5>(-0.1);
    EXPECT_LE((Vector3d(after[1], after[2], after[0]) - before).cwiseQuotient(before).norm(), 2e-15);
  }
}

}  // namespace
}  // namespace poinsot
