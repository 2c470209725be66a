#include "viewpoint.h"

#include <OgreCamera.h>
#include <OgreQuaternion.h>
#include <OgreVector3.h>
#include <rviz/frame_manager.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>

#include "poinsot/ros/names.h"

namespace poinsot::rviz_panel {
namespace {

constexpr int kSendEvery = 100;  // ms

}  // namespace

Viewpoint::Viewpoint(rviz::VisualizationManager* manager, QObject* parent) : QObject(parent), manager_(manager) {
  connect(&timer_, &QTimer::timeout, this, &Viewpoint::look);
  timer_.start(kSendEvery);
}

void Viewpoint::repeat() {
  told_.reset();
}

void Viewpoint::look() {
  rviz::ViewController* const view = manager_->getViewManager()->getCurrent();
  if (!view || !view->getCamera()) return;
  Ogre::Vector3 eye = view->getCamera()->getDerivedPosition();  // in the fixed frame
  if (manager_->getFixedFrame() != node::names::kWorld) {
    Ogre::Vector3 origin;
    Ogre::Quaternion axes;
    if (!manager_->getFrameManager()->getTransform(node::names::kWorld, ros::Time(), origin, axes)) return;
    eye = axes.Inverse() * (eye - origin);
  }
  const std::array<double, 3> now = {eye.x, eye.y, eye.z};
  if (told_ == now) return;
  told_ = now;
  Q_EMIT moved(now[0], now[1], now[2]);
}

}  // namespace poinsot::rviz_panel
