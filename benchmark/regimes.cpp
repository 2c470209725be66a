#include "regimes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <utility>

namespace poinsot::benchmarks {
namespace {

constexpr int kStarts = 512;
constexpr int kTimes = 1024;

class Draws {
 public:
  double uniform(double low, double high) { return low + (high - low) * unit_(random_); }
  double sign() { return unit_(random_) < 0.5 ? -1 : 1; }

  /** A magnitude between two limits, uniform in its logarithm. */
  double magnitude(double least, double most) { return std::exp(uniform(std::log(least), std::log(most))); }

  Eigen::Quaterniond attitude() {
    return Eigen::Quaterniond(normal_(random_), normal_(random_), normal_(random_), normal_(random_)).normalized();
  }

  /** μ₁ < μ₂ < μ₃ of a real body, no two nearer than a tenth. */
  Eigen::Vector3d moments() {
    const double low = uniform(0.5, 1), middle = low * uniform(1.1, 1.5);
    return {low, middle, uniform(1.1 * middle, low + middle)};
  }

 private:
  std::mt19937_64 random_{1758};
  std::uniform_real_distribution<double> unit_{0, 1};
  std::normal_distribution<double> normal_{0, 1};
};

/** Ω₃/Ω₁ of the separatrix, for ascending moments. */
double separatrixSlope(const Eigen::Vector3d& m) {
  return std::sqrt(m[0] * (m[1] - m[0]) / (m[2] * (m[2] - m[1])));
}

/** Beside the separatrix, by a relative `distance` of Ω₃, on either side. */
Start nearSeparatrix(Draws& draws, double distance) {
  const Eigen::Vector3d m = draws.moments();
  const double first = draws.sign() * draws.uniform(0.1, 1);
  const double third = draws.sign() * first * separatrixSlope(m) * (1 + draws.sign() * distance);
  return {m, draws.attitude(), {first, draws.uniform(-1, 1), third}};
}

/** Far from the separatrix: Ω₃/Ω₁ is at least twice, or at most half, that of the separatrix. */
Eigen::Vector3d farFromSeparatrix(Draws& draws, const Eigen::Vector3d& m) {
  const double slope = separatrixSlope(m) * std::pow(draws.uniform(2, 10), draws.sign());
  const double first = draws.uniform(0.5, 1) / std::max(1.0, slope);
  return {draws.sign() * first, draws.sign() * draws.uniform(0, 0.5) * first, draws.sign() * slope * first};
}

Start general(Draws& draws) {
  const Eigen::Vector3d m = draws.moments();
  return {m, draws.attitude(), farFromSeparatrix(draws, m)};
}

/** Exactly on the separatrix, which with these moments is |Ω₁| = |Ω₃|. */
Start atSeparatrix(Draws& draws) {
  const double size = draws.uniform(0.1, 1), scale = draws.magnitude(0.1, 10);
  return {scale * Eigen::Vector3d(2, 5, 6),
          draws.attitude(),
          {draws.sign() * size, draws.uniform(-1, 1), draws.sign() * size}};
}

Start nearUnstableAxis(Draws& draws) {
  return {draws.moments(),
          draws.attitude(),
          {draws.sign() * 1e-140 * draws.uniform(0.1, 1), draws.sign(), draws.sign() * 1e-140 * draws.uniform(0.1, 1)}};
}

Start symmetric(Draws& draws) {
  const double pair = draws.uniform(0.6, 1), single = draws.sign() > 0 ? 0.5 * pair : 1.5 * pair;
  return {{pair, pair, single}, draws.attitude(), {draws.uniform(-1, 1), draws.uniform(-1, 1), draws.uniform(-1, 1)}};
}

/** A spin about a principal axis or, in one of four cases, of a sphere. */
Start steady(Draws& draws) {
  const int axis = static_cast<int>(draws.uniform(0, 4));
  if (axis == 3) return {{2, 2, 2}, draws.attitude(), {draws.uniform(-1, 1), draws.uniform(-1, 1), 1}};
  return {draws.moments(), draws.attitude(), draws.uniform(0.1, 1) * Eigen::Vector3d::Unit(axis)};
}

Start dzhanibekov(Draws& draws) {
  return {{1, 2, 3}, draws.attitude(), {0.01 * draws.uniform(0.5, 2), 1, 0.01 * draws.uniform(0.5, 2)}};
}

Start extremeRatio(Draws& draws) {
  const Eigen::Vector3d m(1, draws.magnitude(1e3, 1e9), 1e12);
  return {m, draws.attitude(), farFromSeparatrix(draws, m)};
}

Regime make(const std::string& name, const std::function<Start(Draws&)>& draw, double soonest, double latest) {
  Draws draws;
  Regime regime{name, {}, {}};
  for (int i = 0; i < kStarts; ++i) regime.starts.push_back(draw(draws));
  for (int i = 0; i < kTimes; ++i) regime.times.push_back(draws.sign() * draws.magnitude(soonest, latest));
  return regime;
}

}  // namespace

const std::vector<Regime>& regimes() {
  static const std::vector<Regime> all = {
      make("general", general, 1e-2, 1e6),
      make("symmetric", symmetric, 1e-2, 1e6),
      make("steady", steady, 1e-2, 1e6),
      make("extreme_ratio", extremeRatio, 1e-2, 1e6),
      make("far_time", general, 0.5e9, 2e9),
      make(
          "towards_separatrix", [](Draws& draws) { return nearSeparatrix(draws, 1e-2); }, 1e-2, 1e6),
      make(
          "near_separatrix", [](Draws& draws) { return nearSeparatrix(draws, 1e-8); }, 1e-2, 1e6),
      make("at_separatrix", atSeparatrix, 1e-2, 1e3),
      make("near_unstable_axis_1e-140", nearUnstableAxis, 1e-2, 1e6),
      make("dzhanibekov", dzhanibekov, 1e-2, 1e6),
  };
  return all;
}

const Regime& regime(const std::string& name) {
  for (const Regime& candidate : regimes()) {
    if (candidate.name == name) return candidate;
  }
  throw std::logic_error("no regime " + name);
}

}  // namespace poinsot::benchmarks
