#include "robot_app/localization/beams.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot::localization {
namespace {

constexpr double kFarthest = 20;        // nothing met: believed up to here at most [m]
constexpr double kEmptyAngle = 0.05;    // between two beams that met nothing [rad]
constexpr double kNear = 0.12;          // an end so near to a wall is at the wall [m]
constexpr double kNearPerMetre = 0.01;  // the farther, the more a small turn matters
constexpr double kEarly = 0.3;          // a wall so much before the end was passed through [m]
constexpr double kEarlyPerMetre = 0.1;
constexpr double kHiddenWeight = 0.3;

Point2D EndOf(const LaserScan& scan, double angle, double range) {
  return Compose(scan.mount, Point2D{range * std::cos(angle), range * std::sin(angle)});
}

}  // namespace

std::vector<Beam> BeamsOf(const LaserScan& scan, double spacing, int most) {
  std::vector<Beam> beams;
  const Point2D from{scan.mount.x, scan.mount.y};
  Point2D last{HUGE_VAL, HUGE_VAL};
  double last_empty = -HUGE_VAL;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const double range = scan.ranges[i];
    if (scan.Hit(i)) {
      const Point2D end = EndOf(scan, angle, range);
      if (Distance(end, last) < spacing) continue;
      beams.push_back({from, end, true});
      last = end;
    } else if (range >= scan.range_max && angle - last_empty >= kEmptyAngle) {
      beams.push_back({from, EndOf(scan, angle, std::min(kFarthest, scan.range_max)), false});
      last_empty = angle;
    }
  }
  const std::size_t every = (beams.size() + most - 1) / std::max(1, most);
  if (every <= 1) return beams;
  std::vector<Beam> fewer;
  for (std::size_t i = 0; i < beams.size(); i += every) fewer.push_back(beams[i]);
  return fewer;
}

std::vector<Beam> Moved(const std::vector<Beam>& beams, const Pose2D& shift) {
  const PointComposer shifted(shift);
  std::vector<Beam> moved;
  moved.reserve(beams.size());
  for (const Beam& beam : beams) {
    moved.push_back({shifted(beam.from), shifted(beam.to), beam.hit});
  }
  return moved;
}

double Agreement::score() const {
  const double all = agree + through + kHiddenWeight * hidden;
  return all > 0 ? agree / all : 0;
}

double Agreement::share() const {
  const int all = agree + through + hidden;
  return all > 0 ? static_cast<double>(agree) / all : 0;
}

Agreement Agree(const LikelihoodField& field, const std::vector<Beam>& beams, const Pose2D& pose) {
  const PointComposer in_map(pose);
  Agreement sum;
  for (const Beam& beam : beams) {
    const Point2D from = in_map(beam.from);
    const Point2D to = in_map(beam.to);
    const double range = Distance(from, to);
    if (field.Cast(from, to) < range - kEarly - kEarlyPerMetre * range) {
      ++sum.through;
    } else if (!beam.hit) {
      continue;
    } else if (field.Distance(to.x, to.y) < kNear + kNearPerMetre * range) {
      ++sum.agree;
    } else {
      ++sum.hidden;
    }
  }
  return sum;
}

}  // namespace coppice::robot::localization
