#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>

#include <string>
#include <vector>

#include "poinsot/BodyDescription.h"
#include "poinsot/BodyState.h"
#include "poinsot/ros/names.h"
#include "poinsot/session/moving_body.h"
#include "poinsot/view/picture_frame.h"

/** What is sent of a body, but for its markers. */
namespace poinsot::node {

/** The body in world, and its attitude in the picture in world axes. */
void appendTransforms(const session::MovingBody& body, const names::Frames& frames, const ros::Time& stamp,
                      std::vector<geometry_msgs::TransformStamped>& out);

/** Where its two pictures stand. */
void appendStaticTransforms(const names::Frames& frames, const view::Layout& layout, const ros::Time& stamp,
                            std::vector<geometry_msgs::TransformStamped>& out);

/** @param cost CPU seconds per simulated second; NaN where it is not measured. */
BodyState stateMessage(const session::MovingBody& body, const session::Tick& tick, double cost);

nav_msgs::Odometry odometryMessage(const session::MovingBody& body, const std::string& frame,
                                   const session::Tick& tick);

BodyDescription descriptionMessage(const session::MovingBody& body, const std::string& frame,
                                   const view::PictureScale& scale);

}  // namespace poinsot::node
