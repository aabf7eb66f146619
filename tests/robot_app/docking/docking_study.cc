#include "tests/robot_app/docking/docking_study.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/robot_app/docking/docking_robot.h"

namespace coppice::robot::docking {
namespace {

using simulation::Pose2;
using simulation::Vec2;

constexpr double kFarthest = 0.5;  // the station is moved [m]
constexpr double kMostTurned = 20 * M_PI / 180;
constexpr double kStandsFree = 0.08;  // from the walls, as it was built [m]
constexpr double kHalfAlcove = 1.25;  // half the width of the room before the station [m]
constexpr double kRoom = 0.42;        // of the robot's centre from a wall [m]
constexpr double kStartReach = 1.5;   // from the staging pose [m]

class Lot {
 public:
  explicit Lot(std::uint64_t seed) : random_(seed) {}
  double Even(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double Normal(double deviation) {
    return std::normal_distribution<double>(0, deviation)(random_);
  }
  int Count(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }

 private:
  std::mt19937_64 random_;
};

// Free of the walls, and with room for the robot before it.
bool CanStandThere(const simulation::Floor& floor, const Pose2& moved) {
  const Pose2 docked = Compose(floor.docked, moved);
  const Pose2 entry = Compose(docked, {-0.45, 0, 0});
  if (std::max(std::abs(docked.y), std::abs(entry.y)) > kHalfAlcove - kRoom) return false;
  const double wall = floor.docked.x - 0.6;
  const auto triangle = simulation::LandmarkAt(floor.landmark->shape, docked);
  return std::all_of(triangle.begin(), triangle.end(), [&](const Vec2& corner) {
    return corner.x > wall + kStandsFree && std::abs(corner.y) < kHalfAlcove - kStandsFree;
  });
}

Pose2 DrawMove(const simulation::Floor& floor, Lot& lot) {
  for (;;) {
    const Pose2 moved{lot.Even(-kFarthest, kFarthest), lot.Even(-kFarthest, kFarthest),
                      lot.Even(-kMostTurned, kMostTurned)};
    if (std::hypot(moved.x, moved.y) <= kFarthest && CanStandThere(floor, moved)) return moved;
  }
}

Pose2 DrawStart(const simulation::Floor& floor, const Pose2& moved, Lot& lot) {
  const auto triangle = simulation::LandmarkAt(floor.landmark->shape, Compose(floor.docked, moved));
  for (;;) {
    const double reach = kHalfAlcove - kRoom;
    const Pose2 start{floor.staging.x + lot.Even(-kStartReach, kStartReach),
                      lot.Even(-reach, reach), lot.Even(-M_PI, M_PI)};
    double clear = 9;
    for (const auto& side : simulation::SidesOf(triangle)) {
      clear = std::min(clear, simulation::Distance(start.position(), side));
    }
    if (Length(start.position() - floor.staging.position()) <= kStartReach && clear > kRoom) {
      return start;
    }
  }
}

// Somebody comes along the corridor, crosses the place before the station, and leaves again.
simulation::Walker DrawPasserBy(int number, Lot& lot) {
  simulation::Walker walker;
  walker.name = "passer_by_" + std::to_string(number);
  walker.speed = lot.Even(0.6, 1.3);
  walker.path = {{lot.Even(3, 9), lot.Even(-0.8, 0.8)},
                 {lot.Even(-1.9, 0.5), lot.Even(0.3, 0.9)},
                 {lot.Even(-1.9, 0.5), lot.Even(-0.9, -0.3)}};
  if (lot.Count(1) == 0) std::swap(walker.path[1], walker.path[2]);
  walker.path.push_back(walker.path.front());
  walker.path.push_back({20, 0});
  return walker;
}

}  // namespace

DockingOutcome DockOnce(std::uint64_t seed, const StudyOptions& study) {
  Lot lot(seed);
  simulation::Floor floor = navigation::InstituteFloor();
  floor.people.clear();
  const int people = study.passers_by ? lot.Count(3) : 0;
  for (int i = 0; i < people; ++i) floor.people.push_back(DrawPasserBy(i, lot));
  for (simulation::Walker& walker : floor.people) walker.steps_aside = study.steps_aside;
  const Pose2 moved = study.moved ? DrawMove(floor, lot) : Pose2{};
  simulation::WorldOptions options;
  options.start = DrawStart(floor, moved, lot);
  options.seed = seed;
  options.state_of_charge = 0.5;
  options.odometry.diameter_error = study.wheel_error;
  options.odometry.slip = 0.01;
  DockingOutcome outcome;
  outcome.start = ToPose2D(*options.start);
  outcome.station_moved = ToPose2D(moved);
  Pose2D believed = outcome.start;
  believed = {believed.x + lot.Normal(0.08), believed.y + lot.Normal(0.08),
              believed.yaw + lot.Normal(0.04)};
  DockingRobot robot(floor, options, believed);
  if (const auto change = robot.world().MoveStation(moved); !change) {
    outcome.message = change.problem();
    return outcome;
  }
  robot.Stand(0.3);
  const double begin = robot.world().time();
  robot.controller().StartDocking(robot.Input());
  robot.Run(study.patience);
  outcome.seconds = robot.world().time() - begin;
  outcome.docked = robot.controller().phase() == DockController::Phase::kDone &&
                   robot.world().battery().charging();
  outcome.failed_attempts = robot.controller().failed_attempts();
  const Pose2D off =
      RelativeTo(ToPose2D(robot.world().station()), navigation::PoseOf(robot.world()));
  outcome.aside = off.y;
  outcome.turned = off.yaw;
  outcome.message = robot.controller().active() ? ToString(robot.controller().phase())
                                                : robot.controller().message();
  if (outcome.failed_attempts > 0) outcome.message += " (" + robot.controller().why_failed() + ")";
  outcome.way = robot.way();
  return outcome;
}

}  // namespace coppice::robot::docking
