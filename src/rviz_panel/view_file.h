#pragma once

#include <rviz/config.h>

#include <QString>
#include <optional>

namespace rviz {
class DisplayGroup;
}

/** The .rviz files of this package, of which another scene's views are taken. */
namespace poinsot::rviz_panel::view_file {

/** rviz/<scene>.rviz of this package; nothing where there is none, or where it has no views. */
std::optional<rviz::Config> read(const QString& scene);

/** What the file says of RViz's saved views. */
rviz::Config viewsOf(const rviz::Config& file);

/** What the file says of this panel; nothing where it has none. */
std::optional<rviz::Config> panelOf(const rviz::Config& file);

/** What is taken of a display in a file: whether it is shown, its hidden namespaces, its floor's place and size. */
rviz::Config takenOf(const rviz::Config& display);

/** Gives each display what is taken of the one of its name and kind in the file. */
void fitDisplays(const rviz::DisplayGroup& displays, const rviz::Config& file);

}  // namespace poinsot::rviz_panel::view_file
