// What of a picture is recognized again: corners with a description of what is around each, and
// where each lies in space as far as the depth is known.
//
// E. Rublee, V. Rabaud, K. Konolige, G. Bradski: ORB: an efficient alternative to SIFT or SURF,
// ICCV 2011 (OpenCV's features2d).
//
// Points are in base_link: x forward, z up [m]. All is deterministic; any thread.
#ifndef COPPICE_ROBOT_APP_SLAM_PICTURES_FEATURES_H_
#define COPPICE_ROBOT_APP_SLAM_PICTURES_FEATURES_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "robot_app/common/picture.h"
#include "robot_app/slam/graph/pose_graph.h"

namespace coppice::robot::slam {

/// 256 comparisons of brightness.
using Descriptor = std::array<std::uint64_t, 4>;

/// In how many of the comparisons two differ, 0..256.
inline int Difference(const Descriptor& a, const Descriptor& b) {
  // Written out: the compiler leaves it a loop, which takes twice as long.
  return __builtin_popcountll(a[0] ^ b[0]) + __builtin_popcountll(a[1] ^ b[1]) +
         __builtin_popcountll(a[2] ^ b[2]) + __builtin_popcountll(a[3] ^ b[3]);
}

/// A camera on the robot.
struct CameraMount {
  Lens lens;
  Pose3 optical_in_base = Pose3::Identity();  ///< optical frame: z forward, x right, y down
};

/// A level camera at `height` above the floor, which looks along its yaw; see Mount.
CameraMount LevelCamera(const Lens& lens, double x, double y, double yaw, double height);

/// Of one picture; all of one length.
struct PictureFeatures {
  std::vector<Eigen::Vector2f> pixels;
  std::vector<Descriptor> descriptors;
  std::vector<Eigen::Vector3f> points;  ///< in base_link; NaN where no depth was measured

  std::size_t size() const { return pixels.size(); }
};

struct FeatureSettings {
  int most = 500;        ///< corners of a picture
  double max_depth = 6;  ///< depth farther away is not used [m]
};

/// Depth and colour are of one instant and size; another size of the depth means none.
PictureFeatures FindFeatures(const Picture& colour, const DepthPicture& depth,
                             const CameraMount& camera, const FeatureSettings& settings = {});

/// Mean brightness of a picture, 0..1.
double BrightnessOf(const Picture& colour);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_PICTURES_FEATURES_H_
