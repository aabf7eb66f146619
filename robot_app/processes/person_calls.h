// Tells a person what the supervisor has given up, by running a command of the configuration file
// with the message as its last argument. Tried again when it fails.
#ifndef COPPICE_ROBOT_APP_PROCESSES_PERSON_CALLS_H_
#define COPPICE_ROBOT_APP_PROCESSES_PERSON_CALLS_H_

#include <deque>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "robot_app/processes/launch/process_launcher.h"

namespace coppice::robot::processes {

/// One call at a time, in order. For one thread.
class PersonCalls {
 public:
  static constexpr Duration kPause = std::chrono::seconds(30);  ///< after a call that failed
  static constexpr int kTries = 10;                             ///< then the message is dropped

  /// The launcher must outlive it. Without a command nothing is done.
  PersonCalls(std::vector<std::string> command, ProcessLauncher& launcher);

  void Add(std::string message);
  void Step(Time now);
  /// Ignores pids that are not its own.
  void OnExit(int pid, int wait_status, Time now);

  /// Nothing is left to be told.
  bool idle() const { return messages_.empty(); }

 private:
  void Failed(Time now);

  std::vector<std::string> command_;
  ProcessLauncher& launcher_;
  std::deque<std::string> messages_;
  int pid_ = 0;
  int tries_ = 0;
  Time not_before_{};
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_PERSON_CALLS_H_
