// The simulated cameras on ROS: /camera/{front,rear}/image/compressed (sensor_msgs/CompressedImage,
// JPEG) five times in a second of simulated time, and only while somebody watches.
#ifndef COPPICE_ROBOT_APP_SIMULATION_CAMERA_NODE_H_
#define COPPICE_ROBOT_APP_SIMULATION_CAMERA_NODE_H_

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "robot_app/simulation/camera.h"

namespace coppice::robot::simulation {

class CameraNode {
 public:
  static constexpr double kPeriod = 0.2;  ///< [s]

  explicit CameraNode(ros::NodeHandle& node);

  /// Call it after each step of the world.
  void Publish(const World& world, const ros::Time& stamp);

 private:
  struct Camera {
    std::string frame;
    CameraOptions options;
    ros::Publisher publisher;
  };
  std::vector<Camera> cameras_;
  double next_ = 0;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_CAMERA_NODE_H_
