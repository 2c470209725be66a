#include "reset_guard.h"

#include <OgreMaterialManager.h>
#include <OgreMeshManager.h>
#include <rviz/visualization_manager.h>

#include <string>
#include <vector>

#include "displays.h"

namespace poinsot::rviz_panel {
namespace {

constexpr int kTryEvery = 1000;  // ms
constexpr int kMostTries = 5;
const char* const kOurs = "package://poinsot/";  // what the names of our meshes and their materials begin with

void removeStrayMaterials() {
  std::vector<Ogre::ResourceHandle> strays;
  auto all = Ogre::MaterialManager::getSingleton().getResourceIterator();
  while (all.hasMoreElements()) {
    const Ogre::ResourcePtr material = all.getNext();
    const std::string& name = material->getName();
    if (name.rfind(kOurs, 0) != 0) continue;
    const std::string mesh = name.substr(0, name.rfind("Material"));
    if (!Ogre::MeshManager::getSingleton().resourceExists(mesh)) strays.push_back(material->getHandle());
  }
  for (const Ogre::ResourceHandle stray : strays) Ogre::MaterialManager::getSingleton().remove(stray);
}

}  // namespace

ResetGuard::ResetGuard(rviz::VisualizationManager* manager, QObject* parent) : QObject(parent), manager_(manager) {
  connect(manager, &rviz::VisualizationManager::preUpdate, this, &removeStrayMaterials);
}

void ResetGuard::refillDisplays() {
  for (rviz::Display* const display : displaysOf(*manager_->getRootDisplayGroup())) {
    const QString name = display->getName();
    if (display->getClassId() != "rviz/MarkerArray" || !display->isEnabled()) {
      filled_.remove(name);
    } else if (display->subProp("Namespaces")->numChildren() > 0) {
      filled_[name].tries = 0;
    } else if (filled_.contains(name)) {
      Refill& refill = filled_[name];
      if (refill.tries == kMostTries || (refill.tries > 0 && !refill.since_last.hasExpired(kTryEvery))) continue;
      ++refill.tries;
      refill.since_last.start();
      display->setEnabled(false);
      display->setEnabled(true);
    }
  }
}

}  // namespace poinsot::rviz_panel
