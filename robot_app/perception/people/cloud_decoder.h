// Clouds as messages, turned into points.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_CLOUD_DECODER_H_
#define COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_CLOUD_DECODER_H_

#include <sensor_msgs/PointCloud2.h>

#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/perception/clouds/range_image.h"

namespace coppice::robot::perception {

/// Fills `points` with those of the message, which may lie in any order. Needed are the fields x, y
/// and z (FLOAT32) and ring (a whole number without sign); intensity (FLOAT32 or UINT8) and time
/// (FLOAT32, finite) are 0 where they are missing. A message whose sizes do not agree, that lacks a
/// field or has it in another type is a problem; then there are no points. Never reads outside the
/// data.
Outcome Decode(const sensor_msgs::PointCloud2& message, std::vector<LidarPoint>& points);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_CLOUD_DECODER_H_
