#include "eye.h"

#include <OgreCamera.h>
#include <OgreQuaternion.h>
#include <OgreVector3.h>
#include <rviz/frame_manager.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>

#include "poinsot/ros/names.h"

namespace poinsot::rviz_panel {

std::optional<std::array<double, 3>> eyeInWorld(rviz::VisualizationManager& manager) {
  const rviz::ViewController* const view = manager.getViewManager()->getCurrent();
  if (!view || !view->getCamera()) return std::nullopt;
  Ogre::Vector3 eye = view->getCamera()->getDerivedPosition();  // in the fixed frame
  if (manager.getFixedFrame() != node::names::kWorld) {
    Ogre::Vector3 origin;
    Ogre::Quaternion axes;
    if (!manager.getFrameManager()->getTransform(node::names::kWorld, ros::Time(), origin, axes)) return std::nullopt;
    eye = axes.Inverse() * (eye - origin);
  }
  return {{eye.x, eye.y, eye.z}};
}

}  // namespace poinsot::rviz_panel
