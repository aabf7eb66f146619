// The whole robot as its users start it, by coppice-supervisor on a ROS master of its own, for a
// test that breaks it. A test waits for what it expects, with a deadline, and never for a time.
#ifndef COPPICE_TESTS_SYSTEM_ROBOT_RIG_H_
#define COPPICE_TESTS_SYSTEM_ROBOT_RIG_H_

#include <ros/ros.h>

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "robot_app/common/child_process.h"
#include "tests/system/robot_state.h"

namespace coppice::robot {

/// One piece of a configuration file to be replaced.
struct ConfigEdit {
  std::string file;  ///< robot.yaml, monitors.yaml, ...
  std::string from;  ///< must be there
  std::string to;
};

struct RigOptions {
  std::string name;   ///< of the folder of the run, below build/tests/system
  std::string start;  ///< "X Y YAW" where it begins, frame map; empty: on the station
  /// Variables of robot.yaml: speed, seed, stops, ...
  std::vector<std::pair<std::string, std::string>> variables;
  std::vector<ConfigEdit> edits;
  /// Programs of the robot that are replaced by others: name in build/bin, path.
  std::vector<std::pair<std::string, std::string>> programs;
  std::vector<std::pair<std::string, std::string>> environment;
  std::string address = "127.0.0.1";  ///< of this computer, for programs on another one
};

class RobotRig {
 public:
  explicit RobotRig(RigOptions options);
  /// Ends all. The folder of the run stays if a test has failed.
  ~RobotRig();

  /// Starts the robot and waits until it is nominal. False with a failure of the test otherwise.
  bool Start();
  /// Ends all, and expects that nothing is left behind.
  void Stop();

  /// Runs `look` on the state under its lock.
  template <class Look>
  auto With(Look look) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return look(state_);
  }
  Instant Now() const;

  /// Waits until it holds, at most that long in real time; false otherwise.
  bool WaitFor(const std::function<bool(const RobotState&)>& condition, double seconds);

  /// Waits until the robot has been nominal for `hold` seconds of ROS time without a break, counted
  /// from now at the earliest; a new ROS master begins to count anew. Tells since when; a failure
  /// of the test and nothing if it does not.
  std::optional<Instant> WaitUntilNominal(double seconds, double hold = 2);

  /// /simulation/inject_fault. A fault that is refused because somebody stands in the way is tried
  /// again for some seconds. False with a failure of the test if it was refused.
  bool Inject(const std::string& fault, const std::string& target = "", double value = 0,
              double duration = 0);

  /// Sends a signal to a process of the robot. False with a failure of the test if it does not run.
  bool Signal(const std::string& process, int signal);

  /// Writes a line into the record of the run.
  void Note(const std::string& text);

  /// The record of the run from that moment on, for people.
  std::string TimelineSince(const Instant& since) const;

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path config() const { return folder_ / "robot_app/config"; }
  std::filesystem::path log(const std::string& process) const;
  /// What the programs have written into that log until now.
  std::string Logged(const std::string& process) const;
  int supervisor_pid() const { return supervisor_.pid(); }

 private:
  void LayOutFolder();
  void LinkPrograms();
  std::vector<std::string> Command() const;
  bool Join();
  void Subscribe();
  void FollowMaster();
  template <class Message>
  void Watch(const std::string& topic, std::function<void(const Message&, const Instant&)> update);
  void EndWhatIsLeft();

  RigOptions options_;
  std::filesystem::path folder_;
  ChildProcess supervisor_;
  std::unique_ptr<ros::NodeHandle> node_;
  std::unique_ptr<ros::AsyncSpinner> spinner_;
  std::vector<ros::Subscriber> subscribers_;
  int master_pid_ = 0;  // the one that knows our subscriptions
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  RobotState state_;
  std::set<int> pids_;  // of all processes that were ever heard of
};

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_SYSTEM_ROBOT_RIG_H_
