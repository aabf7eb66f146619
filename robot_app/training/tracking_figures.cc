#include "robot_app/training/tracking_figures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "robot_app/perception/clouds/hidden.h"
#include "robot_app/training/labelled_scan.h"
#include "robot_app/training/moving_crowd.h"

namespace coppice::robot::training {
namespace {

using perception::MotPerson;
using perception::Track;
using simulation::Pose2;
using simulation::Vec2;

constexpr double kStep = 0.02;      // of the world [s]
constexpr double kArea = 5;         // of which all have to be followed, around the robot [m]
constexpr double kBorder = 0.5;     // beyond it who is there counts neither way [m]
constexpr double kLeastSeen = 0.3;  // of a person
constexpr double kWarmUp = 2;       // s

Site Hall() {
  Site site;
  site.area = {{0, 0}, {12, 12}, 0};
  site.still.ceiling = 3;
  site.still.AddBox({{0, 0}, {12.4, 12.4}, 0}, 3, simulation::Material::kWall);
  site.still.roofs.clear();  // the box is the walls of the hall, seen from inside
  site.still.AddBox({{2.5, 2}, {0.4, 0.4}, 0}, 3, simulation::Material::kWall);
  site.still.AddBox({{-2, -3}, {0.4, 0.4}, 0.5}, 3, simulation::Material::kWall);
  site.still.AddBox({{4.5, -4}, {0.8, 1.6}, 0}, 0.75, simulation::Material::kFurniture);
  return site;
}

Eigen::Vector2d ToEigen(Vec2 point) { return {point.x, point.y}; }

std::vector<simulation::Figure> FiguresOf(const MovingCrowd& crowd) {
  std::vector<simulation::Figure> figures;
  for (const simulation::Stance& stance : crowd.people()) figures.push_back(MakeFigure(stance));
  return figures;
}

// What the sensor saw in a turn in which it turned by `turned` and ended at `sensor`, in the frame
// of the hall.
std::vector<perception::Detection> InHall(const std::vector<perception::SeenPerson>& people,
                                          const Pose2& sensor, double turned) {
  std::vector<perception::Detection> detections;
  for (const perception::SeenPerson& person : people) {
    const Eigen::Rotation2Dd turn(sensor.yaw - (1 - person.turn) * turned);
    perception::Detection detection;
    detection.position = turn * person.position.cast<double>() + ToEigen(sensor.position());
    detection.covariance =
        turn * person.covariance.cast<double>() * turn.inverse().toRotationMatrix();
    detection.probability = person.probability;
    detections.push_back(detection);
  }
  return detections;
}

std::vector<MotPerson> TruthOf(const std::vector<simulation::Figure>& figures,
                               const simulation::Scene& scene, const Pose2& sensor) {
  std::vector<MotPerson> truth;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const Vec2 at = figures[i].bounds.center;
    const bool is_optional = simulation::Length(at - sensor.position()) > kArea ||
                             VisibleShare(figures[i], scene, sensor, {}) < kLeastSeen;
    truth.push_back({static_cast<std::uint32_t>(i), ToEigen(at), is_optional});
  }
  return truth;
}

}  // namespace

TrackingFigures MeasureTracking(perception::PeopleFinder& finder,
                                const TrackingScenario& scenario) {
  const Site site = Hall();
  MovingCrowd crowd(site, scenario.people, {0, 0}, 0.8, scenario.seed);
  simulation::Scene scene(site.still);
  simulation::Lidar3d lidar({}, scenario.seed);
  perception::Tracker tracker;
  TrackingFigures figures;
  Pose2 sensor;
  double cloud = -1;
  for (double time = 0; time < scenario.seconds; time += kStep) {
    crowd.Step(kStep);
    const auto now = FiguresOf(crowd);
    scene.SetFigures(now);
    lidar.Turn(time, kStep, sensor, scene);
    sensor.yaw = simulation::NormalAngle(sensor.yaw + scenario.turning * kStep);
    if (lidar.cloud().points.empty() || lidar.cloud().time == cloud) continue;
    cloud = lidar.cloud().time;

    const auto points = ToPoints(lidar.cloud());
    const auto begin = std::chrono::steady_clock::now();
    const auto detections =
        InHall(finder.Find(points), sensor, scenario.turning * lidar.options().period);
    tracker.Update(time, detections, [&](const Eigen::Vector2d& at) {
      const Vec2 local = simulation::Rotated({at.x() - sensor.x, at.y() - sensor.y}, -sensor.yaw);
      return perception::IsHidden(finder.candidates().image(), ToEigen(local).cast<float>());
    });
    figures.seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    ++figures.turns;
    if (time < kWarmUp) continue;

    std::vector<MotPerson> tracked;
    for (const Track& track : tracker.tracks()) {
      if (!track.is_confirmed) continue;
      const bool is_outside =
          (track.position() - ToEigen(sensor.position())).norm() > kArea + kBorder;
      const bool is_guess = track.last_seen < time;  // where somebody hidden may be
      tracked.push_back({track.id, track.position(), is_outside || is_guess});
    }
    figures.mot.Add(TruthOf(now, scene, sensor), tracked);
    figures.person_minutes += scenario.people * lidar.options().period / 60;
  }
  return figures;
}

std::string Summary(const TrackingFigures& figures) {
  char text[256];
  std::snprintf(text, sizeof(text),
                "MOTA %.3f (%d of %d missed, %d extra), %.2f identity switches a person-minute, "
                "position %.2f m, %.1f ms a turn\n",
                figures.mot.mota(), figures.mot.missed, figures.mot.people, figures.mot.extra,
                figures.switches_per_person_minute(), figures.mot.position_error(),
                1e3 * figures.seconds / std::max(figures.turns, 1));
  return text;
}

}  // namespace coppice::robot::training
