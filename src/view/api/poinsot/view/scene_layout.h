#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "poinsot/view/camera.h"

namespace poinsot::view {

/** What the layout needs to know of a body. Lengths in metres, world axes. */
struct BodyExtent {
  std::vector<Ball> body;    ///< what holds the body, at the times that are to be in view; first at the start
  double radius = 0;         ///< of the body about its origin
  bool has_words = true;     ///< a title, at least
  bool shows_world = true;   ///< the picture in world axes stands beside it; else apart, outside of an overview
  bool shows_body = true;    ///< likewise that in body axes
  bool shows_orbit = false;  ///< a picture of its orbit stands beside it
  /** Direction of L, a unit vector, where it is constant: its arrow reaches out of the picture only there. */
  std::optional<Eigen::Vector3d> momentum;
  double picture_depth = 1.4;  ///< of the pictures' titles below their centres [radii of a picture], at least
  int lines = 0;               ///< of text below its title, at most
  int letters = 0;             ///< of its name
};

/** The titles of a body's pictures. */
enum class PictureTitles {
  plain,  ///< they say in which axes
  named,  ///< and of which body: the pictures stand away from it
  none    ///< the title of the body is that of its picture, which stands below it
};

/** Where the pictures of a body stand, and its words. World axes [m]. */
struct BodyPlace {
  Eigen::Vector3d space_centre = Eigen::Vector3d::Zero();  ///< of the picture in world axes
  Eigen::Vector3d model_centre = Eigen::Vector3d::Zero();  ///< of the picture in body axes
  Eigen::Vector3d orbit_centre = Eigen::Vector3d::Zero();  ///< of the picture of the orbit, where there is one
  Eigen::Vector3d title = Eigen::Vector3d::Zero();         ///< the middle of the body's title
  double picture_title_depth = 0;                          ///< of the pictures' titles below their centres
  PictureTitles titles = PictureTitles::plain;
  bool shows_world = true, shows_body = true;  ///< as in BodyExtent
};

/** Where all pictures of a scene stand. */
struct SceneLayout {
  double unit = 1;   ///< radius of every picture, and the unit of what is drawn around it [m]
  double text = 1;   ///< heights of letters, relative to those for a single body
  double pitch = 0;  ///< of the camera for the overview [rad]; it stands at +x
  std::vector<BodyPlace> bodies;
  std::vector<Ball> overview;  ///< what an overview is to show: bodies, pictures beside them, words
};

/**
 * Returns a layout for a viewer at +x, in which no picture meets a body, or another picture: to the right of its body,
 * or below it, where all of them have room there; else, and in scenes of more than 300 bodies, all pictures together,
 * to the right of the bodies or below them. Of these, it is the one that a camera with a usual aspect sees from
 * nearest.
 *
 * Pictures are as large as the largest body. Letters grow with the scene, so that they can be read in the overview.
 */
SceneLayout sceneLayoutOf(const std::vector<BodyExtent>& bodies);

}  // namespace poinsot::view
