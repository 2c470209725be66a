#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "contestant.h"

namespace poinsot::work_precision {

/** A run of an engine that has equal steps only. `World` has restart(), prepare(h), step() and answer(t). */
template <class World>
class EngineRun final : public Run {
 public:
  template <class... Arguments>
  explicit EngineRun(double step, Arguments&&... arguments)
      : world_(std::forward<Arguments>(arguments)...), step_(step) {}

  Answer shot(double horizon, const Watch& watch, Effort& effort) override {
    const std::int64_t steps = count(horizon);
    const double h = horizon / static_cast<double>(steps);
    world_.restart();
    world_.prepare(h);
    for (std::int64_t i = 1; i <= steps; ++i) {
      world_.step();
      if (watch) watch(world_.answer(static_cast<double>(i) * h));
    }
    effort.steps += steps;
    return world_.answer(horizon);
  }

  void ticks(double interval, std::int64_t count_of_ticks, Answer* out, Effort& effort) override {
    const std::int64_t steps = count(interval);
    world_.restart();
    world_.prepare(interval / static_cast<double>(steps));
    for (std::int64_t i = 1; i <= count_of_ticks; ++i) {
      for (std::int64_t k = 0; k < steps; ++k) world_.step();
      out[i - 1] = world_.answer(static_cast<double>(i) * interval);
    }
    effort.steps += steps * count_of_ticks;
  }

 private:
  std::int64_t count(double span) const { return static_cast<std::int64_t>(std::ceil(span / step_ * (1 - 1e-14))); }

  World world_;
  double step_;
};

/** The common part of the modes of one engine. */
class Engine : public Contestant {
 public:
  Engine(std::string name, std::string package, std::string version, std::string settings)
      : name_(std::move(name)),
        package_(std::move(package)),
        version_(std::move(version)),
        settings_(std::move(settings)) {}
  std::string name() const override { return name_; }
  std::string package() const override { return package_; }
  std::string version() const override { return version_; }
  std::string settings() const override { return settings_; }
  Knob knob() const override { return Knob::step; }

 private:
  std::string name_, package_, version_, settings_;
};

}  // namespace poinsot::work_precision
