// A node for tests: publishes std_msgs/String on ~topic at ~rate (Hz of wall time).
#include <ros/ros.h>
#include <std_msgs/String.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "talker");
  ros::NodeHandle node;
  const ros::Publisher publisher =
      node.advertise<std_msgs::String>(ros::param::param<std::string>("~topic", "/talk"), 10);
  const ros::WallTimer timer = node.createWallTimer(
      ros::WallDuration(1.0 / ros::param::param("~rate", 10.0)),
      [&publisher](const ros::WallTimerEvent&) { publisher.publish(std_msgs::String()); });
  ros::spin();
}
