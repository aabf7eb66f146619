// Where on the floor somebody stands who is seen in a picture: in the direction of the box, as far
// as the median of what was measured inside it says (Stuede et al., ECMR 2021, section II-C1).
//
// Frames: the optical one of the camera (x right, y down, z forward) and one on the floor that does
// not move with the robot. Metres.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_SIGHTINGS_PLACE_H_
#define COPPICE_ROBOT_APP_PERCEPTION_SIGHTINGS_PLACE_H_

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "robot_app/common/picture.h"
#include "robot_app/perception/detection/sighting.h"

namespace coppice::robot::perception {

enum class RangedBy : std::uint8_t { kNothing = 0, kLidar = 1, kDepth = 2 };

struct Place {
  Eigen::Vector2d position{0, 0};  ///< of the body's axis
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();
  RangedBy by = RangedBy::kNothing;
};

/// What was measured when the picture was taken.
struct Ranges {
  Lens lens;
  DepthPicture depth;                  ///< aligned to the picture; may be empty
  std::vector<Eigen::Vector3f> lidar;  ///< in the optical frame; may be empty
  Eigen::Isometry3d optical_in_frame{Eigen::Isometry3d::Identity()};
};

/// Depth beyond it is too noisy to count; the lidar is for what is farther.
inline constexpr double kFarthestDepth = 5;

/// Looked at is the middle part of the box, where mostly the person is. Of lidar and depth that one
/// decides which has more valid points there; nothing if neither has enough.
std::optional<Place> PlaceOf(const Sighting& sighting, const Ranges& ranges);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_SIGHTINGS_PLACE_H_
