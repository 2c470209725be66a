#pragma once

#include <poinsot/BodyDescription.h>
#include <poinsot/BodyState.h>
#include <rviz/config.h>
#include <rviz/view_controller.h>
#include <Eigen/Core>

#include <QPointer>
#include <QString>
#include <optional>

namespace rviz {
class ViewManager;
}

namespace poinsot::rviz_panel {

/** How RViz's orbiting camera stands. */
struct OrbitAngles {
  double yaw = 0;    ///< [rad]
  double pitch = 0;  ///< [rad]; positive from above
};

/**
 * Where a camera stands that looks along L (world axes) towards its foot: at the tip. Where L is nearly vertical it
 * looks down or up with no yaw, so that it is not turned round for nothing.
 */
OrbitAngles anglesAlong(const Eigen::Vector3d& momentum);

/** Whether the motion of a body begins anew in a later state, with L in another direction. */
bool beginsAlongAnotherMomentum(const BodyState& before, const BodyState& now);

/**
 * Keeps the camera of some views on the present L. The panel's `Down L` in a .rviz file says which views those are, and
 * of which body: such a view looks along L when it is chosen and when the motion of that body begins anew with another
 * L, if the panel follows that body. Else it looks as it was saved.
 */
class MomentumCamera {
 public:
  explicit MomentumCamera(rviz::ViewManager* views) : views_(views) {}

  void load(const rviz::Config& panel) { bodies_ = panel.mapGetChild("Down L"); }
  /** Has a view look along the L of a body. */
  void follow(const QString& view, const QString& body);
  void save(rviz::Config panel) const;

  /** The view that has been chosen; RViz's present camera is its own. Any other camera is left as it is. */
  void take(const QString& view);
  /** Looks along L, if the view that has been chosen does. */
  void look();

  // Of the body that the panel follows.
  void showState(const BodyState& state);
  void showDescription(const BodyDescription& description) { description_ = description; }

 private:
  rviz::ViewManager* const views_;
  rviz::Config bodies_;  ///< by view
  QString view_;
  QPointer<rviz::ViewController> camera_;  ///< of the chosen view, for as long as it is the one in use
  std::optional<BodyState> state_;
  BodyDescription description_;
};

}  // namespace poinsot::rviz_panel
