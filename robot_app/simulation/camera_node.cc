#include "robot_app/simulation/camera_node.h"

#include <sensor_msgs/CompressedImage.h>

#include "robot_app/simulation/jpeg.h"

namespace coppice::robot::simulation {

CameraNode::CameraNode(ros::NodeHandle& node) {
  const auto add = [&](const std::string& name, const Pose2& mounting) {
    CameraOptions options;
    options.mounting = mounting;
    const std::string topic = "/camera/" + name + "/image/compressed";
    cameras_.push_back(
        {"camera_" + name, options, node.advertise<sensor_msgs::CompressedImage>(topic, 1)});
  };
  add("front", {0.2, 0, 0});
  add("rear", {-0.2, 0, kPi});
}

void CameraNode::Publish(const World& world, const ros::Time& stamp) {
  if (world.time() < next_) return;
  next_ = world.time() + kPeriod;
  for (const Camera& camera : cameras_) {
    if (camera.publisher.getNumSubscribers() == 0) continue;
    sensor_msgs::CompressedImage message;
    message.header.stamp = stamp;
    message.header.frame_id = camera.frame;
    message.format = "jpeg";
    message.data = EncodeJpeg(RenderPicture(world, camera.options));
    camera.publisher.publish(message);
  }
}

}  // namespace coppice::robot::simulation
