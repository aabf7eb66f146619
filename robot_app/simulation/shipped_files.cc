#include "robot_app/simulation/shipped_files.h"

#include "robot_app/common/shipped.h"

namespace coppice::robot::simulation {
namespace {

template <typename Options>
Outcome MountAs(const RobotDescription& robot, const char* frame, Options& options) {
  const Expected<Mount> mount = robot.MountOf(frame);
  if (!mount) return Problem{mount.problem()};
  options.mounting = {mount->pose.x, mount->pose.y, mount->pose.yaw};
  options.height = mount->height;
  return {};
}

}  // namespace

Expected<Floor> FindFloor(const std::string& name) {
  Diagnostics diagnostics;
  const auto floor = LoadFloor(name == kInstitute ? Shipped(COPPICE_FLOOR) : name, diagnostics);
  if (!floor) return Problem{ToString(diagnostics.all().front())};
  return *floor;
}

Expected<RobotDescription> FindRobot(const std::string& name) {
  return RobotDescription::Load(name == kSobi ? Shipped(COPPICE_ROBOT) : name);
}

Outcome Apply(const RobotDescription& robot, WorldOptions& options) {
  options.radius = robot.radius();
  options.odometry.track = robot.track();
  options.odometry.wheel_diameter = robot.wheel_diameter();
  if (Outcome laser = MountAs(robot, "laser", options.lidar); !laser) return laser;
  for (std::size_t i = 0; i < kSonars.size(); ++i) {
    const std::string frame = std::string("sonar_") + kSonars[i];
    if (Outcome sonar = MountAs(robot, frame.c_str(), options.sonars[i]); !sonar) return sonar;
  }
  return MountAs(robot, "velodyne", options.lidar_3d);
}

}  // namespace coppice::robot::simulation
