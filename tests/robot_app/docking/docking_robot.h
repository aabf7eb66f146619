// The simulated robot that docks, without ROS and without delay: the laser, the odometry filter,
// the localization with its errors, and what /docking makes of them.
#ifndef COPPICE_TESTS_ROBOT_APP_DOCKING_DOCKING_ROBOT_H_
#define COPPICE_TESTS_ROBOT_APP_DOCKING_DOCKING_ROBOT_H_

#include <vector>

#include "robot_app/docking/dock_controller.h"
#include "tests/robot_app/localization/localized_robot.h"

namespace coppice::robot::docking {

inline Pose2D ToPose2D(const simulation::Pose2& pose) { return {pose.x, pose.y, pose.yaw}; }

class DockingRobot {
 public:
  /// It expects its station where the floor has it, and believes that it stands at the start of the
  /// options, or at `believed`.
  DockingRobot(const simulation::Floor& floor, const simulation::WorldOptions& options,
               const std::optional<Pose2D>& believed = std::nullopt)
      : robot_(floor, options), prior_(ToPose2D(floor.docked)) {
    const Pose2D start = ToPose2D(options.start.value_or(floor.docked));
    robot_.localizer().SetPose(believed.value_or(start), 0.1, 0.1);
  }

  void Stand(double seconds) {
    for (const double stop = world().time() + seconds; world().time() < stop;) Step({});
  }

  /// Until the manoeuvre has ended, at most for so long [s]. False if it has not.
  bool Run(double seconds) {
    for (const double stop = world().time() + seconds; controller_.active();) {
      if (world().time() >= stop) return false;
      const Velocity2D velocity = controller_.Update(Input());
      Step(velocity);
      Step(velocity);
    }
    return true;
  }

  DockInput Input() {
    DockInput input;
    input.now = world().time();
    input.pose = robot_.filter().pose();
    input.current = world().battery().current();
    input.docked = world().docked();
    input.full = world().battery().full();
    input.obstacles = PointsInBase(navigation::ScanOf(world()), 3);
    input.seen = tracker_.seen();
    input.expected = Expected();
    return input;
  }

  simulation::World& world() { return robot_.world(); }
  DockController& controller() { return controller_; }
  const StationTracker& tracker() const { return tracker_; }
  /// Where base_link truly was, every 0.1 s.
  const std::vector<Pose2D>& way() const { return way_; }

 private:
  // In the frame of the odometry.
  Pose2D Expected() { return RelativeTo(robot_.localizer().odom_in_map(), prior_); }

  void Step(const Velocity2D& velocity) {
    robot_.Step(velocity);
    if (world().scan().time == scan_time_ || !robot_.filter().started()) return;
    scan_time_ = world().scan().time;
    tracker_.AddScan(navigation::ScanOf(world()), robot_.filter().pose(), Expected());
    way_.push_back(robot_.Truth());
  }

  localization::LocalizedRobot robot_;
  Pose2D prior_;  // base_link when docked, in the map
  StationTracker tracker_;
  DockController controller_;
  double scan_time_ = -1;
  std::vector<Pose2D> way_;
};

}  // namespace coppice::robot::docking

#endif  // COPPICE_TESTS_ROBOT_APP_DOCKING_DOCKING_ROBOT_H_
