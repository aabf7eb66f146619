// A map in three dimensions of one or more sessions, as values: what each key frame saw, where it
// was, and what binds them.
#ifndef COPPICE_ROBOT_APP_SLAM_MAP_SLAM_MAP_H_
#define COPPICE_ROBOT_APP_SLAM_MAP_SLAM_MAP_H_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/common/pose2d.h"
#include "robot_app/slam/clouds/cloud_descriptor.h"
#include "robot_app/slam/graph/session_graph.h"
#include "robot_app/slam/pictures/features.h"

namespace coppice::robot::slam {

/// What a camera measured of the space before it, thinned: in base_link, in whole centimetres.
struct CameraCloud {
  Eigen::Vector3f camera = {0, 0, 0};  ///< where it is
  CloudPoints points;
};

/// What was seen from one place. Immutable, shared by who looks at it.
struct KeyFrame {
  double stamp = 0;  ///< [s]
  /// One for each camera that saw something.
  std::vector<std::shared_ptr<const PictureFeatures>> pictures;
  /// Of the lidar, thinned: in base_link, in whole centimetres.
  CloudPoints points;
  std::vector<CameraCloud> camera_clouds;  ///< where they are entered into the voxels
  CloudDescriptor descriptor;              ///< of all that the lidar saw
  double range = 8;                        ///< points up to here are entered into the voxels [m]
  /// base_link in the frame of the map that the robot navigates on, if its localization was sure.
  std::optional<Pose2D> place;
};

/// A session as people know it.
struct SessionName {
  std::string name;
  double begin = 0;  ///< stamp of its first key frame [s]
};

/// One point in each cube of `edge` [m], the first that was measured, in whole centimetres; up to
/// `range` [m] from the robot, and so far above and below it. `range` / `edge` is below 2^20.
CloudPoints Thinned(const CloudPoints& points, float edge, float range);

struct SlamMap {
  std::vector<std::shared_ptr<const KeyFrame>> key_frames;  ///< of each pose
  PoseGraph graph;
  std::vector<std::uint32_t> sessions;  ///< of each pose
  std::vector<SessionName> names;       ///< of each session
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_MAP_SLAM_MAP_H_
