#include "robot_app/docking/dock_path.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice::robot::docking {
namespace {

constexpr double kStep = 0.05;      // along a path [m]
constexpr double kNoNearer = 0.03;  // than what is near already, but for the noise [m]
constexpr double kHeadings = 24;    // to which it may turn first
constexpr std::array<double, 4> kStraights = {1.0, 0.8, 0.6, 0.45};  // [m]
constexpr double kCrooked = 6;           // what a metre less of them counts [s]
constexpr double kTurnCosts = 0.7;       // the least time of a turn on the spot [s]
constexpr double kStationMargin = 0.07;  // around the landmark, what is seen is the station [m]

struct Candidate {
  DockPath path;
  double seconds = 0;
};

double SecondsFor(const DockPath& path, const DockSettings& settings) {
  const double turn = std::abs(NormalizeAngle(path.curve.from.yaw - path.from.yaw));
  const double longest = kStraights.front();
  return (turn > 0 ? kTurnCosts + turn / settings.turn_speed : 0) +
         path.curve.length() / settings.align_speed + path.straight / settings.approach_speed +
         (longest - path.straight) * kCrooked;
}

// The headings to which the robot may turn first; the one that it has comes first.
std::vector<double> Headings(const Pose2D& robot, double straight, double aside) {
  std::vector<double> headings = {robot.yaw, std::atan2(aside - robot.y, -straight - robot.x)};
  for (int i = 0; i < kHeadings; ++i) headings.push_back(NormalizeAngle(2 * M_PI * i / kHeadings));
  return headings;
}

std::vector<Candidate> Candidates(const Pose2D& robot, double aside, const DockSettings& settings) {
  std::vector<Candidate> candidates;
  for (const double straight : kStraights) {
    const Pose2D entry{-straight, aside, 0};
    for (const double heading : Headings(robot, straight, aside)) {
      const Pose2D from{robot.x, robot.y, heading};
      for (const DubinsPath& curve : DubinsPaths(from, entry, settings.turn_radius)) {
        const DockPath path{robot, curve, straight};
        candidates.push_back({path, SecondsFor(path, settings)});
      }
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.seconds < b.seconds; });
  return candidates;
}

}  // namespace

Pose2D DockPath::At(double way) const {
  const double before = curve.length();
  if (way <= before) return curve.At(way);
  return Compose(curve.At(before), Pose2D{way - before, 0, 0});
}

double DockPath::Nearest(const Point2D& point, double since, double ahead) const {
  double best = since;
  double least = 1e9;
  for (double way = since; way <= since + ahead; way += 0.01) {
    const Pose2D at = At(way);
    const double distance = std::hypot(at.x - point.x, at.y - point.y);
    if (distance >= least) continue;
    least = distance;
    best = way;
  }
  return best;
}

bool IsBlocked(const DockPath& path, double begin, double end,
               const std::vector<Point2D>& obstacles, const DockSettings& settings, double margin) {
  const double room = settings.robot_radius + margin;
  const Pose2D here = path.At(begin);
  // Of those that can matter at all: the point, and how near it may come.
  std::vector<std::pair<Point2D, double>> near;
  for (const Point2D& point : obstacles) {
    const double now = std::hypot(point.x - here.x, point.y - here.y);
    if (now < end - begin + room) near.emplace_back(point, std::min(room, now - kNoNearer));
  }
  for (double way = begin; way <= end; way += kStep) {
    const Pose2D at = path.At(way);
    for (const auto& [point, least] : near) {
      if (std::hypot(point.x - at.x, point.y - at.y) < least) return true;
    }
  }
  return false;
}

std::optional<DockPath> PlanDockPath(const Pose2D& robot, double aside,
                                     const std::vector<Point2D>& obstacles,
                                     const DockSettings& settings) {
  for (const Candidate& candidate : Candidates(robot, aside, settings)) {
    if (!IsBlocked(candidate.path, 0, candidate.path.length(), obstacles, settings)) {
      return candidate.path;
    }
  }
  return std::nullopt;
}

std::vector<Point2D> WithoutStation(const std::vector<Point2D>& points, const Pose2D& robot,
                                    const LandmarkShape& shape) {
  const double slope = shape.depth() / shape.half_width();
  std::vector<Point2D> others;
  for (const Point2D& point : points) {
    const Point2D in_station = Compose(robot, point);
    const double side = std::abs(in_station.y);
    const bool is_station = side < shape.half_width() + kStationMargin &&
                            in_station.x > shape.ahead + slope * side - kStationMargin;
    if (!is_station) others.push_back(in_station);
  }
  return others;
}

}  // namespace coppice::robot::docking
