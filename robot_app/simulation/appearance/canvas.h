// Draws shapes with edges finer than a pixel, for pictures of people. Points are pixels from the
// upper left corner.
#ifndef COPPICE_ROBOT_APP_SIMULATION_APPEARANCE_CANVAS_H_
#define COPPICE_ROBOT_APP_SIMULATION_APPEARANCE_CANVAS_H_

#include <opencv2/core.hpp>
#include <vector>

#include "robot_app/common/picture.h"

namespace coppice::robot::simulation {

class Canvas {
 public:
  Canvas(int width, int height) : sheet_(height, width, CV_8UC4, cv::Scalar::all(0)) {}

  const cv::Mat& sheet() const { return sheet_; }

  // `light` times as bright as the colour.
  void Circle(const cv::Point2d& middle, double radius, const Colour& colour, double light = 1);
  /// A part of it from one angle to another, clockwise from the right [degrees].
  void Ellipse(const cv::Point2d& middle, cv::Size2d half, const Colour& colour, double light = 1,
               double from = 0, double to = 360);
  /// Its outline.
  void Ring(const cv::Point2d& middle, cv::Size2d half, double thick, const Colour& colour);
  void Polygon(const std::vector<cv::Point2d>& points, const Colour& colour, double light = 1);
  void Line(const std::vector<cv::Point2d>& points, double thick, const Colour& colour,
            double light = 1);
  /// A limb that grows thinner, round at its ends.
  void Taper(const cv::Point2d& a, const cv::Point2d& b, double at_a, double at_b,
             const Colour& colour, double light = 1);

 private:
  cv::Mat sheet_;  // red, green, blue, covered
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_APPEARANCE_CANVAS_H_
