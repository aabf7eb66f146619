#include "robot_app/perception/drawing/floor_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace coppice::robot::perception {
namespace {

constexpr double kBody = 0.25;     // m
constexpr double kRobot = 0.33;    // m
constexpr double kCircles = 2;     // between two [m]
constexpr double kFarthest = 1e4;  // pixels: what is drawn lies within
constexpr double kLetters = 0.5;
const cv::Scalar kBlack(30, 30, 30);
const cv::Scalar kPale(225, 225, 225);

cv::Mat PixelsOf(Picture& picture) {
  return {picture.height, picture.width, CV_8UC3, picture.rgb.data()};
}

cv::Scalar ToScalar(const Colour& colour) {
  return {double(colour[0]), double(colour[1]), double(colour[2])};
}

}  // namespace

Colour ColourOf(std::uint32_t number) {
  static constexpr std::array<Colour, 10> kColours = {{{31, 119, 180},
                                                       {214, 39, 40},
                                                       {44, 160, 44},
                                                       {255, 127, 14},
                                                       {148, 103, 189},
                                                       {140, 86, 75},
                                                       {227, 119, 194},
                                                       {23, 160, 175},
                                                       {160, 160, 20},
                                                       {90, 60, 160}}};
  return kColours[number % kColours.size()];
}

FloorPicture::FloorPicture(const Eigen::Vector2d& middle, double reach, int pixels)
    : middle_(middle), pixels_per_metre_(pixels / (2 * reach)), picture_(pixels, pixels) {
  std::fill(picture_.rgb.begin(), picture_.rgb.end(), std::uint8_t{255});
  const Pixel centre = At(middle);
  for (double radius = kCircles; radius < 1.5 * reach; radius += kCircles) {
    cv::circle(PixelsOf(picture_), {centre.x, centre.y}, cvRound(radius * pixels_per_metre_), kPale,
               1, cv::LINE_AA);
  }
}

FloorPicture::Pixel FloorPicture::At(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d off = (point - middle_) * pixels_per_metre_;
  const auto within = [](double value) {
    return cvRound(std::isfinite(value) ? std::clamp(value, -kFarthest, kFarthest) : kFarthest);
  };
  return {picture_.width / 2 + within(off.x()), picture_.height / 2 - within(off.y())};
}

void FloorPicture::DrawPoints(const std::vector<Eigen::Vector2d>& points, const Colour& colour) {
  cv::Mat pixels = PixelsOf(picture_);
  for (const Eigen::Vector2d& point : points) {
    const Pixel at = At(point);
    cv::circle(pixels, {at.x, at.y}, 2, ToScalar(colour), cv::FILLED);
  }
}

void FloorPicture::DrawWall(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Pixel a = At(from), b = At(to);
  cv::line(PixelsOf(picture_), {a.x, a.y}, {b.x, b.y}, kBlack, 3, cv::LINE_AA);
}

void FloorPicture::DrawTrail(const std::vector<Eigen::Vector2d>& trail, const Colour& colour) {
  cv::Mat pixels = PixelsOf(picture_);
  for (std::size_t i = 1; i < trail.size(); ++i) {
    const Pixel a = At(trail[i - 1]), b = At(trail[i]);
    cv::line(pixels, {a.x, a.y}, {b.x, b.y}, ToScalar(colour), 2, cv::LINE_AA);
  }
}

void FloorPicture::DrawPerson(const Eigen::Vector2d& at, const Eigen::Vector2d& velocity,
                              const std::string& text, const Colour& colour) {
  cv::Mat pixels = PixelsOf(picture_);
  const Pixel body = At(at), ahead = At(at + velocity);
  const int radius = cvRound(kBody * pixels_per_metre_);
  cv::circle(pixels, {body.x, body.y}, radius, ToScalar(colour), 2, cv::LINE_AA);
  cv::arrowedLine(pixels, {body.x, body.y}, {ahead.x, ahead.y}, ToScalar(colour), 2, cv::LINE_AA);
  cv::putText(pixels, text, {body.x + radius + 3, body.y - radius}, cv::FONT_HERSHEY_SIMPLEX,
              kLetters, ToScalar(colour), 1, cv::LINE_AA);
}

void FloorPicture::DrawRobot(const Pose2D& pose) {
  cv::Mat pixels = PixelsOf(picture_);
  const Eigen::Vector2d at(pose.x, pose.y);
  const Pixel middle = At(at);
  const Pixel front = At(at + kRobot * Eigen::Vector2d(std::cos(pose.yaw), std::sin(pose.yaw)));
  cv::circle(pixels, {middle.x, middle.y}, cvRound(kRobot * pixels_per_metre_), kBlack, 2,
             cv::LINE_AA);
  cv::line(pixels, {middle.x, middle.y}, {front.x, front.y}, kBlack, 2, cv::LINE_AA);
}

void FloorPicture::Write(const std::string& text) {
  cv::putText(PixelsOf(picture_), text, {10, picture_.height - 12}, cv::FONT_HERSHEY_SIMPLEX,
              kLetters, kBlack, 1, cv::LINE_AA);
}

}  // namespace coppice::robot::perception
