#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <optional>
#include <string>

#include "poinsot/core/motion.h"
#include "poinsot/ros/names.h"
#include "poinsot/ros/simulation_clock.h"
#include "poinsot/scene/scene.h"
#include "poinsot/view/layout.h"
#include "poinsot/view/picture_scale.h"
#include "poinsot/view/polhode.h"
#include "poinsot/view/trail.h"

namespace poinsot::node {

/** Begins an array that may meet markers of an earlier scene in a viewer. */
visualization_msgs::MarkerArray clearedMarkers();

/** One body's markers: the body itself and the two pictures of Poinsot's construction. */
class BodyPicture {
 public:
  /** @param motion a copy of that body's. */
  BodyPicture(const scene::Body& body, Motion motion, const names::Frames& frames);

  const view::Layout& layout() const { return layout_; }
  const view::PictureScale& scale() const { return scale_; }

  /** What never changes; stamps 0, so that it is drawn whenever it arrives. */
  void appendStatic(visualization_msgs::MarkerArray& out) const;

  /** What a label says of a body that is compared with the truth. */
  struct Figures {
    double attitude_error;  ///< [rad]
    double energy_drift;    ///< relative
    double cost;            ///< CPU s per simulated s; NaN: not measured, and not shown
  };

  /** A label below the body, with its method, from now on a few times a second: in scenes where some body steps. */
  void appendFigures(const Tick& tick, const Figures& figures, visualization_msgs::MarkerArray& out);

  /** What moves, at one tick. */
  void appendMoving(const Tick& tick, const MotionState& state, visualization_msgs::MarkerArray& out);

  /** Forgets the trail: nobody looked, or the motion jumped. */
  void clearTrail() { trail_.clear(); }

 private:
  /** The pictures in world and in body axes hang the same things on different frames. */
  struct Picture {
    const char* name;        ///< "space" or "model", in marker namespaces
    std::string body_frame;  ///< in which the ellipsoids are at rest
  };

  bool atRest() const { return start_.omega_body.isZero(0); }

  visualization_msgs::Marker marker(const std::string& ns, int id, int type, const std::string& frame) const;
  visualization_msgs::Marker text(int id, const std::string& frame, const Eigen::Vector3d& place,
                                  const std::string& words, double height) const;
  visualization_msgs::Marker arrow(const std::string& ns, const std::string& frame, const Eigen::Vector3d& tip) const;

  void appendEllipsoids(const Picture& picture, visualization_msgs::MarkerArray& out) const;
  void appendCurves(const Picture& picture, visualization_msgs::MarkerArray& out) const;
  void appendTitles(visualization_msgs::MarkerArray& out) const;
  void appendMomentum(const ros::Time& stamp, const Eigen::Vector3d& momentum_world,
                      visualization_msgs::MarkerArray& out) const;

  std::string name_;
  names::Frames frames_;
  MotionState start_;
  PrincipalInertia inertia_;
  Assembly shape_;
  std::string method_;  ///< with its step
  std::optional<ros::Time> figures_shown_;
  bool momentum_is_constant_;        ///< by the method's promise, so that L need not be sent again
  Eigen::Vector3d omega_principal_;  ///< at t = 0 [rad/s]
  view::Polhode polhode_;
  view::Layout layout_;
  view::PictureScale scale_;
  view::Trail trail_;
  bool trail_shown_ = false;  ///< in a viewer, by what was sent
};

}  // namespace poinsot::node
