// The part of a picture in which a face is looked for, and the numbers that describe it.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DETECTION_FACE_WINDOW_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DETECTION_FACE_WINDOW_H_

#include <opencv2/objdetect.hpp>
#include <vector>

#include "robot_app/perception/detection/sighting.h"

namespace coppice::robot::perception {

/// The window of pixels that describes a face, which is in its middle: with hair and neck.
inline const cv::Size kFaceWindow(40, 48);
inline constexpr double kFaceWide = 25;  ///< of the face in the window [pixels]
inline constexpr double kFaceTall = 29;

/// Histograms of oriented gradients for it (Dalal and Triggs, CVPR 2005).
cv::HOGDescriptor FaceHistograms();

/// Numbers of a face: its histograms, and after them the colours of ten by twelve cells.
inline constexpr int kFaceShapes = 4 * 5 * 4 * 9;
inline constexpr int kFaceFeatures = kFaceShapes + 10 * 12 * 3;

/// Of the face in `box` (of any size) of a colour picture; what is beyond the picture is as its
/// rim.
std::vector<float> DescribeFace(const cv::Mat& picture, const Box& box);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DETECTION_FACE_WINDOW_H_
