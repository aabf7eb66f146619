#include "robot_app/expression/face_painter.h"

#include <opencv2/imgproc.hpp>

namespace coppice::robot::expression {
namespace {

constexpr int kFiner = 8;         // painted so many times larger, so that edges are smooth
constexpr double kEyeRow = 15.5;  // pixels
constexpr double kEyeColumns[] = {15.5, 47.5};

struct Origin {
  double x = 0, y = 0;  // pixels
  double sign = 1;      // -1: mirrored
};

// In the large picture. Pixel 0 reaches from -0.5 to 0.5.
double Large(double pixels) { return (pixels + 0.5) * kFiner; }
cv::Point At(const Origin& origin, double x, double y) {
  return {cvRound(Large(origin.x + origin.sign * x)), cvRound(Large(origin.y + y))};
}

class Painter {
 public:
  Painter(cv::Mat& canvas, const Origin& origin) : canvas_(canvas), origin_(origin) {}

  void Paint(const Shape& shape) {
    const auto& n = shape.numbers;
    const cv::Scalar colour(shape.colour[0], shape.colour[1], shape.colour[2]);
    const cv::Point first = At(origin_, n[0], n[1]);
    switch (shape.kind) {
      case ShapeKind::kRing:
        cv::ellipse(canvas_, first, Axes(n[2], n[3]), 0, 0, 360, colour, Width(n[4]));
        break;
      case ShapeKind::kDisc:
        cv::ellipse(canvas_, first, Axes(n[2], n[2]), 0, 0, 360, colour, cv::FILLED);
        break;
      case ShapeKind::kArc:
        cv::ellipse(canvas_, first, Axes(n[2], n[2]), 0, Angle(n[4]), Angle(n[5]), colour,
                    Width(n[3]));
        break;
      case ShapeKind::kLine:
        cv::line(canvas_, first, At(origin_, n[2], n[3]), colour, Width(n[4]));
        break;
    }
  }

 private:
  static int Width(double pixels) { return std::max(1, cvRound(std::abs(pixels) * kFiner)); }
  static cv::Size Axes(double x, double y) {
    return {cvRound(std::abs(x) * kFiner), cvRound(std::abs(y) * kFiner)};
  }
  double Angle(double degrees) const { return origin_.sign > 0 ? degrees : 180 - degrees; }

  cv::Mat& canvas_;
  const Origin origin_;
};

}  // namespace

Picture PaintFace(const FaceFrame& frame) {
  cv::Mat canvas = cv::Mat::zeros(kFaceHeight * kFiner, kFaceWidth * kFiner, CV_8UC3);
  for (int eye = 0; eye < 2; ++eye) {
    Painter painter(
        canvas, {kEyeColumns[eye] + frame.look[0], kEyeRow + frame.look[1], eye == 0 ? -1.0 : 1.0});
    for (const Shape& shape : frame.eyes) painter.Paint(shape);
  }
  Painter painter(canvas, {});
  for (const Shape& shape : frame.also) painter.Paint(shape);
  Picture picture(kFaceWidth, kFaceHeight);
  cv::Mat small(kFaceHeight, kFaceWidth, CV_8UC3, picture.rgb.data());
  cv::resize(canvas, small, small.size(), 0, 0, cv::INTER_AREA);
  return picture;
}

}  // namespace coppice::robot::expression
