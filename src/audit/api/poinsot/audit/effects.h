#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/** The effects on a body, read from the texts of its description: "type: key value, key value". */
namespace poinsot::audit {

struct Effects {
  /** A torque that is constant in body or world axes for from ≤ t < to [s]. */
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

  bool turns = false;               ///< whether any text names another effect than translation; else the body is free
  std::string problem;              ///< the first text that cannot be read, and why; empty where all can
  bool torques_are_read = true;     ///< whether the texts of all effects but translation can be read
  bool translation_is_read = true;  ///< whether that of the translation can be read, if there is one

  /** Returns whether all torques are constant in the world, piecewise in time; a slug may be inside. */
  bool momentumIsKnown() const;
  /** Returns what those add to L from one time to another [kg·m²/s], world axes. */
  Eigen::Vector3d impulse(double from, double to) const;
  /** Returns whether there is nothing but dampings and a slug, so that energy only falls. */
  bool onlyDissipates() const { return pushes.empty() && weights.empty() && orbits.empty(); }
  bool onlyWeights() const { return !weights.empty() && keepEnergy() && orbits.empty(); }
  bool onlyOrbit() const { return orbits.size() == 1 && keepEnergy() && weights.empty(); }
  /** Returns whether there is nothing but weights and orbits. */
  bool keepEnergy() const { return pushes.empty() && dampings.empty() && !slug; }
};

Effects readEffects(const std::vector<std::string>& texts);

}  // namespace poinsot::audit
