#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/** What acts on a body, read from the texts of its description: "type: key value, key value". */
namespace poinsot::audit {

struct Effects {
  /** Constant in body or world axes for from ≤ t < to [s]. */
  struct Push {
    double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
    bool world = false;
    Eigen::Vector3d torque;  ///< [N·m]
  };
  struct Weight {
    double mass;                      ///< [kg]
    Eigen::Vector3d gravity, centre;  ///< world axes [m/s²]; body axes, from the pivot [m]
  };
  struct Orbit {
    double rate;                     ///< [rad/s]
    Eigen::Vector3d normal, radial;  ///< unit, world axes; radial at t = 0
    Eigen::Vector3d radialAt(double t) const;
  };
  struct Slug {
    double inertia, damping;  ///< [kg·m²], [N·m·s]
  };
  struct Translation {
    Eigen::Vector3d position, velocity, acceleration;  ///< world axes
  };

  std::vector<Push> pushes;
  std::vector<Weight> weights;
  std::vector<Orbit> orbits;
  std::vector<Eigen::Vector3d> dampings;  ///< along the body axes [N·m·s]
  std::optional<Slug> slug;
  std::optional<Translation> translation;

  bool turns = false;   ///< false where no text names anything but a translation: the body is free
  std::string problem;  ///< the first text that cannot be read, and why; empty where all can

  /** Nothing but torques that are constant in the world, now and then; a slug may be inside. */
  bool momentumIsKnown() const;
  /** What those add to L from one time to another [kg·m²/s]. */
  Eigen::Vector3d impulse(double from, double to) const;
  /** Nothing but dampings and a slug: energy only falls. */
  bool onlyDissipates() const { return pushes.empty() && weights.empty() && orbits.empty(); }
  bool onlyWeights() const { return !weights.empty() && keepEnergy() && orbits.empty(); }
  bool onlyOrbit() const { return orbits.size() == 1 && keepEnergy() && weights.empty(); }
  /** Nothing but weights and orbits. */
  bool keepEnergy() const { return pushes.empty() && dampings.empty() && !slug; }
};

Effects readEffects(const std::vector<std::string>& texts);

}  // namespace poinsot::audit
