#pragma once

#include <XmlRpcValue.h>
#include <geometry_msgs/Point.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Vector3.h>
#include <ros/time.h>
#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

#include "poinsot/session/tick.h"

/** Between the project's types and ROS's, all in one place. */
namespace poinsot::node {

geometry_msgs::Point toPoint(const Eigen::Vector3d& v);
geometry_msgs::Vector3 toVector3(const Eigen::Vector3d& v);
geometry_msgs::Quaternion toQuaternion(const Eigen::Quaterniond& q);
geometry_msgs::Transform toTransform(const Eigen::Vector3d& translation, const Eigen::Quaterniond& rotation);

/** A stamp that is not negative. */
ros::Time toTime(session::Nanoseconds stamp);
session::Nanoseconds toNanoseconds(const ros::Time& stamp);

/**
 * A parameter tree as the YAML that it was loaded from. Numbers keep all their digits.
 * Throws std::invalid_argument for values that YAML scenes do not have (dates, binary data), naming the place.
 */
YAML::Node toYaml(XmlRpc::XmlRpcValue& value, const std::string& place);

}  // namespace poinsot::node
