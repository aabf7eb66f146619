#include "robot_app/slam/straightened_cloud.h"

#include <cmath>

#include "robot_app/slam/graph/floor_pose.h"

namespace coppice::robot::slam {
namespace {

// Between two instants the robot has turned by less than the lidar tells apart.
constexpr double kInstant = 0.001;  // s

}  // namespace

CloudPoints Straightened(const std::vector<perception::LidarPoint>& points, const Pose3& lidar,
                         double stamp, const localization::PoseHistory& odometry) {
  const auto first = odometry.At(stamp);
  CloudPoints cloud;
  cloud.reserve(points.size());
  double instant = 0;
  Eigen::Isometry3f place = lidar.cast<float>();  // of the lidar at that instant
  for (const perception::LidarPoint& point : points) {
    const Eigen::Vector3f seen(point.x, point.y, point.z);
    if (!seen.allFinite()) continue;
    if (first && std::abs(point.time - instant) >= kInstant) {
      instant = point.time;
      const auto then = odometry.At(stamp + instant);
      const Pose3 moved = then ? ToPose3(RelativeTo(*first, *then)) : Pose3::Identity();
      place = (moved * lidar).cast<float>();
    }
    cloud.push_back(place * seen);
  }
  return cloud;
}

}  // namespace coppice::robot::slam
