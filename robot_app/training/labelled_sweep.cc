#include "robot_app/training/labelled_sweep.h"

#include <cmath>

#include "robot_app/training/draw.h"
#include "robot_app/training/placed_people.h"

namespace coppice::robot::training {
namespace {

using simulation::Disc;
using simulation::kPi;
using simulation::Pose2;
using simulation::Vec2;

constexpr double kAround = 6;  // of the robot stand chairs and tables [m]

void AddFourLegged(const Site& site, Vec2 robot, std::mt19937_64& random,
                   std::vector<Disc>& discs) {
  const bool is_chair = random() % 2 == 0;
  const Vec2 half = is_chair ? Vec2{Draw(random, 0.17, 0.25), Draw(random, 0.17, 0.25)}
                             : Vec2{Draw(random, 0.4, 0.9), Draw(random, 0.3, 0.45)};
  const Vec2 at = robot + Vec2{Draw(random, -kAround, kAround), Draw(random, -kAround, kAround)};
  const double yaw = Draw(random, -kPi, kPi);
  const double radius = Draw(random, 0.01, 0.035);
  if (!IsFree(site, at, 0.3) || simulation::Length(at - robot) < 1) return;
  for (const Vec2 corner : {half, Vec2{half.x, -half.y}, Vec2{-half.x, half.y}, half * -1}) {
    discs.push_back({at + simulation::Rotated(corner, yaw), radius});
  }
}

// Who is met and how far that is, if nobody were before.
double CastAtLegs(const std::vector<Disc>& legs, Vec2 origin, Vec2 direction, double range) {
  for (const Disc& leg : legs) range = CastAtDisc(leg, origin, direction, range);
  return range;
}

}  // namespace

LaserScan ToLaserScan(const simulation::Lidar& laser) {
  const simulation::LidarOptions& options = laser.options();
  LaserScan scan;
  scan.stamp = laser.scan().time;
  scan.mount = {options.mounting.x, options.mounting.y, options.mounting.yaw};
  scan.angle_min = laser.scan().angle_min;
  scan.angle_increment = laser.scan().angle_step;
  scan.range_min = options.min_range;
  scan.range_max = options.max_range;
  scan.ranges = laser.scan().ranges;
  return scan;
}

LabelledSweep MakeLabelledSweep(const Site& site, const SweepOptions& options,
                                std::mt19937_64& random) {
  const PlacedPeople placed = PlacePeople(site, random);
  std::vector<Disc> things;
  const std::uint64_t furniture = random() % (options.most_four_legged + 1);
  for (std::uint64_t i = 0; i < furniture; ++i) {
    AddFourLegged(site, placed.robot.position(), random, things);
  }
  std::vector<std::vector<Disc>> legs;
  std::vector<Disc> discs = things;
  for (const simulation::Figure& figure : FiguresOf(placed)) {
    legs.push_back(simulation::SlicesAt(options.laser.height, {figure}));
    discs.insert(discs.end(), legs.back().begin(), legs.back().end());
  }
  const simulation::RayCaster still(EdgesFrom(options.laser.height, site.still));
  simulation::Lidar device(options.laser, random());
  device.Measure(0, placed.robot, still, discs);

  LabelledSweep sweep{ToLaserScan(device), {}, {}};
  const Pose2 laser = Compose(placed.robot, options.laser.mounting);
  std::vector<int> alone(legs.size(), 0), seen(legs.size(), 0);
  for (int beam = 0; beam < options.laser.beams; ++beam) {
    const double angle = laser.yaw + sweep.scan.angle_min + beam * sweep.scan.angle_increment;
    const Vec2 direction = simulation::Direction(angle);
    double nearest = still.Cast(laser.position(), direction, options.laser.max_range);
    nearest = CastAtLegs(things, laser.position(), direction, nearest);
    int owner = LabelledSweep::kNobody;
    for (std::size_t i = 0; i < legs.size(); ++i) {
      const double range =
          CastAtLegs(legs[i], laser.position(), direction, options.laser.max_range);
      if (range < options.laser.max_range) ++alone[i];
      if (range >= nearest) continue;
      nearest = range;
      owner = static_cast<int>(i);
    }
    sweep.owner.push_back(owner);
    if (owner != LabelledSweep::kNobody) ++seen[owner];
  }
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Vec2 at = placed.people[i].stance.position;
    sweep.people.push_back({Compose(Inverse(laser), {at.x, at.y, 0}).position(),
                            alone[i] > 0 ? static_cast<double>(seen[i]) / alone[i] : 0,
                            placed.people[i].in_group});
  }
  return sweep;
}

}  // namespace coppice::robot::training
