#include "robot_app/simulation/appearance/canvas.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace coppice::robot::simulation {
namespace {

constexpr int kSubpixel = 4;  // bits

cv::Scalar Opaque(const Colour& colour, double light) {
  const auto channel = [&](int i) { return std::clamp(colour[i] * light, 0.0, 255.0); };
  return {channel(0), channel(1), channel(2), 255};
}

int Fine(double x) { return static_cast<int>(std::lround(x * (1 << kSubpixel))); }
cv::Point Fine(const cv::Point2d& p) { return {Fine(p.x), Fine(p.y)}; }

std::vector<cv::Point> Fine(const std::vector<cv::Point2d>& points) {
  std::vector<cv::Point> fine;
  for (const cv::Point2d& p : points) fine.push_back(Fine(p));
  return fine;
}

int Thickness(double thick) { return std::max(1, static_cast<int>(std::lround(thick))); }

}  // namespace

void Canvas::Circle(const cv::Point2d& middle, double radius, const Colour& colour, double light) {
  cv::circle(sheet_, Fine(middle), Fine(radius), Opaque(colour, light), cv::FILLED, cv::LINE_8,
             kSubpixel);
}

void Canvas::Ellipse(const cv::Point2d& middle, cv::Size2d half, const Colour& colour, double light,
                     double from, double to) {
  cv::ellipse(sheet_, Fine(middle), {Fine(half.width), Fine(half.height)}, 0, from, to,
              Opaque(colour, light), cv::FILLED, cv::LINE_8, kSubpixel);
}

void Canvas::Ring(const cv::Point2d& middle, cv::Size2d half, double thick, const Colour& colour) {
  cv::ellipse(sheet_, Fine(middle), {Fine(half.width), Fine(half.height)}, 0, 0, 360,
              Opaque(colour, 1), Thickness(thick), cv::LINE_8, kSubpixel);
}

void Canvas::Polygon(const std::vector<cv::Point2d>& points, const Colour& colour, double light) {
  cv::fillPoly(sheet_, std::vector<std::vector<cv::Point>>{Fine(points)}, Opaque(colour, light),
               cv::LINE_8, kSubpixel);
}

void Canvas::Line(const std::vector<cv::Point2d>& points, double thick, const Colour& colour,
                  double light) {
  cv::polylines(sheet_, std::vector<std::vector<cv::Point>>{Fine(points)}, false,
                Opaque(colour, light), Thickness(thick), cv::LINE_8, kSubpixel);
}

void Canvas::Taper(const cv::Point2d& a, const cv::Point2d& b, double at_a, double at_b,
                   const Colour& colour, double light) {
  const cv::Point2d along = b - a;
  const double length = std::max(std::hypot(along.x, along.y), 1e-6);
  const cv::Point2d across(-along.y / length, along.x / length);
  Circle(a, at_a, colour, light);
  Circle(b, at_b, colour, light);
  Polygon({a + across * at_a, b + across * at_b, b - across * at_b, a - across * at_a}, colour,
          light);
}

}  // namespace coppice::robot::simulation
