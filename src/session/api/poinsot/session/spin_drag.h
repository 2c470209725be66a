#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "poinsot/core/inertia.h"
#include "poinsot/session/tick.h"
#include "poinsot/view/picture_frame.h"
#include "poinsot/view/spin_choices.h"

namespace poinsot::session {

/** What a hand did to the handle by which one takes hold of a body's spin. */
struct HandleEvent {
  enum class Kind {
    press,       ///< took hold
    lead,        ///< led the handle to `point`
    hold,        ///< still holds it
    let_go,      ///< released it
    keep,        ///< chose the ellipsoid on which Ω is led: `keep`
    axis,        ///< chose a spin exactly about `axis`
    near,        ///< chose a spin near `axis`
    separatrix,  ///< chose a spin on the separatrix
    reset
  };
  Kind kind = Kind::hold;
  std::string body;
  std::string frame;                                ///< in which `point` is
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< [m]; not checked: it comes from outside
  view::ConservedQuantity keep = view::ConservedQuantity::energy;
  view::Axis axis = view::Axis::smallest;
};

/** A spin that is to be led to another place on one of its ellipsoids. */
struct LedSpin {
  const PrincipalInertia& inertia;
  Eigen::Vector3d omega_body;  ///< present Ω [rad/s]
  const view::PictureFrame& frame;
  view::ConservedQuantity keep;  ///< the ellipsoid
};

/**
 * Returns the Ω [rad/s, body axes] to which a hand at `point` leads it; nothing for a point that is not finite or at
 * the centre.
 * @param point in the picture in body axes [m].
 * @param eye of the viewer [m, world axes]; where it is not known, Ω goes in the direction of the point.
 */
std::optional<Eigen::Vector3d> ledTo(const LedSpin& spin, const Eigen::Vector3d& point,
                                     const std::optional<Eigen::Vector3d>& eye);

/**
 * One hand on one body: free → pressed → led → let go → free.
 *
 * A hand that is let go before it has led anything changes nothing. Points are in the frame of the picture in body axes
 * [m]; times are of the wall's clock.
 */
class SpinDrag {
 public:
  enum class State {
    free,
    pressed,  ///< held where it was taken
    led,      ///< away from there
    let_go    ///< what was asked for is being worked out
  };

  State state() const { return state_; }
  bool isHeld() const { return state_ == State::pressed || state_ == State::led; }
  /** Of the body that is held or was let go. */
  const std::string& body() const { return body_; }
  bool isOn(const std::string& body) const { return state_ != State::free && body_ == body; }

  /**
   * @param omega_point where Ω is drawn now; radius: of the picture [m]; was_paused: what is to be brought back when it
   *        is over.
   */
  void press(const std::string& body, const Eigen::Vector3d& omega_point, double radius, bool was_paused,
             Nanoseconds now);

  /** The hand is still there. */
  void touch(Nanoseconds now) { touched_ = now; }

  /**
   * The hand is at a point: whether it has led Ω away from where it was taken.
   * @param omega_point where Ω is drawn now. The tick that stopped the body has moved it once more, so the hand may
   * have seen either place.
   */
  bool leads(const Eigen::Vector3d& point, const Eigen::Vector3d& omega_point);

  /** Where it was led to last [rad/s, body axes]. */
  void leadTo(const Eigen::Vector3d& omega_body) { omega_body_ = omega_body; }
  const Eigen::Vector3d& omegaBody() const { return omega_body_; }

  void letGo() { state_ = State::let_go; }
  void end() { state_ = State::free; }

  /** Whether the hand that holds it has not been heard of for 3 s. */
  bool isForgotten(Nanoseconds now) const;

  /** Whether play is paused when it is over. */
  bool wasPaused() const { return was_paused_; }
  void pauseAfterwards(bool paused) { was_paused_ = paused; }

 private:
  State state_ = State::free;
  std::string body_;
  bool was_paused_ = false;
  Eigen::Vector3d taken_at_ = Eigen::Vector3d::Zero();
  double click_ = 0;  ///< a hand that has moved less has not led anything [m]
  Eigen::Vector3d omega_body_ = Eigen::Vector3d::Zero();
  Nanoseconds touched_ = 0;
};

}  // namespace poinsot::session
