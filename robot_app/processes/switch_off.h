// The robot's last step: it stops, what it knows is written to disk, and the power goes off. Asked
// for by the battery watchdog (trees/monitor/battery_watchdog.xml) by /supervisor/switch_off.
//
//   asked -> configuration for the safe stop -> disks are synced -> all programs end (so records
//   are closed) -> disks are synced -> the command of robot.yaml
//
// Without a command, or without the right token, it stays with the safe stop, which a person ends
// by `coppice processes reset all`.
#ifndef COPPICE_ROBOT_APP_PROCESSES_SWITCH_OFF_H_
#define COPPICE_ROBOT_APP_PROCESSES_SWITCH_OFF_H_

#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "robot_app/processes/launch/process_launcher.h"
#include "robot_app/processes/supervisor.h"

namespace coppice::robot::processes {

/// When. For one thread.
class PowerDown {
 public:
  /// The safe stop is waited for no longer than this.
  static constexpr Duration kPatience = std::chrono::seconds(30);

  /// `token`: who does not say it gets the safe stop only; empty: nobody may switch off.
  PowerDown(bool has_command, std::string token)
      : has_command_(has_command), token_(std::move(token)) {}

  /// Begins the safe stop. Refused if there is no configuration for it. Asked again, nothing begins
  /// anew; the right token then still counts.
  Expected<std::string> Ask(const std::string& reason, const std::string& token,
                            Supervisor& supervisor, Time now);

  /// True once: the robot stands, so what it has recorded should be on the disk.
  bool TakeStop(const Supervisor& supervisor, Time now);

  /// The robot stands, and the power may go off.
  bool may_cut() const { return stands_ && is_allowed_; }

 private:
  const bool has_command_;
  const std::string token_;
  bool is_asked_ = false;
  bool is_allowed_ = false;
  bool stands_ = false;
  Time asked_at_{};
};

/// Syncs the disks, runs the command and waits for its end. False, with a line on stderr, if it
/// cannot be started, fails, or has not ended within `patience`.
bool CutPower(const std::vector<std::string>& command, PosixLauncher& launcher, Duration patience);

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_SWITCH_OFF_H_
