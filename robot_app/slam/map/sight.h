// What the robot's sensors see at one instant, as the mapper takes it.
#ifndef COPPICE_ROBOT_APP_SLAM_MAP_SIGHT_H_
#define COPPICE_ROBOT_APP_SLAM_MAP_SIGHT_H_

#include <optional>
#include <vector>

#include "robot_app/common/picture.h"
#include "robot_app/common/pose2d.h"
#include "robot_app/slam/map/slam_map.h"
#include "robot_app/slam/pictures/features.h"

namespace coppice::robot::slam {

/// What a camera saw. Its points and its place on the robot are given in base_link as that was at
/// the instant of the sight, also if the picture was taken a little before or after.
struct SightPicture {
  PictureFeatures features;
  CameraMount camera;
  CameraCloud cloud;
};

/// Depth and colour are of one instant and size; another size of the depth means none.
SightPicture SeePicture(const Picture& colour, const DepthPicture& depth,
                        const CameraMount& camera);

struct Sight {
  double stamp = 0;
  Pose3 odometry = Pose3::Identity();
  std::vector<SightPicture> pictures;
  double brightness = 1;  ///< of the pictures, 0..1
  CloudPoints cloud;      ///< of the lidar, in base_link
  /// base_link in the frame of the map that the robot navigates on, if its localization is sure.
  std::optional<Pose2D> place;
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_MAP_SIGHT_H_
