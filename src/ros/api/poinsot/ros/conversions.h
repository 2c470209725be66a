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

/** Conversions between the project's types and ROS's. */
namespace poinsot::node {

geometry_msgs::Point toPoint(const Eigen::Vector3d& v);
geometry_msgs::Vector3 toVector3(const Eigen::Vector3d& v);
geometry_msgs::Quaternion toQuaternion(const Eigen::Quaterniond& q);
geometry_msgs::Transform toTransform(const Eigen::Vector3d& translation, const Eigen::Quaterniond& rotation);

/** @param stamp not negative. */
ros::Time toTime(session::Nanoseconds stamp);
session::Nanoseconds toNanoseconds(const ros::Time& stamp);

/**
 * Returns a parameter tree as the YAML that it was loaded from. Numbers keep all their digits.
 * Throws std::invalid_argument, with the place, for values that scenes do not have (dates, binary data).
 */
YAML::Node toYaml(XmlRpc::XmlRpcValue& value, const std::string& place);

}  // namespace poinsot::node
