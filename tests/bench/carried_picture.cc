#include "tests/bench/carried_picture.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <ostream>

namespace coppice::robot::slam {
namespace {

using simulation::Vec2;

constexpr double kScale = 22;     // pixels per metre
constexpr double kMargin = 0.5;   // m
constexpr double kHeading = 0.7;  // m: the height of a name
constexpr double kLook = 0.45;    // m: the stroke that says how the robot was turned

struct Extent {
  double low_x = HUGE_VAL, low_y = HUGE_VAL, high_x = -HUGE_VAL, high_y = -HUGE_VAL;

  double width() const { return high_x - low_x + 2 * kMargin; }
  double height() const { return high_y - low_y + 2 * kMargin + kHeading; }
};

Extent ExtentOf(const simulation::Floor& floor) {
  Extent extent;
  for (const auto& wall : floor.walls) {
    for (const Vec2& corner : wall) {
      extent.low_x = std::min(extent.low_x, corner.x);
      extent.low_y = std::min(extent.low_y, corner.y);
      extent.high_x = std::max(extent.high_x, corner.x);
      extent.high_y = std::max(extent.high_y, corner.y);
    }
  }
  return extent;
}

// One floor of the picture, whose upper edge lies there [m].
class Panel {
 public:
  Panel(const Extent& extent, double top, std::ostream& out)
      : extent_(extent), top_(top), out_(out) {}

  void Name(const std::string& name) {
    out_ << "<text x='" << kMargin * kScale << "' y='" << (top_ + kHeading) * kScale
         << "' font-family='sans-serif' font-size='14'>" << name << "</text>\n";
  }
  void Walls(const simulation::Floor& floor) {
    for (const auto& wall : floor.walls) {
      out_ << "<polyline fill='none' stroke='#555' stroke-width='2' points='";
      for (const Vec2& corner : wall) out_ << X(corner.x) << ',' << Y(corner.y) << ' ';
      out_ << "'/>\n";
    }
  }
  void Place(const CarriedOutcome& one) {
    const char* const colour = one.found()                                         ? "#2e7d32"
                               : one.phase == localization::LocalizationPhase::kOk ? "#c62828"
                                                                                   : "#ef8c00";
    const Pose2D& at = one.place;
    out_ << "<circle r='4' fill='" << colour << "' cx='" << X(at.x) << "' cy='" << Y(at.y)
         << "'/><line stroke='" << colour << "' stroke-width='2' x1='" << X(at.x) << "' y1='"
         << Y(at.y) << "' x2='" << X(at.x + kLook * std::cos(at.yaw)) << "' y2='"
         << Y(at.y + kLook * std::sin(at.yaw)) << "'/>\n";
  }

 private:
  double X(double x) const { return (x - extent_.low_x + kMargin) * kScale; }
  double Y(double y) const { return (top_ + kHeading + kMargin + extent_.high_y - y) * kScale; }

  const Extent extent_;
  const double top_;
  std::ostream& out_;
};

}  // namespace

bool DrawCarried(const simulation::Floor& floor, const std::vector<DrawnStudy>& studies,
                 const std::string& file) {
  const Extent extent = ExtentOf(floor);
  std::ofstream out(file);
  out << std::fixed << std::setprecision(0);
  out << "<svg xmlns='http://www.w3.org/2000/svg' width='" << extent.width() * kScale
      << "' height='" << extent.height() * kScale * static_cast<double>(studies.size())
      << "'>\n<rect width='100%' height='100%' fill='white'/>\n";
  double top = 0;
  for (const DrawnStudy& study : studies) {
    Panel panel(extent, top, out);
    panel.Name(study.name);
    panel.Walls(floor);
    for (const CarriedOutcome& one : study.outcomes) panel.Place(one);
    top += extent.height();
  }
  out << "</svg>\n";
  return static_cast<bool>(out);
}

}  // namespace coppice::robot::slam
