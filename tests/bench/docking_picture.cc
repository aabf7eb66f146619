#include "tests/bench/docking_picture.h"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <ostream>

#include "tests/robot_app/navigation/world_robot.h"

namespace coppice::robot::docking {
namespace {

constexpr std::size_t kMostWays = 60;
constexpr double kPointEvery = 0.04;  // of a way [m]
// What is shown of the map [m], and how large.
constexpr double kLeft = -3.3, kRight = 1.2, kBottom = -1.5, kTop = 1.5, kScale = 200;

struct Place {
  double x, y;
};

std::ostream& operator<<(std::ostream& out, const Place& place) {
  return out << (place.x - kLeft) * kScale << ',' << (kTop - place.y) * kScale << ' ';
}

const char* ColorOf(const DockingOutcome& outcome) {
  if (!outcome.docked) return "#c62828";
  return outcome.failed_attempts > 0 ? "#ef8c00" : "#2e7d32";
}

void DrawWalls(const simulation::Floor& floor, std::ostream& out) {
  for (const auto& wall : floor.walls) {
    out << "<polyline fill='none' stroke='black' stroke-width='4' points='";
    for (const simulation::Vec2& corner : wall) out << Place{corner.x, corner.y};
    out << "'/>\n";
  }
}

void DrawLandmark(const simulation::Floor& floor, const Pose2D& moved, std::ostream& out) {
  const auto landmark = simulation::LandmarkOf(floor, {moved.x, moved.y, moved.yaw});
  out << "<polygon fill='#1565c0' fill-opacity='0.05' stroke='#1565c0' stroke-width='0.5' "
         "points='";
  for (const simulation::Vec2& corner : *landmark) out << Place{corner.x, corner.y};
  out << "'/>\n";
}

void DrawWay(const DockingOutcome& outcome, std::ostream& out) {
  out << "<polyline fill='none' stroke-opacity='0.6' stroke='" << ColorOf(outcome) << "' points='";
  Pose2D last{1e9, 0, 0};
  for (const Pose2D& pose : outcome.way) {
    if (Distance(pose, last) < kPointEvery) continue;
    out << Place{pose.x, pose.y};
    last = pose;
  }
  out << "'/>\n";
}

void DrawStart(const DockingOutcome& outcome, std::ostream& out) {
  out << "<circle r='4' fill='" << ColorOf(outcome) << "' cx='"
      << (outcome.start.x - kLeft) * kScale << "' cy='" << (kTop - outcome.start.y) * kScale
      << "'/>\n";
}

}  // namespace

bool DrawDockings(const std::vector<DockingOutcome>& outcomes, const std::string& file) {
  const simulation::Floor floor = navigation::InstituteFloor();
  std::ofstream out(file);
  out << "<svg xmlns='http://www.w3.org/2000/svg' width='" << (kRight - kLeft) * kScale
      << "' height='" << (kTop - kBottom) * kScale << "'>\n<rect width='100%' height='100%' "
      << "fill='white'/>\n";
  out << std::fixed << std::setprecision(0);
  const std::size_t ways = std::min(kMostWays, outcomes.size());
  for (std::size_t i = 0; i < ways; ++i) DrawLandmark(floor, outcomes[i].station_moved, out);
  for (std::size_t i = 0; i < ways; ++i) DrawWay(outcomes[i], out);
  DrawWalls(floor, out);
  for (std::size_t i = 0; i < ways; ++i) DrawStart(outcomes[i], out);
  out << "</svg>\n";
  return static_cast<bool>(out);
}

}  // namespace coppice::robot::docking
