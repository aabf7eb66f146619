#include "robot_app/slam/pictures/features.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

namespace coppice::robot::slam {
namespace {

constexpr double kContrast = 4;  // at most, of parts of a picture, after they were made even
constexpr int kFast = 12;        // steps of brightness that make a corner
constexpr int kSurround = 2;     // pixels around a corner in which its depth is looked for

// Even contrast: what is seen of a place shall depend little on how bright it is.
cv::Mat GrayOf(const Picture& colour) {
  const cv::Mat rgb(colour.height, colour.width, CV_8UC3,
                    const_cast<std::uint8_t*>(colour.rgb.data()));
  cv::Mat gray, smooth, even;
  cv::cvtColor(rgb, gray, cv::COLOR_RGB2GRAY);
  cv::GaussianBlur(gray, smooth, {5, 5}, 0);
  cv::createCLAHE(kContrast, {8, 6})->apply(smooth, even);
  return even;
}

// The nearest depth around a pixel: beside an edge the sensor measures none, and what is before the
// edge is what the corner belongs to. 0: none.
int DepthAround(const DepthPicture& depth, int column, int row) {
  int nearest = std::numeric_limits<int>::max();
  for (int y = std::max(row - kSurround, 0); y <= std::min(row + kSurround, depth.height - 1);
       ++y) {
    for (int x = std::max(column - kSurround, 0);
         x <= std::min(column + kSurround, depth.width - 1); ++x) {
      const int millimetres = depth.at(x, y);
      if (millimetres > 0) nearest = std::min(nearest, millimetres);
    }
  }
  return nearest == std::numeric_limits<int>::max() ? 0 : nearest;
}

Eigen::Vector3f PointAt(const cv::Point2f& pixel, const DepthPicture& depth,
                        const CameraMount& camera, double max_depth) {
  const double z = depth.width > 0 ? DepthAround(depth, static_cast<int>(pixel.x + 0.5F),
                                                 static_cast<int>(pixel.y + 0.5F)) *
                                         1e-3
                                   : 0;
  if (z <= 0 || z > max_depth) {
    return Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  }
  const Lens& lens = camera.lens;
  const Eigen::Vector3d optical((pixel.x - lens.cx) / lens.fx * z,
                                (pixel.y - lens.cy) / lens.fy * z, z);
  return (camera.optical_in_base * optical).cast<float>();
}

}  // namespace

CameraMount LevelCamera(const Lens& lens, double x, double y, double yaw, double height) {
  CameraMount camera{lens, Pose3::Identity()};
  const Eigen::Vector3d forward(std::cos(yaw), std::sin(yaw), 0);
  camera.optical_in_base.linear().col(0) = Eigen::Vector3d(forward.y(), -forward.x(), 0);
  camera.optical_in_base.linear().col(1) = -Eigen::Vector3d::UnitZ();
  camera.optical_in_base.linear().col(2) = forward;
  camera.optical_in_base.translation() = Eigen::Vector3d(x, y, height);
  return camera;
}

PictureFeatures FindFeatures(const Picture& colour, const DepthPicture& depth,
                             const CameraMount& camera, const FeatureSettings& settings) {
  PictureFeatures features;
  if (colour.width < 64 || colour.height < 64) return features;
  const auto orb =
      cv::ORB::create(settings.most, 1.2F, 8, 31, 0, 2, cv::ORB::HARRIS_SCORE, 31, kFast);
  std::vector<cv::KeyPoint> corners;
  cv::Mat rows;
  orb->detectAndCompute(GrayOf(colour), cv::noArray(), corners, rows);
  const DepthPicture none;
  const DepthPicture& measured = HaveOneSize(colour, depth) ? depth : none;
  for (int i = 0; i < rows.rows; ++i) {
    const cv::Point2f& pixel = corners[static_cast<std::size_t>(i)].pt;
    features.pixels.emplace_back(pixel.x, pixel.y);
    features.descriptors.emplace_back();
    std::memcpy(features.descriptors.back().data(), rows.ptr(i), sizeof(Descriptor));
    features.points.push_back(PointAt(pixel, measured, camera, settings.max_depth));
  }
  return features;
}

double BrightnessOf(const Picture& colour) {
  if (colour.rgb.empty()) return 0;
  const auto sum = std::accumulate(colour.rgb.begin(), colour.rgb.end(), std::uint64_t{0});
  return static_cast<double>(sum) / (255.0 * static_cast<double>(colour.rgb.size()));
}

}  // namespace coppice::robot::slam
