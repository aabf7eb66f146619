// Pictures for the manual: what is seen, drawn into the picture in which it is seen.
#ifndef COPPICE_TESTS_ROBOT_APP_PERCEPTION_DETECTION_DRAWN_SIGHTINGS_H_
#define COPPICE_TESTS_ROBOT_APP_PERCEPTION_DETECTION_DRAWN_SIGHTINGS_H_

#include <algorithm>
#include <cstdio>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "robot_app/common/picture.h"
#include "robot_app/perception/detection/box_depth.h"

namespace coppice::robot::perception {

/// Boxes, with what is in them and how far it is: people in blue, faces with mask in green, others
/// in red.
inline Picture Drawn(Picture picture, const DepthPicture& depth,
                     const std::vector<Sighting>& sightings) {
  cv::Mat pixels(picture.height, picture.width, CV_8UC3, picture.rgb.data());
  for (const Sighting& sighting : sightings) {
    const bool is_person = sighting.kind == SightingKind::kPerson;
    const bool has_mask = sighting.kind == SightingKind::kFaceWithMask;
    const cv::Scalar colour = is_person  ? cv::Scalar(30, 60, 220)
                              : has_mask ? cv::Scalar(20, 130, 40)
                                         : cv::Scalar(200, 30, 30);
    char text[48];
    std::snprintf(text, sizeof(text), "%s %.1f m",
                  is_person  ? "person"
                  : has_mask ? "mask"
                             : "no mask",
                  MedianDepth(depth, sighting.box));
    const cv::Rect box(cvRound(sighting.box.x), cvRound(sighting.box.y),
                       cvRound(sighting.box.width), cvRound(sighting.box.height));
    cv::rectangle(pixels, box, colour, 2);
    // A person's is below the feet, a face's above the head, so that they do not cover each other.
    const int line = is_person ? std::min(box.br().y + 14, picture.height - 4) : box.y - 5;
    const cv::Size size = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, 0.45, 1, nullptr);
    const cv::Point at(box.x + box.width / 2 - size.width / 2, line);
    cv::rectangle(pixels, {at.x - 2, at.y - size.height - 2, size.width + 4, size.height + 6},
                  cv::Scalar(255, 255, 255), cv::FILLED);
    cv::putText(pixels, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.45, colour, 1, cv::LINE_AA);
  }
  return picture;
}

}  // namespace coppice::robot::perception

#endif  // COPPICE_TESTS_ROBOT_APP_PERCEPTION_DETECTION_DRAWN_SIGHTINGS_H_
