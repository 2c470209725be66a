#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

#include "markers/marker_factory.h"
#include "poinsot/core/assembly.h"
#include "poinsot/core/motion.h"
#include "poinsot/ros/names.h"
#include "poinsot/scene/scene.h"
#include "poinsot/view/picture_frame.h"
#include "poinsot/view/polhode.h"

namespace poinsot::node::parts {

/** The pictures in world and in body axes hang the same things on different frames. */
struct Picture {
  const char* name;        ///< "space" or "model", in marker namespaces
  std::string body_frame;  ///< in which the ellipsoids are at rest, or only change their size
};

/** What is drawn: a body as all parts of its picture know it. */
struct Subject {
  /** All but the frame, of which the scale alone is set: that of the start, and what the body sweeps. */
  Subject(const scene::Body& body, const Motion& motion, const names::Frames& frames);

  std::array<Picture, 2> pictures() const {
    return {Picture{names::kSpace, factory.frames().space_body}, Picture{names::kModel, factory.frames().model}};
  }
  /** Whether there are pictures of Poinsot's construction: not of a free body at rest. */
  bool hasPictures() const { return wanted != scene::Pictures::none && (!start.omega_body.isZero(0) || !closed_form); }
  /** Whether it moves through the world. */
  bool flies() const {
    return translation && !(translation->velocity.isZero(0) && translation->acceleration.isZero(0));
  }
  /** Of a body on a pivot, the end of the line from there through its centre of mass, where the shape ends [m]. */
  Eigen::Vector3d farEnd(const MotionState& state) const {
    const Eigen::Vector3d& centre = weight->centre_of_mass;
    return state.position + state.attitude * (centre + shape_radius * centre.stableNormalized());
  }
  double radii() const { return frame.scale.metres_per_radian_per_second; }  ///< of the picture, per rad/s
  double unit() const { return frame.unit; }                                 ///< radius of the picture [m]
  /**
   * Returns a place in the world [m] below a title, by `depth` times the height of letters for a viewer at +x who looks
   * down a little; apart from the title also for one straight above.
   */
  Eigen::Vector3d belowTitle(const Eigen::Vector3d& centre, double title_depth, double depth) const;

  MarkerFactory factory;
  std::string name;
  PrincipalInertia inertia;
  MotionState start;
  Eigen::Vector3d omega_principal;         ///< at t = 0 [rad/s]
  view::Polhode polhode;                   ///< at t = 0
  std::optional<ClosedForm> closed_form;   ///< of a free body, whatever moves it
  std::optional<GravityTorque> weight;     ///< of a body on a pivot
  std::optional<Torques::Gradient> orbit;  ///< of a body under gravity gradient
  std::optional<Translation> translation;
  scene::Pictures wanted;                       ///< pictures that the scene asks for
  bool is_pushed;                               ///< effects turn the body as a whole
  bool keeps_momentum;                          ///< L is constant
  std::optional<Eigen::Vector3d> colour;        ///< of its solids
  std::optional<scene::Appearance> appearance;  ///< what is drawn instead of the shape
  Assembly shape;                               ///< a box where the scene gives none
  Eigen::Vector3d shape_position;               ///< of its centre of mass, body axes [m]
  double shape_radius;                          ///< of the shape about its centre of mass [m]
  double reach;                                 ///< of the shape from the body's origin [m]
  std::vector<view::Ball> swept;                ///< of a body on a pivot: what holds it in the first time [m]
  view::PictureFrame frame;
};

}  // namespace poinsot::node::parts
