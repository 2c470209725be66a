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

/** The messages about a body, apart from its markers. */
namespace poinsot::node {

/** Appends the transforms of the body in world, and of its attitude in the picture in world axes. */
void appendTransforms(const session::MovingBody& body, const names::Frames& frames, const ros::Time& stamp,
                      std::vector<geometry_msgs::TransformStamped>& out);

/** Appends the transforms of the body's two pictures. */
void appendStaticTransforms(const names::Frames& frames, const view::PictureFrame& frame, const ros::Time& stamp,
                            std::vector<geometry_msgs::TransformStamped>& out);

/** @param cost CPU seconds per simulated second; NaN where it is not measured. */
BodyState stateMessage(const session::MovingBody& body, const session::Tick& tick, double cost);

nav_msgs::Odometry odometryMessage(const session::MovingBody& body, const std::string& frame,
                                   const session::Tick& tick);

BodyDescription descriptionMessage(const session::MovingBody& body, const std::string& frame_id,
                                   const view::PictureFrame& frame);

}  // namespace poinsot::node
