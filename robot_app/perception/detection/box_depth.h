// What the depth of a picture's pixels says about a box in it.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DETECTION_BOX_DEPTH_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DETECTION_BOX_DEPTH_H_

#include "robot_app/perception/detection/detector.h"

namespace coppice::robot::perception {

/// Whether there is depth, of as many pixels as there are colours.
bool HasDepth(const DetectorInput& input);

/// The middle one of the depths measured in the middle of a box [m]; 0: there is none.
double MedianDepth(const DepthPicture& depth, const Box& box);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DETECTION_BOX_DEPTH_H_
