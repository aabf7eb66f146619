// A network that the user has, run by OpenCV: Darknet's YOLOv3, or ONNX files with a head of YOLOv5
// or YOLOv8. Its classes are known by their names: "person" or "pedestrian"; "face"; "mask" or
// "with_mask"; "no_mask" or "without_mask". All others are left out.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DETECTION_NETWORK_DETECTOR_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DETECTION_NETWORK_DETECTOR_H_

#include <memory>
#include <string>

#include "robot_app/perception/detection/detector.h"

namespace coppice::robot::perception {

/// Reads the network and runs it once. A file that is missing, damaged, of another kind or does not
/// fit to the others is a problem.
Expected<std::unique_ptr<Detector>> MakeNetworkDetector(const NetworkFiles& files,
                                                        double least_confidence);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DETECTION_NETWORK_DETECTOR_H_
