// A depth picture as a lidar would have measured it that stands where the camera stands: so that
// people are found in it in the same way, from any side and without feet or face.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_SIGHTINGS_DEPTH_TURN_H_
#define COPPICE_ROBOT_APP_PERCEPTION_SIGHTINGS_DEPTH_TURN_H_

#include <vector>

#include "robot_app/common/picture.h"
#include "robot_app/perception/clouds/range_image.h"

namespace coppice::robot::perception {

/// Fills `points`, in a frame at the lens with x forward, y left, z up, with one for each ring and
/// column of the geometry that the picture shows, and whose depth is known and at most `farthest`
/// metres. The camera must look level. The intensity is that of clothes.
void TurnOf(const DepthPicture& depth, const Lens& lens, const LidarGeometry& geometry,
            double farthest, std::vector<LidarPoint>& points);

/// To either side of straight ahead the whole of that direction is in the picture [rad].
double HalfAngle(const Lens& lens, int width);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_SIGHTINGS_DEPTH_TURN_H_
