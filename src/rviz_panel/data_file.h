#pragma once

#include <rviz/config.h>

#include <QString>
#include <stdexcept>

/** The panel's own data: YAML files in the folder panel/ of this package. */
namespace poinsot::rviz_panel::data_file {

/** What is wrong in a data file; its text has the form "PLACE: expected X, got Y". */
class Error : public std::runtime_error {
 public:
  Error(const QString& place, const QString& expected, const QString& got)
      : std::runtime_error((place + ": expected " + expected + ", got " + got).toStdString()) {}
};

/** Returns the text of panel/NAME. Throws Error where there is no such file, or where it is larger than 64 kB. */
QString read(const QString& name);

/** Returns what the text says. Throws Error where it is no YAML, or no list of at most `most` entries. */
rviz::Config listFrom(const QString& text, const QString& place, int most);

/** Returns a text of 1 to `longest` letters. Throws Error where the map has none under this key. */
QString textOf(const rviz::Config& map, const QString& key, const QString& place, int longest);

}  // namespace poinsot::rviz_panel::data_file
