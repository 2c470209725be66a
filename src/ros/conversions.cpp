#include "poinsot/ros/conversions.h"

#include <cstdint>
#include <stdexcept>

#include "poinsot/core/number_text.h"

namespace poinsot::node {

namespace {

template <class Message>
Message xyz(const Eigen::Vector3d& v) {
  Message out;
  out.x = v.x();
  out.y = v.y();
  out.z = v.z();
  return out;
}

}  // namespace

geometry_msgs::Point toPoint(const Eigen::Vector3d& v) {
  return xyz<geometry_msgs::Point>(v);
}

geometry_msgs::Vector3 toVector3(const Eigen::Vector3d& v) {
  return xyz<geometry_msgs::Vector3>(v);
}

geometry_msgs::Quaternion toQuaternion(const Eigen::Quaterniond& q) {
  geometry_msgs::Quaternion out;
  out.x = q.x();
  out.y = q.y();
  out.z = q.z();
  out.w = q.w();
  return out;
}

geometry_msgs::Transform toTransform(const Eigen::Vector3d& translation, const Eigen::Quaterniond& rotation) {
  geometry_msgs::Transform out;
  out.translation = toVector3(translation);
  out.rotation = toQuaternion(rotation);
  return out;
}

ros::Time toTime(session::Nanoseconds stamp) {
  return ros::Time().fromNSec(static_cast<std::uint64_t>(stamp));
}

session::Nanoseconds toNanoseconds(const ros::Time& stamp) {
  return static_cast<session::Nanoseconds>(stamp.toNSec());
}

YAML::Node toYaml(XmlRpc::XmlRpcValue& value, const std::string& place) {
  using XmlRpc::XmlRpcValue;
  YAML::Node node;
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      node = static_cast<bool>(value) ? "true" : "false";
      break;
    case XmlRpcValue::TypeInt:
      node = std::to_string(static_cast<int>(value));
      break;
    case XmlRpcValue::TypeDouble:
      node = numberText(static_cast<double>(value), 17);
      break;
    case XmlRpcValue::TypeString:
      node = static_cast<std::string>(value);
      node.SetTag("!");  // YAML's mark of a text that is no boolean, number or null
      break;
    case XmlRpcValue::TypeArray:
      node = YAML::Node(YAML::NodeType::Sequence);
      for (int i = 0; i < value.size(); ++i) node.push_back(toYaml(value[i], place + "[" + std::to_string(i) + "]"));
      break;
    case XmlRpcValue::TypeStruct:
      node = YAML::Node(YAML::NodeType::Map);
      for (auto& [key, member] : value) node[key] = toYaml(member, place + "." + key);
      break;
    default:
      throw std::invalid_argument(place + ": expected a boolean, number, text, list or map, got a date or binary data");
  }
  return node;
}

}  // namespace poinsot::node
