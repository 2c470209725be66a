#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "poinsot/core/motion.h"
#include "poinsot/ros/markers/marker_tracker.h"
#include "poinsot/ros/names.h"
#include "poinsot/scene/scene.h"
#include "poinsot/session/tick.h"
#include "poinsot/view/picture_frame.h"

namespace poinsot::node {

namespace parts {
class Part;
struct Subject;
}  // namespace parts

/** Figures for a body's label: how it compares with the closed form, or, where there is none, its energy. */
struct Figures {
  double attitude_error;  ///< [rad]; NaN under torques
  double energy_drift;    ///< relative
  double cost;            ///< CPU s per simulated s; NaN: not measured, and not shown
  double kinetic_energy;  ///< [J]
};

/** What a picture needs to know of the scene around its body. */
struct SceneFacts {
  std::size_t bodies = 1;         ///< how many there are
  bool some_body_steps = false;   ///< then labels say how well, of all bodies
  std::optional<double> loop;     ///< after which time the scene begins again [s]
  bool light_background = false;  ///< of the viewers: letters are dark then
};

/**
 * One body's markers: the body itself, the two pictures of Poinsot's construction, and what shows its effects. A list
 * of parts, of which there are others for a body under torques than for a free one (body_picture.cpp).
 */
class BodyPicture {
 public:
  /** How much is computed beforehand. */
  enum class Detail {
    none,     ///< for no viewer: frame() is that of the start
    pictures  ///< how large the pictures of a body under torques will get as well (view/picture_bounds.h)
  };

  /**
   * @param keep draws it as large as another picture of the body, and turned alike; else it is laid out anew, and
   *        stands nowhere until place() is called.
   */
  BodyPicture(const scene::Body& body, const Motion& motion, const names::Frames& frames, Detail detail,
              const std::optional<view::PictureFrame>& keep = std::nullopt);
  ~BodyPicture();

  /** How the picture stands and how large it is. */
  const view::PictureFrame& frame() const;

  /** Whether there are pictures of Poinsot's construction. */
  bool hasPictures() const;

  /** What the layout of the scene needs to know. */
  view::BodyExtent extent(const SceneFacts& scene) const;

  /** Places it in a layout of the scene. */
  void place(const view::BodyPlace& place, const view::SceneLayout& layout, const SceneFacts& scene);

  /** Appends what never changes, with stamps 0, so that it is drawn whenever it arrives. */
  void appendStatic(visualization_msgs::MarkerArray& out) const;

  /** Appends a label below the body with its method and figures, four times a second; for scenes with steppers. */
  void appendFigures(const session::Tick& tick, const Figures& figures, visualization_msgs::MarkerArray& out);

  /** Appends what moves, at one tick. The trail begins anew with each segment. */
  void appendMoving(const session::Tick& tick, const Motion& motion, const MotionState& state,
                    visualization_msgs::MarkerArray& out);

  /** Turns the picture in body axes so that Ω is on the viewer's side at the start, where it is not. */
  void faceViewer();

  /** Radius of a ball about the body's origin that holds it [m]. */
  double reach() const;

  /** Forgets the trail. */
  void clearTrail();

  /** Has the next markers hold also what is sent only now and then. */
  void sendAllNext();

 private:
  void setUnits(Canvas& canvas) const;

  std::unique_ptr<parts::Subject> subject_;
  std::vector<std::unique_ptr<parts::Part>> parts_;
  mutable std::vector<visualization_msgs::Marker> still_;  ///< made when it is first asked for
  std::optional<std::uint32_t> segment_;                   ///< of the trail
  Canvas canvas_;                                          ///< of what moves
};

/** Places the pictures of a scene, and returns how. */
view::SceneLayout layOutScene(const std::vector<BodyPicture*>& pictures, SceneFacts scene);

}  // namespace poinsot::node
