#include "robot_app/processes/person_calls.h"

#include <utility>

namespace coppice::robot::processes {

PersonCalls::PersonCalls(std::vector<std::string> command, ProcessLauncher& launcher)
    : command_(std::move(command)), launcher_(launcher) {}

void PersonCalls::Add(std::string message) {
  if (!command_.empty()) messages_.push_back(std::move(message));
}

void PersonCalls::Step(Time now) {
  if (messages_.empty() || pid_ != 0 || now < not_before_) return;
  ProcessConfig config;
  config.name = "on_given_up";
  config.log = "on_given_up.log";
  config.command = command_;
  config.command.push_back(messages_.front());
  ++tries_;
  const Expected<int> pid = launcher_.Start(config);
  if (!pid) return Failed(now);
  pid_ = *pid;
}

void PersonCalls::OnExit(int pid, int wait_status, Time now) {
  if (pid == 0 || pid != pid_) return;
  pid_ = 0;
  if (wait_status != 0) return Failed(now);
  messages_.pop_front();
  tries_ = 0;
}

void PersonCalls::Failed(Time now) {
  not_before_ = now + kPause;
  if (tries_ < kTries) return;
  messages_.pop_front();
  tries_ = 0;
}

}  // namespace coppice::robot::processes
