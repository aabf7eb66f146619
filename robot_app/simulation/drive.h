// The differential drive: from velocity commands to the velocity that the wheels really try to
// hold.
#ifndef COPPICE_ROBOT_APP_SIMULATION_DRIVE_H_
#define COPPICE_ROBOT_APP_SIMULATION_DRIVE_H_

#include <limits>

namespace coppice::robot::simulation {

/// Of base_link, in its own frame: forward (m/s) and counter-clockwise (rad/s).
struct Velocity {
  double linear = 0;
  double angular = 0;
};

struct DriveOptions {
  double max_linear = 0.9;            ///< m/s
  double max_angular = 1.2;           ///< rad/s
  double linear_acceleration = 0.6;   ///< m/s^2
  double angular_acceleration = 1.5;  ///< rad/s^2
  double command_timeout = 0.5;       ///< s; without a newer command the robot stops
  double protective_distance = 0.05;  ///< m; nothing may come nearer to the front
  double protective_braking = 3.0;    ///< m/s^2
};

class Drive {
 public:
  explicit Drive(const DriveOptions& options = {}) : options_(options) {}

  /// Takes a command at `time` seconds. A value that is not finite counts as 0.
  void Command(double time, const Velocity& command);

  /// The velocity for the next `dt` seconds after `time`, from the velocity that the robot really
  /// has (a bump takes it away). `front_gap` is the free way in front of the footprint in metres,
  /// `powered` is false when the battery is empty.
  Velocity Next(double time, double dt, const Velocity& actual, double front_gap, bool powered);

  /// True if the low-level safety stop held the robot back in the last Next(). It is independent of
  /// the commands: the protective field grows with the speed by the braking distance, as in ISO
  /// 13855.
  bool protective_stop() const { return protective_stop_; }

  /// The free way that the robot needs ahead at a forward speed in order not to be stopped, in
  /// metres.
  double ProtectiveField(double speed) const;

  const DriveOptions& options() const { return options_; }

 private:
  DriveOptions options_;
  Velocity command_;
  double command_time_ = -std::numeric_limits<double>::infinity();
  bool protective_stop_ = false;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_DRIVE_H_
