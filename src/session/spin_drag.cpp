#include "poinsot/session/spin_drag.h"

#include "poinsot/view/grasp.h"

namespace poinsot::session {
namespace {

constexpr double kClick = 0.005;                 // radii of a picture: a hand that moves less has not led anything
constexpr Nanoseconds kForgotten = 3 * kSecond;  // a viewer that died lets go

}  // namespace

std::optional<Eigen::Vector3d> ledTo(const LedSpin& spin, const Eigen::Vector3d& point,
                                     const std::optional<Eigen::Vector3d>& eye) {
  const double metres = view::scaleInMetres(spin.frame).metres_per_radian_per_second;
  const PrincipalInertia& inertia = spin.inertia;
  const Eigen::Vector3d semi_axes =
      metres * view::keptSemiAxes(inertia.moments(), inertia.toPrincipal(spin.omega_body), spin.keep);
  const Eigen::Vector3d principal = inertia.toPrincipal(point);
  std::optional<Eigen::Vector3d> place;
  if (eye) {
    const Eigen::Vector3d from = spin.frame.model_orientation.conjugate() * (*eye - spin.frame.place.model_centre);
    place = view::pointInSight(semi_axes, inertia.toPrincipal(from), principal);
  } else {
    place = view::pointTowards(semi_axes, principal);
  }
  if (!place) return std::nullopt;
  return Eigen::Vector3d(inertia.toBody(*place) / metres);
}

void SpinDrag::press(const std::string& body, const Eigen::Vector3d& omega_point, double radius, bool was_paused,
                     Nanoseconds now) {
  state_ = State::pressed;
  body_ = body;
  taken_at_ = omega_point;
  click_ = kClick * radius;
  was_paused_ = was_paused;
  touched_ = now;
}

bool SpinDrag::leads(const Eigen::Vector3d& point, const Eigen::Vector3d& omega_point) {
  const auto isNear = [&](const Eigen::Vector3d& seen) { return (point - seen).stableNorm() < click_; };
  if (state_ == State::pressed && !isNear(taken_at_) && !isNear(omega_point)) state_ = State::led;
  return state_ == State::led;
}

bool SpinDrag::isForgotten(Nanoseconds now) const {
  return isHeld() && now - touched_ > kForgotten;
}

}  // namespace poinsot::session
