// Whole people by histograms of oriented gradients (Dalal and Triggs, CVPR 2005), with the weights
// that OpenCV has built in: no file is needed. With depth, what is too small or too tall for a
// person is left out.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DETECTION_PEOPLE_DETECTOR_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DETECTION_PEOPLE_DETECTOR_H_

#include <memory>

#include "robot_app/perception/detection/detector.h"

namespace coppice::robot::perception {

std::unique_ptr<Detector> MakePeopleDetector();

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DETECTION_PEOPLE_DETECTOR_H_
