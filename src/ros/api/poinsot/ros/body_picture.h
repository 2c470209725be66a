#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/core/motion.h"
#include "poinsot/ros/effect_markers.h"
#include "poinsot/ros/marker_factory.h"
#include "poinsot/ros/marker_tracker.h"
#include "poinsot/ros/names.h"
#include "poinsot/scene/scene.h"
#include "poinsot/session/tick.h"
#include "poinsot/view/path.h"
#include "poinsot/view/picture_frame.h"
#include "poinsot/view/polhode.h"
#include "poinsot/view/trail.h"

namespace poinsot::node {

/**
 * One body's markers: the body itself, the two pictures of Poinsot's construction, and what shows its effects.
 *
 * E and MΩ of a free body are constant, and so are its ellipsoids and curves. Under torques they are those of the
 * moment, and move.
 */
class BodyPicture {
 public:
  /** How much is worked out beforehand. */
  enum class Detail {
    none,     ///< nobody will look: frame() is that of the start
    pictures  ///< how large the pictures of a body under torques will get as well (view/picture_bounds.h)
  };

  /** @param keep draws it as large as another picture of the body, and turned alike; else it is laid out anew. */
  BodyPicture(const scene::Body& body, const Motion& motion, const names::Frames& frames, Detail detail,
              const std::optional<view::PictureFrame>& keep = std::nullopt);

  /** How it stands and how large it is. */
  const view::PictureFrame& frame() const { return frame_; }

  /** What never changes; stamps 0, so that it is drawn whenever it arrives. */
  void appendStatic(visualization_msgs::MarkerArray& out) const;

  /** What a label says of a body: one under torques of its energy, another of how it compares with the truth. */
  struct Figures {
    double attitude_error;  ///< [rad]
    double energy_drift;    ///< relative
    double cost;            ///< CPU s per simulated s; NaN: not measured, and not shown
    double kinetic_energy;  ///< [J]
  };

  /** A label below the body, with its method, from now on a few times a second: in scenes where some body steps. */
  void appendFigures(const session::Tick& tick, const Figures& figures, visualization_msgs::MarkerArray& out);

  /** What moves, at one tick. The trail begins anew with each segment. */
  void appendMoving(const session::Tick& tick, const Motion& motion, const MotionState& state,
                    visualization_msgs::MarkerArray& out);

  /** Forgets the trail: nobody looked. */
  void clearTrail();

  /** The next markers hold also what is sent only now and then. */
  void sendAllNext() {
    for (auto* shown : {&figures_shown_, &flips_told_, &curves_shown_, &path_shown_}) {
      if (*shown) *shown = 0;
    }
  }

 private:
  visualization_msgs::MarkerArray makeStatic() const;

  /** The pictures in world and in body axes hang the same things on different frames. */
  struct Picture {
    const char* name;        ///< "space" or "model", in marker namespaces
    std::string body_frame;  ///< in which the ellipsoids are at rest, or only change their size
  };
  std::array<Picture, 2> pictures() const {
    return {Picture{names::kSpace, factory_.frames().space_body}, Picture{names::kModel, factory_.frames().model}};
  }

  bool atRest() const { return !torqued_ && start_.omega_body.isZero(0); }

  void appendEllipsoids(const Picture& picture, double kinetic_energy, double momentum_squared,
                        visualization_msgs::MarkerArray& out) const;
  void appendCurves(const Picture& picture, const view::Polhode& polhode, const std::vector<view::Curve>& separatrix,
                    visualization_msgs::MarkerArray& out) const;
  double titleDepth(double body_radius) const;  ///< for a body within that radius of its origin [m]
  /** By `depth` [m] for a viewer at +x who looks down a little; apart from the title also for one straight above. */
  Eigen::Vector3d belowTitle(const Eigen::Vector3d& centre, double depth) const;
  void appendTitles(visualization_msgs::MarkerArray& out) const;
  std::array<visualization_msgs::Marker, 2> momentumMarkers(const Eigen::Vector3d& momentum_world,
                                                            const Eigen::Vector3d& torque_world) const;
  void appendOmega(const MotionState& state, visualization_msgs::MarkerArray& out) const;
  void appendFlips(const session::Tick& tick, const Motion& motion, double time, visualization_msgs::MarkerArray& out);
  void appendTrail(const Eigen::Vector3d& place, visualization_msgs::MarkerArray& out);
  void appendMovingConstruction(const session::Tick& tick, const MotionState& state,
                                const Eigen::Vector3d& torque_world, visualization_msgs::MarkerArray& out);
  void appendPath(const session::Tick& tick, const Eigen::Vector3d& omega_metres, visualization_msgs::MarkerArray& out);

  MarkerFactory factory_;
  std::string name_;
  MotionState start_;
  PrincipalInertia inertia_;
  std::optional<scene::Appearance> appearance_;  ///< what is drawn instead of the shape
  Assembly shape_;
  Eigen::Vector3d shape_position_;  ///< of its centre of mass, body axes [m]
  std::string method_;              ///< with its step
  std::optional<session::Nanoseconds> figures_shown_, flips_told_;
  std::string flips_;     ///< in words, when they were told last
  double direction_ = 1;  ///< of play, when it was not paused
  bool torqued_;
  std::optional<ClosedForm> closed_form_;  ///< of a free body, whatever moves it
  bool may_flip_;                          ///< a free body that turns over
  bool momentum_is_constant_;              ///< by the method's promise, so that L need not be sent again
  Eigen::Vector3d omega_principal_;        ///< at t = 0 [rad/s]
  view::Polhode polhode_;                  ///< at t = 0
  view::PictureFrame frame_;
  mutable visualization_msgs::MarkerArray still_;  ///< made when it is first asked for
  view::Trail trail_;
  std::optional<std::uint32_t> segment_;  ///< of the trail
  MarkerTracker tracker_;

  // Of a body under torques.
  std::optional<EffectMarkers> effects_;
  view::Path path_;
  bool path_rides_ = false;   ///< on the present momentum ellipsoid: it grows and shrinks with it
  double path_size_ = 1;      ///< at which all of it was last drawn
  bool path_jumped_ = false;  ///< what was shown of it is no more
  std::optional<session::Nanoseconds> path_shown_, curves_shown_;
  std::size_t path_turn_ = 0;                                 ///< the piece that was sent once more
  double curves_energy_size_ = 0, curves_momentum_size_ = 0;  ///< √E and |MΩ| when the curves were sent
};

}  // namespace poinsot::node
