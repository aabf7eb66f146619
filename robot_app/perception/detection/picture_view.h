// Pictures for OpenCV.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DETECTION_PICTURE_VIEW_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DETECTION_PICTURE_VIEW_H_

#include <opencv2/imgproc.hpp>

#include "robot_app/common/picture.h"
#include "robot_app/perception/detection/sighting.h"

namespace coppice::robot::perception {

/// The same pixels, not a copy: for reading, as long as the picture lives.
inline cv::Mat View(const Picture& picture) {
  return {picture.height, picture.width, CV_8UC3, const_cast<std::uint8_t*>(picture.rgb.data())};
}

inline cv::Mat Gray(const Picture& picture) {
  cv::Mat gray;
  if (picture.width > 0 && picture.height > 0) {
    cv::cvtColor(View(picture), gray, cv::COLOR_RGB2GRAY);
  }
  return gray;
}

inline Box ToBox(const cv::Rect& rectangle) {
  return {double(rectangle.x), double(rectangle.y), double(rectangle.width),
          double(rectangle.height)};
}

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DETECTION_PICTURE_VIEW_H_
