#include "hard_cases.h"

#include <cmath>

namespace poinsot {
namespace {

// Under the address sanitizer a step takes some twenty times as long.
#ifdef __SANITIZE_ADDRESS__
constexpr std::int64_t kShare = 20;
#else
constexpr std::int64_t kShare = 1;
#endif
constexpr std::int64_t kSteps = 20000 / kShare, kMany = 300000 / kShare;

std::vector<HardCase> makeCases() {
  const double ulp = std::ldexp(1, -52), beside = std::nextafter(1.0, 2.0);
  const Eigen::Vector3d fast = 1e4 * Eigen::Vector3d(0.6, 0.5, 0.7).normalized();
  std::vector<HardCase> cases = {
      {"separatrix", "Ω never comes back", {4, 5, 9}, {3, -1, 1}, 0.01, kSteps},
      {"separatrix + 1 ulp", "the last bit of Ω decides the axis", {4, 5, 9}, {3, -1, beside}, 0.01, kSteps},
      {"unstable axis + 1e-8", "a flip every 21 turns", {1, 2, 3}, {1e-8, 1, 1e-8}, 0.02, kSteps},
      {"unstable axis + 1e-140", "squares underflow", {1, 2, 3}, {1e-140, 1, 1e-140}, 0.02, kSteps},
      {"unstable axis", "steady, but the least disturbance grows", {1, 2, 3}, {0, 1, 0}, 0.02, kSteps},
      {"stable axis", "Λ × Ω = 0", {1, 2, 3}, {0, 0, 1}, 0.02, kSteps},
      {"rod", "two equal moments, large", {1, 2, 2}, {0.6, 0.5, 0.7}, 0.02, kSteps},
      {"disc", "two equal moments, small", {1, 1, 2}, {0.6, 0.5, 0.7}, 0.02, kSteps},
      {"sphere", "no preferred axis", {2, 2, 2}, {0.6, 0.5, 0.7}, 0.02, kSteps},
      {"1 + 2⁻⁵²", "moments that differ by one bit", {1, 1 + ulp, 1 + 2 * ulp}, {0.6, 0.5, 0.7}, 0.02, kSteps},
      {"needle 1e-12", "ratio 1e12, tiny moment", {1e-12, 1, 1}, {0.3, 0.5, 0.7}, 0.02, kSteps},
      {"long rod 1e6", "Λ₁ is a millionth of Λ", {1, 1e6, 1e6 + 0.5}, {0.6, 0.5, 0.7}, 0.02, kSteps},
      {"1e12, wobbling", "no real body; Ω₂ reaches 4e5 rad/s", {1e12, 1, 3}, {0.3, 0.5, 0.7}, 0.02, kSteps},
      {"1e12, short step", "the same, followed", {1e12, 1, 3}, {0.3, 0.5, 0.7}, 2e-14, kSteps},
      {"no real body", "wobble 99 times as fast as the spin", {1, 1, 100}, {1e-6, 0, 1}, 0.03, kSteps},
      {"1e4 rad/s at 60 Hz", "27 turns a step", {1, 2, 3}, fast, 1.0 / 60, kSteps},
      {"1e4 rad/s at 60 Hz, steady", "27 turns a step, one axis", {1, 2, 3}, {0, 0, 1e4}, 1.0 / 60, kSteps},
      {"Ωh = 4", "just over half a turn a step", {1, 2, 3}, 4e-4 * fast, 1, kSteps},
      {"Ωh = 100", "16 turns a step", {1, 2, 3}, 1e-2 * fast, 1, kSteps},
      {"Ωh = 1e6", "160 000 turns a step", {1, 2, 3}, 1e2 * fast, 1, kSteps},
      {"Ω 1e-200", "squares underflow; hardly moves", {1, 2, 3}, 1e-204 * fast, 0.02, kSteps},
      {"Ω 1e-200, step 1e198", "squares underflow; turns", {1, 2, 3}, 1e-204 * fast, 2e198, kSteps},
      {"Ω 1e-300", "near the smallest normal number", {1, 2, 3}, 1e-304 * fast, 2e298, kSteps},
      {"Ω 1e-310", "denormal: 14 digits are left", {1, 2, 3}, 1e-304 * (1e-10 * fast), 2e306, 80},
      {"Ω 1e150, step 1e-152", "fourth powers overflow", {1, 2, 3}, 1e146 * fast, 2e-152, kSteps},
      {"Ω 1e150, step 1", "1e149 turns a step", {1, 2, 3}, 1e146 * fast, 1, 16},
      {"rest", "0/0 everywhere", {1, 2, 3}, {0, 0, 0}, 0.02, kSteps},
      {"moments 1e-30", "Λ is tiny", {1e-30, 2e-30, 3e-30}, {0.6, 0.5, 0.7}, 0.02, kSteps},
      {"moments 1e30", "Λ is huge", {1e30, 2e30, 3e30}, {0.6, 0.5, 0.7}, 0.02, kSteps},
      {"moments 1e-300", "inverses near the largest number", {1e-300, 2e-300, 3e-300}, {0.6, 0.5, 0.7}, 0.02, kSteps},
      {"backwards", "negative step", {1, 2, 3}, {0.6, 0.5, 0.7}, -0.02, kSteps},
      {"step 1e-300", "no step moves anything", {1, 2, 3}, {0.6, 0.5, 0.7}, 1e-300, kSteps},
      {"step 1e300", "1e299 turns a step", {1, 2, 3}, {0.6, 0.5, 0.7}, 1e300, 16},
      {"many steps", "roundoff adds up", {1, 2, 3}, {0.6, 0.5, 0.7}, 0.02, kMany},
      {"many steps of a disc", "the same rounding at every step", {1, 1, 3}, {0.6, 0.5, 0.7}, 0.05, kMany},
  };
  return cases;
}

}  // namespace

const std::vector<HardCase>& hardCases() {
  static const std::vector<HardCase> cases = makeCases();
  return cases;
}

std::vector<HardCase> longRuns() {
  return {{"tumbling", "", {1, 2, 3}, {0.6, 0.5, 0.7}, 0.02, 100000000},
          {"disc", "the same rounding at every step", {1, 1, 3}, {0.6, 0.5, 0.7}, 0.05, 100000000}};
}

}  // namespace poinsot
