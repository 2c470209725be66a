#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/core/assembly.h"
#include "poinsot/core/closed_form.h"
#include "poinsot/core/effect.h"
#include "poinsot/core/effects/translation.h"
#include "poinsot/core/inertia.h"

namespace poinsot::scene {

/** How exact a body's motion must be; a scene may give this instead of a method and a step. */
struct Accuracy {
  double error;                         ///< of the attitude, at most [rad]
  double horizon;                       ///< for 0 ≤ t ≤ horizon [s]
  std::vector<std::string> candidates;  ///< methods to choose from, at least one
  bool by_default = false;  ///< the scene gives none; where it is out of reach, the best that is within reach will do
  std::string place;        ///< what a message about it begins with
};

/** A mesh that is drawn in place of the body's solids; nothing is computed with it. */
struct Appearance {
  std::string mesh;                                    ///< package://… or file:///…, COLLADA or STL
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();     ///< the mesh's lengths → metres, along its own axes
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of its origin from the body's, body axes [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< its axes → body axes, unit
  std::string place;                                                ///< what a message about the mesh begins with
};

/** Which pictures of Poinsot's construction an overview shows beside a body. */
enum class Pictures {
  as_it_suits,  ///< depends on the scene: doc/scene_file.md
  both,
  world,  ///< that in world axes; the other stands apart
  body,   ///< that in body axes; the other stands apart
  apart,  ///< both stand apart, outside of an overview
  none    ///< none is drawn, and no words
};

/** One body of a scene, validated. All vectors refer to the axes in which the inertia is given. */
struct Body {
  std::string name;  ///< a valid ROS name without slashes; no other frame of the scene has it
  PrincipalInertia inertia = PrincipalInertia::fromMoments({1, 1, 1});
  std::optional<Assembly> shape;                                 ///< where the scene gives one instead of the inertia
  Eigen::Vector3d shape_position = Eigen::Vector3d::Zero();      ///< its centre of mass, from a pivot, body axes [m]
  std::optional<Appearance> appearance;                          ///< where a mesh is drawn in place of its shape
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< at t = 0, body → world, unit
  Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();          ///< at t = 0 [rad/s], body axes
  std::string method = kClosedForm;
  std::optional<double> step;        ///< [s]; every method but the closed form has one
  std::optional<Accuracy> accuracy;  ///< then method and step are still to be chosen (cost/resolve_accuracy.h)
  std::optional<Translation> translation;
  Pictures pictures = Pictures::as_it_suits;
  std::optional<Eigen::Vector3d> colour;  ///< red, green, blue of its solids, 0 to 1
  std::vector<Effect> effects;            ///< what turns it
};

/** What a scene draws besides its bodies, world axes [m]: a line through points, or words at one. */
struct Drawing {
  std::vector<Eigen::Vector3d> points;    ///< one of words, at least two of a line
  std::string words;                      ///< empty for a line
  std::optional<Eigen::Vector3d> colour;  ///< red, green, blue, 0 to 1
};

struct Scene {
  std::optional<double> rate;  ///< [Hz]
  std::optional<double> loop;  ///< after this time t begins at 0 again [s]
  std::vector<Body> bodies;    ///< at least one
  std::vector<Drawing> drawings;
  std::vector<std::string> warnings;
};

constexpr double kDefaultRate = 60;  // Hz

/** Returns how many letters the words have: of several bytes in UTF-8, one begins a letter. */
std::size_t lettersOf(const std::string& words);

}  // namespace poinsot::scene
