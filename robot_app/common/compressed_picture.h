// Pictures as they travel: colour as JPEG (libjpeg-turbo), depth as PNG of 16 bits (libpng) behind
// the twelve bytes that ROS's compressed_depth_image_transport puts before it. What is read may
// come from anybody: a broken or too large picture is a problem, never more.
//
// All functions are pure; any thread.
#ifndef COPPICE_ROBOT_APP_COMMON_COMPRESSED_PICTURE_H_
#define COPPICE_ROBOT_APP_COMMON_COMPRESSED_PICTURE_H_

#include <cstdint>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/common/picture.h"

namespace coppice::robot {

/// What the field `format` of sensor_msgs/CompressedImage says.
inline constexpr char kJpegFormat[] = "rgb8; jpeg compressed bgr8";
inline constexpr char kDepthFormat[] = "16UC1; compressedDepth png";

/// A picture with more is not read.
inline constexpr int kMostPixels = 4096 * 4096;

/// `quality` 1..100. Empty for a picture without pixels.
std::vector<std::uint8_t> EncodeJpeg(const Picture& picture, int quality = 80);
Expected<Picture> DecodeJpeg(const std::vector<std::uint8_t>& bytes);

/// Empty for a picture without pixels.
std::vector<std::uint8_t> EncodeDepth(const DepthPicture& picture);
Expected<DepthPicture> DecodeDepth(const std::vector<std::uint8_t>& bytes);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_COMPRESSED_PICTURE_H_
