#include "robot_app/simulation/camera/surfaces.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::simulation {
namespace {

constexpr double kTile = 0.5;       // m, of the floor
constexpr double kJoint = 0.012;    // m, between its tiles
constexpr double kLampEvery = 2.4;  // m, on the ceiling
constexpr double kLampLong = 1.2;
constexpr double kLampWide = 0.35;
constexpr double kSkirting = 0.09;   // m, at the foot of walls
constexpr double kFrame = 0.06;      // m, around doors
constexpr double kHandle = 1.05;     // m
constexpr double kSheetEvery = 2.2;  // m: on walls there may be a poster in each such stretch
constexpr double kSheetWide = 0.6;
constexpr double kSheetLow = 1.15;
constexpr double kSheetHigh = 2.0;
constexpr double kBorder = 0.05;
constexpr double kPosterCell = 0.045;  // m, of a poster's pattern
constexpr double kPosterLow = 0.55;
constexpr int kPatternColumns = 6;
constexpr int kPatternRows = 9;

constexpr Colour kWall{208, 206, 196};
constexpr Colour kSkirtingPaint{96, 92, 86};
constexpr Colour kDoor{150, 104, 62};
constexpr Colour kDoorFrame{86, 62, 42};
constexpr Colour kMetal{188, 190, 194};
constexpr Colour kCardboard{196, 154, 98};
constexpr Colour kTape{226, 210, 170};
constexpr Colour kPaper{240, 240, 236};
constexpr Colour kFloor{118, 122, 128};
constexpr Colour kFloorJoint{88, 90, 94};
constexpr Colour kCeiling{222, 224, 226};
constexpr Colour kLamp{255, 255, 250};
constexpr std::array<Colour, 5> kFurniture = {
    {{128, 92, 60}, {88, 112, 140}, {104, 128, 96}, {150, 118, 84}, {110, 100, 120}}};
constexpr std::array<Colour, 7> kInks = {{{40, 60, 120},
                                          {200, 60, 50},
                                          {236, 196, 70},
                                          {60, 130, 80},
                                          {240, 240, 236},
                                          {30, 30, 34},
                                          {90, 160, 200}}};

long CellOf(double metres, double size) { return static_cast<long>(std::floor(metres / size)); }

std::uint64_t CellNumber(long column, long row) {
  return Mixed(static_cast<std::uint64_t>(column), static_cast<std::uint64_t>(row));
}

// A place on the wall, the same for both directions of its edge.
std::uint64_t NumberOf(const Segment& edge) {
  const auto coarse = [](double x) { return static_cast<std::uint64_t>(std::llround(x * 100)); };
  return Mixed(coarse(edge.a.x + edge.b.x), coarse(edge.a.y + edge.b.y));
}

Colour PaintOf(const Panel& panel) {
  switch (panel.material) {
    case Material::kWall:
      return kWall;
    case Material::kDoor:
      return kDoor;
    case Material::kFurniture:
      return kFurniture[static_cast<std::size_t>(panel.roof) % kFurniture.size()];
    case Material::kCardboard:
      return kCardboard;
    case Material::kPoster:
      return kPaper;
  }
  return {};
}

}  // namespace

PanelLine::PanelLine(const Panel& panel, double along)
    : material_(panel.material), paint_(PaintOf(panel)), top_(panel.top) {
  const double length = Length(panel.edge.b - panel.edge.a);
  if (material_ == Material::kDoor) {
    is_frame_ = std::min(along, length - along) < kFrame;
    is_handle_ = length - along > 0.08 && length - along < 0.2;
  }
  if (material_ == Material::kPoster) {
    sheet_ = Mixed(NumberOf(panel.edge), 5);
    column_ = static_cast<int>(std::floor(along / kPosterCell));
  }
  if (material_ != Material::kWall) return;
  const long stretch = CellOf(along, kSheetEvery);
  const double inside = along - static_cast<double>(stretch) * kSheetEvery - kSheetWide;
  const std::uint64_t lot = Mixed(NumberOf(panel.edge), static_cast<std::uint64_t>(stretch));
  const bool is_whole = static_cast<double>(stretch + 1) * kSheetEvery <= length;
  if (lot % 3 == 0 || !is_whole || inside < 0 || inside >= kSheetWide) return;
  sheet_ = lot;
  const double printed = kSheetWide - 2 * kBorder;
  column_ = static_cast<int>(std::floor((inside - kBorder) / printed * kPatternColumns));
  if (column_ >= kPatternColumns) column_ = -1;
}

Colour PanelLine::At(double height) const {
  if (material_ == Material::kDoor) {
    if (is_frame_ || top_ - height < kFrame) return kDoorFrame;
    return is_handle_ && std::abs(height - kHandle) < 0.02 ? kMetal : paint_;
  }
  if (material_ == Material::kCardboard) {
    return std::abs(height - top_ / 2) < 0.03 ? kTape : paint_;
  }
  if (material_ == Material::kPoster) {
    if (height < kPosterLow || top_ - height < kBorder) return kPaper;
    const auto row = static_cast<std::uint64_t>(std::floor(height / kPosterCell));
    return kInks[Mixed(sheet_, static_cast<std::uint64_t>(column_), row) % kInks.size()];
  }
  if (material_ == Material::kFurniture) {
    return top_ - height < 0.03 ? Lit(paint_, 1.2) : paint_;
  }
  if (height < kSkirting) return kSkirtingPaint;
  if (sheet_ == 0 || height < kSheetLow || height >= kSheetHigh) return paint_;
  const double printed = kSheetHigh - kSheetLow - 2 * kBorder;
  const double row = std::floor((height - kSheetLow - kBorder) / printed * kPatternRows);
  if (column_ < 0 || row < 0 || row >= kPatternRows) return kPaper;
  const std::uint64_t lot =
      Mixed(sheet_, static_cast<std::uint64_t>(column_), static_cast<std::uint64_t>(row));
  return kInks[lot % kInks.size()];
}

Colour FloorAt(Vec2 point) {
  const long column = CellOf(point.x, kTile);
  const long row = CellOf(point.y, kTile);
  const double x = point.x - static_cast<double>(column) * kTile;
  const double y = point.y - static_cast<double>(row) * kTile;
  if (x < kJoint || y < kJoint) return kFloorJoint;
  return Lit(kFloor, 0.94 + 0.01 * static_cast<double>(CellNumber(column, row) % 12));
}

Colour SkyAt(Vec2) { return {176, 206, 236}; }

Colour CeilingAt(Vec2 point) {
  const double x = point.x - static_cast<double>(CellOf(point.x, kLampEvery)) * kLampEvery;
  const double y = point.y - static_cast<double>(CellOf(point.y, kLampEvery)) * kLampEvery;
  return x < kLampLong && y < kLampWide ? kLamp : kCeiling;
}

Colour RoofAt(const Panel& panel) { return Lit(PaintOf(panel), 1.25); }

}  // namespace coppice::robot::simulation
