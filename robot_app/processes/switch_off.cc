#include "robot_app/processes/switch_off.h"

#include <signal.h>
#include <unistd.h>

#include <iostream>
#include <optional>
#include <thread>

namespace coppice::robot::processes {

Expected<std::string> PowerDown::Ask(const std::string& reason, const std::string& token,
                                     Supervisor& supervisor, Time now) {
  Expected<std::string> stop = supervisor.SafeStop();
  if (!stop) return stop;
  if (!is_asked_ || !supervisor.configuration_switch().safe_stop()) asked_at_ = now;
  is_asked_ = true;
  const bool is_right = !token_.empty() && token == token_;
  is_allowed_ = is_allowed_ || (has_command_ && is_right);
  if (is_allowed_) return "safe stop, then the power goes off: " + reason;
  return "safe stop, and the power stays on, because " +
         std::string(has_command_ ? "the token is not COPPICE_SWITCH_OFF_TOKEN"
                                  : "robot.yaml names no command for switch_off") +
         ": " + reason;
}

bool PowerDown::TakeStop(const Supervisor& supervisor, Time now) {
  if (!is_asked_) return false;
  if (!supervisor.configuration_switch().safe_stop()) {  // a person has ended it
    is_asked_ = is_allowed_ = stands_ = false;
    return false;
  }
  if (stands_ || (supervisor.IsChanging() && now - asked_at_ < kPatience)) return false;
  stands_ = true;
  return true;
}

bool CutPower(const std::vector<std::string>& command, PosixLauncher& launcher, Duration patience) {
  sync();
  ProcessConfig config;
  config.name = "switch_off";
  config.log = "switch_off.log";
  config.command = command;
  const Expected<int> pid = launcher.Start(config);
  if (!pid) {
    std::cerr << "switch off: " << pid.problem() << "\n";
    return false;
  }
  const WallClock clock;
  const Time give_up = clock.Now() + patience;
  std::optional<int> status;
  while (!status && clock.Now() < give_up) {
    launcher.Reap([&](int ended, int wait_status) {
      if (ended == *pid) status = wait_status;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  if (status == 0) return true;
  if (!status) launcher.Signal(*pid, SIGKILL);
  std::cerr << "switch off: " << command.front()
            << (status ? " failed\n" : " has not ended, and was killed\n");
  return false;
}

}  // namespace coppice::robot::processes
