#include "momentum_camera.h"

#include <rviz/view_manager.h>
#include <algorithm>
#include <cmath>

namespace poinsot::rviz_panel {
namespace {

constexpr double kUpright = 0.12;         // rad: an L so near the vertical counts as vertical
constexpr double kSameWay = 0.005;        // rad
constexpr double kBeginning = 0.2;        // s
constexpr double kLeastMomentum = 0.005;  // m: an arrow that is drawn shorter has no direction

Eigen::Vector3d momentumOf(const BodyState& state) {
  return {state.momentum_world.x, state.momentum_world.y, state.momentum_world.z};
}

}  // namespace

OrbitAngles anglesAlong(const Eigen::Vector3d& momentum) {
  const Eigen::Vector3d l = momentum.stableNormalized();
  if (std::hypot(l.x(), l.y()) < kUpright) return {0, std::copysign(M_PI_2, l.z())};
  return {std::atan2(l.y(), l.x()), std::asin(std::clamp(l.z(), -1.0, 1.0))};
}

bool beginsAlongAnotherMomentum(const BodyState& before, const BodyState& now) {
  if (before.body != now.body) return true;
  // A seek begins a segment as well, and under torques L is another one there.
  const bool begins =
      before.segment != now.segment && (!std::isnan(now.attitude_error) || std::abs(now.time) < kBeginning);
  return begins && (momentumOf(now).stableNormalized() - momentumOf(before).stableNormalized()).norm() > kSameWay;
}

void MomentumCamera::save(rviz::Config panel) const {
  if (bodies_.isValid()) panel.mapMakeChild("Down L").copy(bodies_);
}

void MomentumCamera::follow(const QString& view, const QString& body) {
  bodies_.mapSetValue(view, body);
}

void MomentumCamera::take(const QString& view) {
  view_ = view;
  camera_ = views_->getCurrent();
}

void MomentumCamera::showState(const BodyState& state) {
  const bool turned = !state_ || beginsAlongAnotherMomentum(*state_, state);
  state_ = state;
  if (turned) look();
}

void MomentumCamera::look() {
  QString body;
  if (!state_ || !bodies_.mapGetString(view_, &body) || body.toStdString() != state_->body) return;
  rviz::ViewController* const camera = views_->getCurrent();
  if (!camera || camera != camera_ || camera->getClassId() != "rviz/Orbit") return;
  const Eigen::Vector3d momentum = momentumOf(*state_);
  const double drawn = description_.body == state_->body ? description_.metres_per_angular_momentum : 1;
  if (drawn * momentum.stableNorm() < kLeastMomentum || momentum.isZero(0)) return;
  const OrbitAngles angles = anglesAlong(momentum);
  camera->subProp("Pitch")->setValue(static_cast<float>(angles.pitch));
  camera->subProp("Yaw")->setValue(static_cast<float>(angles.yaw));
}

}  // namespace poinsot::rviz_panel
