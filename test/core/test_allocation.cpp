// The closed form and the steppers never allocate, not even when first called.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "allocation_counter.h"
#include "poinsot/core/closed_form.h"
#include "poinsot/core/method.h"
#include "poinsot/core/no_convergence.h"
#include "poinsot/core/step_limits.h"
#include "torqued_bodies.h"

namespace poinsot {
namespace {

// Results are stored here, so that the optimiser does not remove their computation.
volatile double sink;

struct Case {
  const char* name;
  Eigen::Vector3d moments;
  Eigen::Vector3d omega;
};

const double kTiny = std::numeric_limits<double>::denorm_min();

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"general", {1, 2, 3}, {0.6, 0.5, 0.7}},
      {"general, round the axis of least moment", {1, 2, 3}, {0.9, 0.1, 0.1}},
      {"in no order", {3, 1, 2}, {-0.6, 0.5, -0.7}},
      {"near the separatrix", {2, 5, 6}, {0.5, 0.3, 0.5 * (1 + 1e-8)}},
      {"an ulp from the separatrix", {2, 5, 6}, {0.5, 0.3, std::nextafter(0.5, 1)}},
      {"on the separatrix", {2, 5, 6}, {0.5, 0.3, -0.5}},
      {"near the unstable axis", {1, 2, 3}, {1e-8, 1, 1e-8}},
      {"very near the unstable axis", {1, 2, 3}, {1e-140, 1, 1e-140}},
      {"denormal beside the unstable axis", {1, 2, 3}, {kTiny, 1, kTiny}},
      {"on the unstable axis", {1, 2, 3}, {0, 1, 0}},
      {"spin about a stable axis", {1, 2, 3}, {0, 0, 1}},
      {"rest", {1, 2, 3}, {0, 0, 0}},
      {"sphere", {2, 2, 2}, {0.6, 0.5, 0.7}},
      {"symmetric, flat", {1, 1, 2}, {0.6, 0.5, 0.7}},
      {"symmetric, long", {2, 2, 1}, {0.6, 0.5, 0.7}},
      {"nearly symmetric", {1, std::nextafter(1.0, 2), 2}, {0.6, 0.5, 0.7}},
      {"extreme ratio", {1, 1e6, 1e12}, {0.6, 0.5, 0.7}},
      {"slow", {1, 2, 3}, {0.6e-200, 0.5e-200, 0.7e-200}},
      {"fast", {1, 2, 3}, {0.6e150, 0.5e150, 0.7e150}},
      {"largest", {1e300, 1.5e300, 1e300}, {1e300, 1e300, 1e-300}},
      {"smallest", {kTiny, 2 * kTiny, 3 * kTiny}, {kTiny, 0.5, kTiny}},
  };
  return all;
}

const double kTimes[] = {0, 1e-3, -1, 123.456, -1e9, 1e17, 1e100, -1e300, 1e-300};

// First in the file: the closed form has never been called when it runs.
TEST(Allocation, firstUseAllocatesNothing) {
  ClosedForm::Samples table(100, 7);
  const AllocationCounter counter;
  const ClosedForm form({1, 2, 3}, Eigen::Quaterniond(0.5, -0.1, 0.7, 0.3), {0.6, 0.5, 0.7});
  sink = form.at(1e9).attitude.w();
  form.sample(1e9, 0.1, table);
  EXPECT_EQ(counter.count(), 0);
}

/** The first far times in the process, at which Boost allocates its constants once, as the header says. */
long allocationsOfBoostsConstants() {
  const ClosedForm form({1, 2, 3}, Eigen::Quaterniond::Identity(), {0.6, 0.5, 0.7});
  const AllocationCounter counter;
  for (const double t : {1e17, 1e300}) sink = form.at(t).attitude.w();
  return counter.count();
}

TEST(Allocation, closedFormAllocatesNothing) {
  EXPECT_LE(allocationsOfBoostsConstants(), 100);
  const std::vector<Case>& all = cases();
  ClosedForm::Samples table(1000, 7);
  const Eigen::Quaterniond attitude(0.5, -0.1, 0.7, 0.3);
  for (const Case& c : all) {
    const AllocationCounter counter;
    const ClosedForm form(c.moments, attitude, c.omega);
    EXPECT_EQ(counter.count(), 0) << c.name << ": set-up";
  }
  for (const Case& c : all) {
    const ClosedForm form(c.moments, attitude, c.omega);
    for (const double t : kTimes) {
      const AllocationCounter counter;
      sink = form.at(t).attitude.w();
      EXPECT_EQ(counter.count(), 0) << c.name << ": at " << t;
    }
    for (const double t : kTimes) {
      for (const double dt : {1.0 / 60, -1.0, 1e8, 0.0}) {
        const AllocationCounter counter;
        form.sample(t, dt, table);
        sink = table(999, 0);
        EXPECT_EQ(counter.count(), 0) << c.name << ": grid from " << t << " by " << dt;
      }
    }
    for (const int rows : {0, 1, 2, 3, 5, 7, 8, 9, 17, 63, 64, 65}) {
      const AllocationCounter counter;
      form.sample(1, 0.1, table.topRows(rows));
      EXPECT_EQ(counter.count(), 0) << c.name << ": grid of " << rows;
    }
    {
      const AllocationCounter counter;
      const ClosedForm copy = form;
      ClosedForm other = copy;
      other = form;
      sink = other.at(1).omega_principal.x();
      EXPECT_EQ(counter.count(), 0) << c.name << ": copies";
    }
    {
      const AllocationCounter counter;
      sink = static_cast<double>(form.regime()) + form.encircledAxis() + form.separatrixDistance() + form.period() +
             form.timeToNextFlip(1) + form.timeToNextFlip(-1e300) + form.montgomeryAngle() + form.precessionRate() +
             form.moments().x();
      EXPECT_EQ(counter.count(), 0) << c.name << ": by-products";
    }
  }
}

TEST(Allocation, steppersAllocateNothing) {
  for (const Method& method : freeMethods()) {
    for (const Case& c : cases()) {
      const std::unique_ptr<Stepper> stepper = method.make(c.moments);
      RotationState state = RotationState::fromOmega(c.moments, Eigen::Quaterniond::Identity(), c.omega);
      const AllocationCounter counter;
      try {
        stepper->advance(state, 0, 0.01, 1000);
        stepper->advance(state, 0, -0.01, 1);
      } catch (const NoConvergence&) {
        EXPECT_GT(orbitRates(c.moments, c.omega).fastest() * 0.01, 0.5) << method.name << ", " << c.name;
        continue;  // the error has a text
      }
      sink = state.attitude.w();
      EXPECT_EQ(counter.count(), 0) << method.name << ", " << c.name;
    }
  }
}

TEST(Allocation, steppersUnderTorquesAllocateNothing) {
  for (const NamedEffects& one : eachEffect()) {
    for (const Method& method : torquedMethods()) {
      if (one.damped && !method.takes_damping) continue;
      const PrincipalInertia inertia = PrincipalInertia::fromMoments({1, 1.7, 2.1});
      const Torques torques = sumOf(inertia, one.effects);
      const std::unique_ptr<Stepper> stepper = method.make(torques);
      RotationState state =
          RotationState::fromOmega(inertia.moments(), Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5), {0.6, -0.5, 0.7});
      const AllocationCounter counter;
      for (int n = 0; n < 300; ++n) stepper->advanceFrom(state, 0.01 * n, 0.01);
      for (int n = 300; n > 0; --n) stepper->advanceFrom(state, 0.01 * n, -0.01);
      if (method.cuts_steps) stepper->advanceFrom(state, 0, 30);
      sink = state.attitude.w();
      EXPECT_EQ(counter.count(), 0) << one.name << ", " << method.name;
    }
  }
}

TEST(Allocation, theCounterCounts) {
  const auto expectCounted = [](const char* what, auto allocate) {
    const AllocationCounter counter;
    allocate();
    EXPECT_EQ(counter.count(), 1) << what;
  };
  void* volatile kept = nullptr;
  const auto freeKept = [&] { std::free(kept); };
  expectCounted("malloc", [&] { kept = std::malloc(10); });
  expectCounted("realloc", [&] { kept = std::realloc(kept, 100000); });
  freeKept();
  expectCounted("calloc", [&] { kept = std::calloc(3, 10); });
  freeKept();
  expectCounted("aligned_alloc", [&] { kept = std::aligned_alloc(64, 128); });
  freeKept();
  expectCounted("new", [&] { kept = ::operator new(10); });
  ::operator delete(kept);
  expectCounted("aligned new", [&] { kept = ::operator new(128, std::align_val_t(64)); });
  ::operator delete(kept, std::align_val_t(64));
  std::vector<double> numbers;
  expectCounted("std::vector", [&] { numbers.resize(100); });
  std::string text;
  expectCounted("std::string", [&] { text.assign(100, 'x'); });
  Eigen::VectorXd vector;
  expectCounted("Eigen", [&] { vector.resize(10); });
  expectCounted("sample into a table of its own", [] {
    const ClosedForm form({1, 2, 3}, Eigen::Quaterniond::Identity(), {0.1, 1, 0.1});
    sink = form.sample(0, 1, 10)(9, 0);
  });
  // Nothing outside the counter's life.
  kept = std::malloc(10);
  freeKept();
  const AllocationCounter counter;
  EXPECT_EQ(counter.count(), 0);
}

}  // namespace
}  // namespace poinsot
