#pragma once

#include <QComboBox>
#include <QString>
#include <QStringList>
#include <QVector>

/** Lists to choose from that say something about each choice. */
namespace poinsot::rviz_panel {

/** One line of a list. */
struct Choice {
  QString name;
  QString words;         ///< shown beside the name while the list is open; may be empty
  bool heading = false;  ///< a title of those below it, which cannot be chosen

  bool operator==(const Choice& other) const {
    return name == other.name && words == other.words && heading == other.heading;
  }
};
using Choices = QVector<Choice>;

/** Returns choices about which nothing is said. */
Choices plainChoices(const QStringList& names);

/** Lets a list show words and headings while it is open; closed, it shows the name that is chosen. */
void showWords(QComboBox* combo);

/** Shows these choices, the current one chosen, without a signal. Nothing happens while one of them is being picked. */
void showChoices(QComboBox* combo, const Choices& choices, const QString& current);

}  // namespace poinsot::rviz_panel
