#include "robot_app/navigation/sonar_layer.h"

#include <cmath>
#include <cstdio>

namespace coppice::robot::navigation {
namespace {

constexpr double kClockSlack = 0.1;  // two clocks may differ by this [s]
constexpr double kNoise = 0.1;       // so near to an echo nothing is cleared [m]
constexpr double kBesides = 0.05;    // what is seen so near beside the cone may be in it [rad]

struct Polar {
  double range, bearing;
};

Polar FromSensor(const Pose2D& sensor, const Point2D& point) {
  const Point2D local = RelativeTo(sensor, point);
  return {std::hypot(local.x, local.y), std::atan2(local.y, local.x)};
}

// Of a thing that is too near to measure, it is only known that it is nearer than the least range.
double RangeOf(const RangeReading& reading) {
  return reading.TooNear() ? reading.min_range / 2 : reading.range;
}

}  // namespace

void SonarLayer::Reset(const GridFrame& frame) {
  marks_.Reset(frame);
  heading_.assign(static_cast<std::size_t>(frame.size()), 0);
}

Outcome SonarLayer::Insert(const Pose2D& pose, const RangeReading& reading,
                           const std::vector<Point2D>& seen, double now) {
  Forget(now);
  if (Outcome tells = Check(reading); !tells) return tells;
  const double age = now - reading.stamp;
  if (!(age <= settings_.oldest && age >= -kClockSlack)) {
    char text[60];
    std::snprintf(text, sizeof text, "its stamp is %.3g s old", age);
    return Problem{text};
  }
  const Pose2D sensor = Compose(pose, reading.mount);
  ClearNearer(sensor, reading.field_of_view / 2, RangeOf(reading));
  const bool marks = RangeOf(reading) <= settings_.mark_range;
  if (marks && !IsSeen(sensor, reading, seen)) MarkArc(sensor, reading);
  return {};
}

bool SonarLayer::IsSeen(const Pose2D& sensor, const RangeReading& reading,
                        const std::vector<Point2D>& seen) const {
  const double half = reading.field_of_view / 2 + kBesides;
  const double range = std::max(reading.range, reading.min_range);
  return std::any_of(seen.begin(), seen.end(), [&](const Point2D& point) {
    const Polar polar = FromSensor(sensor, point);
    return std::abs(polar.bearing) <= half && polar.range >= range - settings_.seen_nearer &&
           polar.range <= range + settings_.seen_farther;
  });
}

// A cell belongs to the cone if a part of it does.
void SonarLayer::ClearNearer(const Pose2D& sensor, double half_cone, double range) {
  const double cell = marks_.frame().resolution;
  marks_.KeepIf([&](int index) {
    const Polar polar = FromSensor(sensor, marks_.frame().Center(marks_.frame().CellOf(index)));
    const bool is_beside = std::abs(polar.bearing) > half_cone + cell / polar.range;
    if (is_beside || polar.range > range - kNoise) return true;
    const double turned = NormalizeAngle(sensor.yaw + polar.bearing - heading_[index]);
    return std::abs(turned) > settings_.same_side;
  });
}

void SonarLayer::MarkArc(const Pose2D& sensor, const RangeReading& reading) {
  const GridFrame& frame = marks_.frame();
  const double range = RangeOf(reading);
  const double half = reading.field_of_view / 2;
  const int steps = 1 + static_cast<int>(2 * half * range / (frame.resolution / 2));
  for (int i = 0; i <= steps; ++i) {
    const double bearing = half * (2.0 * i / steps - 1);
    const Point2D point =
        Compose(sensor, Point2D{range * std::cos(bearing), range * std::sin(bearing)});
    const Cell cell = frame.CellAt(point.x, point.y);
    if (!frame.Contains(cell)) continue;
    marks_.Mark(frame.Index(cell), reading.stamp);
    heading_[frame.Index(cell)] = static_cast<float>(sensor.yaw + bearing);
  }
}

void SonarLayer::AddPoints(const Pose2D& pose, double limit, std::vector<Point2D>& points) const {
  for (const int index : marks_.list()) {
    const Point2D local = RelativeTo(pose, marks_.frame().Center(marks_.frame().CellOf(index)));
    if (std::hypot(local.x, local.y) <= limit) points.push_back(local);
  }
}

}  // namespace coppice::robot::navigation
