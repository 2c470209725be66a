#pragma once

#include <poinsot/SceneLayout.h>
#include <rviz/config.h>

#include <QString>
#include <string>

/** The views that every scene has, as settings of RViz's cameras. */
namespace poinsot::rviz_panel::scene_views {

inline constexpr const char* kOverview = "Overview";
inline constexpr const char* kRiding = "Riding";
inline constexpr const char* kAlongL = "Along L";

/** Whether a layout can be shown: all of it finite, a length for each ball, and pictures that have a size. */
bool isUsable(const SceneLayout& layout);

/** Shows all that the layout names, in a picture whose width is `aspect` times its height. */
rviz::Config overviewOf(const SceneLayout& layout, double aspect);

/**
 * On the ellipsoids of the picture in world axes: body axes rest, and the world turns.
 * @param frame of the body.
 */
rviz::Config ridingOf(const SceneLayout& layout, const std::string& frame);

/** Looks at the picture in world axes; MomentumCamera turns it along L. @param frame of the body. */
rviz::Config alongOf(const SceneLayout& layout, const std::string& frame);

/**
 * What views leave out, as HiddenParts takes it: Riding and Along L leave out all but the picture in world axes of that
 * body.
 */
rviz::Config hiddenFor(const SceneLayout& layout, const std::string& body);

}  // namespace poinsot::rviz_panel::scene_views
