#include "robot_app/training/labelled_scan.h"

#include <algorithm>
#include <cmath>

#include "robot_app/training/placed_people.h"

namespace coppice::robot::training {

using simulation::Figure;
using simulation::Hit;
using simulation::kPi;
using simulation::Pose2;
using simulation::Scene;
using simulation::Vec2;

double VisibleShare(const Figure& figure, const Scene& all, const Pose2& sensor,
                    const simulation::Lidar3dOptions& lidar) {
  Scene alone;
  alone.SetFigures({figure});
  const std::vector<double> slopes = simulation::RingSlopes(lidar);
  const Vec2 view = figure.bounds.center - sensor.position();
  const double distance = simulation::Length(view);
  const double half = std::asin(std::min(1.0, figure.bounds.radius / distance));
  const double step = 2 * kPi / lidar.columns;
  std::vector<Hit> by_itself, with_others;
  int points = 0, seen = 0;
  for (double turn = -half; turn <= half; turn += step) {
    const Vec2 direction = simulation::Direction(std::atan2(view.y, view.x) + turn);
    const simulation::Vec3 origin{sensor.x, sensor.y, lidar.height};
    alone.CastFan(origin, direction, slopes, lidar.max_range, by_itself);
    all.CastFan(origin, direction, slopes, lidar.max_range, with_others);
    for (std::size_t ring = 0; ring < slopes.size(); ++ring) {
      const double range = by_itself[ring].range;
      const bool is_floor = lidar.height + range * slopes[ring] < 0.02;
      if (is_floor || std::abs(range - distance) > figure.bounds.radius) continue;
      ++points;
      seen += std::abs(with_others[ring].range - range) < 1e-6 ? 1 : 0;
    }
  }
  return points > 0 ? static_cast<double>(seen) / points : 0;
}

std::vector<perception::LidarPoint> ToPoints(const simulation::Cloud& cloud) {
  std::vector<perception::LidarPoint> points;
  points.reserve(cloud.points.size());
  for (const simulation::CloudPoint& point : cloud.points) {
    points.push_back({point.x, point.y, point.z, point.intensity, point.ring});
  }
  return points;
}

LabelledScan MakeLabelledScan(const Site& site, const simulation::Lidar3dOptions& lidar,
                              std::mt19937_64& random) {
  const PlacedPeople placed = PlacePeople(site, random);
  const Pose2& sensor = placed.robot;
  const std::vector<Figure> figures = FiguresOf(placed);
  Scene scene(site.still);
  scene.SetFigures(figures);
  simulation::Lidar3d device(lidar, random());
  device.Turn(0, lidar.period, sensor, scene);

  LabelledScan scan;
  scan.points = ToPoints(device.cloud());
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const Vec2 position =
        Compose(Inverse(sensor), {figures[i].bounds.center.x, figures[i].bounds.center.y, 0})
            .position();
    scan.people.push_back(
        {position, VisibleShare(figures[i], scene, sensor, lidar), placed.people[i].in_group});
  }
  return scan;
}

}  // namespace coppice::robot::training
