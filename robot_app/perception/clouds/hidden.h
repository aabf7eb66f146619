// Whether somebody at a place could be seen at all.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_HIDDEN_H_
#define COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_HIDDEN_H_

#include "robot_app/perception/clouds/range_image.h"

namespace coppice::robot::perception {

/// True if most rays that would meet a body whose axis stands at `place` (from the sensor's foot)
/// end before it, or if the place is too near to be measured.
bool IsHidden(const RangeImage& image, const Eigen::Vector2f& place);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_HIDDEN_H_
