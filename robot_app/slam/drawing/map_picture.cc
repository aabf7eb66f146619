#include "robot_app/slam/drawing/map_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

namespace coppice::robot::slam {
namespace {

constexpr int kMargin = 70;  // pixels, of a chart
constexpr int kChartWidth = 760;
constexpr int kChartHeight = 460;
constexpr int kLegend = 26;  // pixels a line

const cv::Scalar kInk(60, 60, 60);
const cv::Scalar kFaint(225, 225, 225);
const cv::Scalar kByPicture(230, 130, 20);
const cv::Scalar kByCloud(30, 160, 60);

// Red, green, blue; well apart.
cv::Scalar ColourOf(std::size_t number) {
  static const std::array<cv::Scalar, 6> kColours = {
      {{30, 90, 200}, {200, 40, 60}, {120, 60, 170}, {0, 140, 150}, {170, 110, 20}, {90, 90, 90}}};
  return kColours[number % kColours.size()];
}

cv::Mat Canvas(Picture& picture) {
  return {picture.height, picture.width, CV_8UC3, picture.rgb.data()};
}

void Write(const cv::Mat& canvas, const std::string& text, cv::Point at, const cv::Scalar& colour) {
  cv::putText(canvas, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.5, colour, 1, cv::LINE_AA);
}

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%g", value);
  return text;
}

void DrawCells(const OccupancyGrid& grid, int scale, cv::Mat& canvas) {
  for (int i = 0; i < grid.frame.size(); ++i) {
    const std::int8_t value = grid.cells[static_cast<std::size_t>(i)];
    if (value < 0) continue;
    const Cell cell = grid.frame.CellOf(i);
    const cv::Scalar colour =
        value >= OccupancyGrid::kOccupied ? cv::Scalar(40, 40, 40) : cv::Scalar(250, 250, 250);
    canvas(cv::Rect(cell.x * scale, (grid.frame.height - 1 - cell.y) * scale, scale, scale))
        .setTo(colour);
  }
}

// Where a chart's numbers lie in the picture.
class Axes {
 public:
  Axes(const std::vector<Curve>& curves, bool is_logarithmic) : is_logarithmic_(is_logarithmic) {
    low_ = HUGE_VAL;
    high_ = -HUGE_VAL;
    for (const Curve& curve : curves) {
      for (const double x : curve.x) {
        low_ = std::min(low_, Scaled(x));
        high_ = std::max(high_, Scaled(x));
      }
    }
    if (!(high_ > low_)) high_ = low_ + 1;
  }

  cv::Point At(double x, double y) const {
    const double across = (Scaled(x) - low_) / (high_ - low_);
    return {kMargin + static_cast<int>(std::lround(across * kChartWidth)),
            kMargin / 2 + static_cast<int>(std::lround((1 - y) * kChartHeight))};
  }

 private:
  double Scaled(double x) const { return is_logarithmic_ ? std::log(std::max(x, 1e-9)) : x; }

  bool is_logarithmic_;
  double low_ = 0, high_ = 0;
};

void DrawGridLines(const std::vector<Curve>& curves, const Axes& axes, const cv::Mat& canvas) {
  for (int i = 0; i <= 5; ++i) {
    const double y = i / 5.0;
    const int row = axes.At(1, y).y;
    cv::line(canvas, {kMargin, row}, {kMargin + kChartWidth, row}, kFaint, 1);
    Write(canvas, Number(y), {kMargin - 42, row + 5}, kInk);
  }
  for (const double x : curves.empty() ? std::vector<double>{} : curves[0].x) {
    const cv::Point foot = axes.At(x, 0);
    cv::line(canvas, foot, axes.At(x, 1), kFaint, 1);
    Write(canvas, Number(x), {foot.x - 14, foot.y + 20}, kInk);
  }
}

}  // namespace

Picture DrawPlan(const OccupancyGrid& grid, const SlamMap& map, std::uint32_t of_session,
                 int most_pixels) {
  const int longer = std::max({grid.frame.width, grid.frame.height, 1});
  const int scale = std::clamp(most_pixels / longer, 1, 8);
  Picture picture(std::max(grid.frame.width * scale, 1),
                  std::max(grid.frame.height * scale, 1) + 2 * kLegend);
  cv::Mat canvas = Canvas(picture);
  canvas.setTo(cv::Scalar(205, 208, 210));
  DrawCells(grid, scale, canvas);
  const auto at = [&](std::uint32_t i) {
    const Eigen::Vector3d& place = map.graph.poses[i].translation();
    const double pixels = scale / grid.frame.resolution;
    return cv::Point(static_cast<int>(std::lround((place.x() - grid.frame.origin_x) * pixels)),
                     grid.frame.height * scale -
                         static_cast<int>(std::lround((place.y() - grid.frame.origin_y) * pixels)));
  };
  const SessionGraph graph({}, map.graph, map.sessions);
  for (const Link& link : map.graph.links) {
    if (graph.map_of(map.sessions[link.from]) != graph.map_of(of_session)) continue;
    const cv::Scalar colour = link.kind == LinkKind::kStep      ? ColourOf(map.sessions[link.to])
                              : link.kind == LinkKind::kPicture ? kByPicture
                                                                : kByCloud;
    cv::line(canvas, at(link.from), at(link.to), colour, 1, cv::LINE_AA);
  }
  int column = 10;
  const int row = picture.height - kLegend + 4;
  const auto legend = [&](const std::string& text, const cv::Scalar& colour) {
    Write(canvas, text, {column, row}, colour);
    column += 20 + 9 * static_cast<int>(text.size());
  };
  for (std::size_t i = 0; i < map.names.size(); ++i) legend(map.names[i].name, ColourOf(i));
  legend("closed by picture", kByPicture);
  legend("by cloud", kByCloud);
  return picture;
}

Picture DrawSection(const OccupancyGrid& section, const std::string& name, int most_pixels) {
  const GridFrame& frame = section.frame;
  const int scale = std::clamp(most_pixels / std::max(frame.width, 1), 1, 16);
  Picture picture(frame.width * scale + kMargin, frame.height * scale + 3 * kLegend);
  cv::Mat canvas = Canvas(picture);
  canvas.setTo(cv::Scalar(205, 208, 210));
  cv::Mat inside = canvas(cv::Rect(kMargin, 0, frame.width * scale, frame.height * scale));
  DrawCells(section, scale, inside);
  const double pixels = scale / frame.resolution;
  const int foot = frame.height * scale;
  for (int z = static_cast<int>(std::ceil(frame.origin_y)); (z - frame.origin_y) * pixels <= foot;
       ++z) {
    const int row = foot - static_cast<int>(std::lround((z - frame.origin_y) * pixels));
    cv::line(canvas, {kMargin - 6, row}, {picture.width, row}, kFaint, 1);
    Write(canvas, Number(z) + " m", {8, row + 5}, kInk);
  }
  const int first = 5 * static_cast<int>(std::ceil(frame.origin_x / 5));
  for (int at = first; (at - frame.origin_x) * pixels <= frame.width * scale; at += 5) {
    const int column = kMargin + static_cast<int>(std::lround((at - frame.origin_x) * pixels));
    cv::line(canvas, {column, 0}, {column, foot + 6}, kFaint, 1);
    Write(canvas, Number(at), {column - 8, foot + 22}, kInk);
  }
  Write(canvas, name, {kMargin, picture.height - 10}, kInk);
  return picture;
}

Picture DrawCurves(const std::vector<Curve>& curves, const std::string& x_axis,
                   const std::string& y_axis, bool is_logarithmic) {
  Picture picture(kChartWidth + 2 * kMargin, kChartHeight + 2 * kMargin);
  cv::Mat canvas = Canvas(picture);
  canvas.setTo(cv::Scalar(255, 255, 255));
  const Axes axes(curves, is_logarithmic);
  DrawGridLines(curves, axes, canvas);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Curve& curve = curves[i];
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
      cv::circle(canvas, axes.At(curve.x[k], curve.y[k]), 4, ColourOf(i), cv::FILLED, cv::LINE_AA);
      if (k > 0) {
        cv::line(canvas, axes.At(curve.x[k - 1], curve.y[k - 1]), axes.At(curve.x[k], curve.y[k]),
                 ColourOf(i), 2, cv::LINE_AA);
      }
    }
    Write(canvas, curve.name, {kMargin + 14, kMargin + kLegend * static_cast<int>(i)}, ColourOf(i));
  }
  Write(canvas, y_axis, {10, 20}, kInk);
  Write(canvas, x_axis, {kMargin + kChartWidth / 2 - 60, picture.height - 30}, kInk);
  return picture;
}

}  // namespace coppice::robot::slam
