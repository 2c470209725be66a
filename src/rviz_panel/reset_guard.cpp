#include "reset_guard.h"

#include <OgreMaterialManager.h>
#include <OgreMeshManager.h>
#include <rviz/display.h>
#include <rviz/display_group.h>
#include <rviz/visualization_manager.h>

#include <string>
#include <vector>

#include "widgets.h"

namespace poinsot::rviz_panel {
namespace {

constexpr int kLookEvery = 200;                  // ms
const char* const kOurs = "package://poinsot/";  // what the names of our meshes and their materials begin with

}  // namespace

ResetGuard::ResetGuard(rviz::VisualizationManager* manager, QObject* parent) : QObject(parent), manager_(manager) {
  connect(&timer_, &QTimer::timeout, this, &ResetGuard::look);
  timer_.start(kLookEvery);
}

void ResetGuard::look() {
  removeStrayMaterials();
  refillDisplays();
}

void ResetGuard::removeStrayMaterials() {
  std::vector<Ogre::ResourceHandle> strays;
  auto all = Ogre::MaterialManager::getSingleton().getResourceIterator();
  while (all.hasMoreElements()) {
    const Ogre::ResourcePtr material = all.getNext();
    const std::string& name = material->getName();
    if (name.compare(0, std::string(kOurs).size(), kOurs) != 0) continue;
    const std::string mesh = name.substr(0, name.rfind("Material"));
    if (!Ogre::MeshManager::getSingleton().resourceExists(mesh)) strays.push_back(material->getHandle());
  }
  for (const Ogre::ResourceHandle stray : strays) Ogre::MaterialManager::getSingleton().remove(stray);
}

void ResetGuard::refillDisplays() {
  rviz::DisplayGroup* const displays = manager_->getRootDisplayGroup();
  QSet<QString> filled;
  for (int i = 0; i < displays->numDisplays(); ++i) {
    rviz::Display* const display = displays->getDisplayAt(i);
    if (display->getClassId() != "rviz/MarkerArray" || !display->isEnabled()) continue;
    if (display->subProp("Namespaces")->numChildren() > 0) {
      filled.insert(display->getName());
    } else if (filled_.contains(display->getName())) {
      settleProperties();
      display->setEnabled(false);
      display->setEnabled(true);
    }
  }
  filled_ = filled;
}

}  // namespace poinsot::rviz_panel
