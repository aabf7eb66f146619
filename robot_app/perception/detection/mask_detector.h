// Faces with and without mask, turned up to 60 degrees aside, by histograms of gradients and
// colours and linear classifiers. With the depth of the picture only places are looked at whose
// head would be of the right size, before something farther: that is faster, and takes no picture
// on a wall for a face.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DETECTION_MASK_DETECTOR_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DETECTION_MASK_DETECTOR_H_

#include <memory>

#include "robot_app/perception/detection/detector.h"
#include "robot_app/perception/detection/mask_classifier.h"

namespace coppice::robot::perception {

std::unique_ptr<Detector> MakeMaskDetector(MaskClassifier classifier);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DETECTION_MASK_DETECTOR_H_
