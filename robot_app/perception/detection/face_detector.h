// Faces from the front by a cascade of simple features (Viola and Jones, CVPR 2001; weights by
// R. Lienhart), as Debian's package opencv-data has them. It hardly finds faces with masks.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DETECTION_FACE_DETECTOR_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DETECTION_FACE_DETECTOR_H_

#include <memory>
#include <string>

#include "robot_app/perception/detection/detector.h"

namespace coppice::robot::perception {

inline constexpr char kFaceCascade[] =
    "/usr/share/opencv4/haarcascades/haarcascade_frontalface_alt2.xml";

/// A file that is missing or no cascade is a problem.
Expected<std::unique_ptr<Detector>> MakeFaceDetector(const std::string& file = kFaceCascade);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DETECTION_FACE_DETECTOR_H_
