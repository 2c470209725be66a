#pragma once

#include <QString>
#include <QStringList>
#include <QVector>

#include "choice_list.h"

namespace poinsot::rviz_panel {

/** One scene, with what is to be seen in it. */
struct SceneEntry {
  QString name;
  QString shows;
};

/** Scenes that help to understand the same thing. */
struct SceneGroup {
  QString title;
  QVector<SceneEntry> scenes;
};

/**
 * Returns the groups that a text like that of panel/scenes.yaml says, in its order.
 * Throws data_file::Error where it says something else, or names a scene twice.
 */
QVector<SceneGroup> sceneGroups(const QString& text);

/** Returns these scenes as lines of a list: group by group, then those that are in none. */
Choices groupedChoices(const QVector<SceneGroup>& groups, const QStringList& scenes);

}  // namespace poinsot::rviz_panel
