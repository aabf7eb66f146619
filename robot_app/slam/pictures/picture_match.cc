#include "robot_app/slam/pictures/picture_match.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "robot_app/slam/graph/planar_fit.h"
#include "robot_app/slam/pictures/corner_pairs.h"

namespace coppice::robot::slam {
namespace {

constexpr int kLeastPairs = 8;
constexpr int kDraws = 200;  // of RANSAC
constexpr double kCertain = 0.999;
constexpr int kRefined = 3;

// The old base_link as the new lens sees it.
struct Perspective {
  cv::Mat rotation, translation;
  std::vector<int> agree;
};

// Fits the pose to all that agree with it, and looks which agree then: a pose of four pairs that
// was drawn is a little off, and so are some of those that it is compared with.
void Refine(const std::vector<cv::Point3d>& points, const std::vector<cv::Point2d>& pixels,
            const cv::Mat& camera, double most_off, Perspective& found) {
  std::vector<cv::Point3d> best_points;
  std::vector<cv::Point2d> best_pixels, seen;
  for (const int i : found.agree) {
    best_points.push_back(points[static_cast<std::size_t>(i)]);
    best_pixels.push_back(pixels[static_cast<std::size_t>(i)]);
  }
  cv::solvePnPRefineLM(best_points, best_pixels, camera, cv::noArray(), found.rotation,
                       found.translation);
  cv::projectPoints(points, found.rotation, found.translation, camera, cv::noArray(), seen);
  std::vector<int> agree;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const cv::Point2d off = seen[i] - pixels[i];
    if (std::hypot(off.x, off.y) <= most_off) agree.push_back(static_cast<int>(i));
  }
  if (agree.size() >= found.agree.size()) found.agree = std::move(agree);
}

std::optional<Perspective> Solve(const std::vector<cv::Point3d>& points,
                                 const std::vector<cv::Point2d>& pixels, const Lens& lens,
                                 double most_off) {
  const cv::Mat camera =
      (cv::Mat_<double>(3, 3) << lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1);
  Perspective found;
  cv::theRNG().state = 1;  // the same pictures give the same pose
  if (!cv::solvePnPRansac(points, pixels, camera, cv::noArray(), found.rotation, found.translation,
                          false, kDraws, static_cast<float>(most_off), kCertain, found.agree,
                          cv::SOLVEPNP_AP3P) ||
      static_cast<int>(found.agree.size()) < kLeastPairs) {
    return std::nullopt;
  }
  for (int i = 0; i < kRefined; ++i) Refine(points, pixels, camera, most_off, found);
  return found;
}

Pose3 OldInLens(const Perspective& perspective) {
  cv::Mat matrix;
  cv::Rodrigues(perspective.rotation, matrix);
  Pose3 pose = Pose3::Identity();
  Eigen::Matrix3d rotation;
  cv::cv2eigen(matrix, rotation);
  pose.linear() = rotation;
  pose.translation() << perspective.translation.at<double>(0),
      perspective.translation.at<double>(1), perspective.translation.at<double>(2);
  return pose;
}

}  // namespace

std::optional<PictureMatch> MatchPictures(const PictureFeatures& old_picture,
                                          const PictureFeatures& new_picture,
                                          const CameraMount& new_camera,
                                          const MatchSettings& settings) {
  const std::vector<CornerPair> pairs = PairsOf(old_picture, new_picture);
  if (static_cast<int>(pairs.size()) < settings.least_inliers) return std::nullopt;
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> pixels;
  for (const CornerPair& pair : pairs) {
    const Eigen::Vector3f& point = old_picture.points[pair.old_corner];
    const Eigen::Vector2f& pixel = new_picture.pixels[pair.new_corner];
    points.emplace_back(point.x(), point.y(), point.z());
    pixels.emplace_back(pixel.x(), pixel.y());
  }
  const auto perspective = Solve(points, pixels, new_camera.lens, settings.pixels);
  if (!perspective) return std::nullopt;
  PictureMatch match;
  match.pairs = static_cast<int>(pairs.size());
  match.relative = (new_camera.optical_in_base * OldInLens(*perspective)).inverse();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double squares = 0;
  std::vector<Eigen::Vector3d> old_points, new_points;  // with depth in both
  for (const int i : perspective->agree) {
    const CornerPair& pair = pairs[static_cast<std::size_t>(i)];
    const Eigen::Vector3d expected =
        match.relative.inverse() * old_picture.points[pair.old_corner].cast<double>();
    const Eigen::Vector3f& seen = new_picture.points[pair.new_corner];
    const double distance = expected.norm();
    if (seen.allFinite() &&
        (seen.cast<double>() - expected).norm() > settings.depth * std::max(1.0, distance / 2)) {
      continue;
    }
    if (seen.allFinite()) {
      old_points.push_back(old_picture.points[pair.old_corner].cast<double>());
      new_points.push_back(seen.cast<double>());
    }
    ++match.inliers;
    mean += expected;
    squares += expected.squaredNorm();
  }
  mean /= std::max(match.inliers, 1);
  match.spread =
      std::sqrt(std::max(squares / std::max(match.inliers, 1) - mean.squaredNorm(), 0.0));
  if (static_cast<int>(old_points.size()) >= kLeastPairs) {
    const Pose3 by_depth = PlanarFit(old_points, new_points);
    match.contradiction = (by_depth.translation() - match.relative.translation()).norm();
  } else {
    match.contradiction = HUGE_VAL;
  }
  return match;
}

bool IsClear(const PictureMatch& match, const MatchSettings& settings) {
  return match.inliers >= 2 * settings.least_inliers && IsSure(match, settings);
}

bool IsSure(const PictureMatch& match, const MatchSettings& settings) {
  const double tilt = std::acos(std::clamp(match.relative.linear()(2, 2), -1.0, 1.0));
  return match.inliers >= settings.least_inliers &&
         match.inliers >= settings.least_share * match.pairs &&
         match.spread >= settings.least_spread &&
         match.contradiction <= settings.most_contradiction && tilt <= settings.most_tilt &&
         std::abs(match.relative.translation().z()) <= settings.most_rise &&
         match.relative.translation().norm() <= settings.most_way;
}

}  // namespace coppice::robot::slam
