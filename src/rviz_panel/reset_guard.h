#pragma once

#include <QObject>
#include <QSet>
#include <QTimer>

namespace rviz {
class VisualizationManager;
}

namespace poinsot::rviz_panel {

/**
 * Brings back what RViz's own Reset takes away for good: it drops all markers, and the node sends those that stand
 * still only to whoever subscribes anew. A display of markers that was filled and is all at once empty is switched off
 * and on.
 *
 * Reset also drops all meshes, but not their materials, and RViz 1.14 ends when it loads such a mesh again
 * (Ogre::ItemIdentityException). So materials of this package's meshes go here when their mesh has gone.
 */
class ResetGuard : public QObject {
  Q_OBJECT

 public:
  ResetGuard(rviz::VisualizationManager* manager, QObject* parent);

 private:
  void look();
  void removeStrayMaterials();
  void refillDisplays();

  rviz::VisualizationManager* const manager_;
  QSet<QString> filled_;  ///< displays, by name
  QTimer timer_;
};

}  // namespace poinsot::rviz_panel
