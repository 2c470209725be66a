// The peer of the node: a program that broadcasts one moving frame, and nothing more.
// Parameter ~rate [Hz] (60).

#include <geometry_msgs/TransformStamped.h>
#include <ros/ros.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cmath>

int main(int argc, char** argv) {
  ros::init(argc, argv, "bare_tf_broadcaster");
  ros::NodeHandle handle;
  tf2_ros::TransformBroadcaster broadcaster;
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "world";
  transform.child_frame_id = "bare";
  ros::Rate rate(ros::NodeHandle("~").param("rate", 60.0));
  while (ros::ok()) {
    transform.header.stamp = ros::Time::now();
    const double angle = transform.header.stamp.toSec();
    transform.transform.rotation.z = std::sin(0.5 * angle);
    transform.transform.rotation.w = std::cos(0.5 * angle);
    broadcaster.sendTransform(transform);
    ros::spinOnce();
    rate.sleep();
  }
  return 0;
}
