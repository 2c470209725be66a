#pragma once

#include <QElapsedTimer>
#include <QHash>
#include <QObject>

namespace rviz {
class VisualizationManager;
}

namespace poinsot::rviz_panel {

/**
 * Brings back what RViz's own Reset takes away for good: it drops all markers, and the node sends those that stand
 * still only to new subscribers. A display of markers that was filled and is suddenly empty is switched off and on, up
 * to five times.
 *
 * Reset also drops all meshes, but not their materials, and RViz 1.14 ends when it loads such a mesh again
 * (Ogre::ItemIdentityException). So materials of this package's meshes go here when their mesh has gone, before the
 * displays take what has arrived.
 */
class ResetGuard : public QObject {
 public:
  ResetGuard(rviz::VisualizationManager* manager, QObject* parent);

  /** Looks for displays that are to be filled again. To be called several times a second. */
  void refillDisplays();

 private:
  struct Refill {
    int tries = 0;
    QElapsedTimer since_last;
  };

  rviz::VisualizationManager* const manager_;
  QHash<QString, Refill> filled_;  ///< displays that have held markers since they were switched on, by name
};

}  // namespace poinsot::rviz_panel
