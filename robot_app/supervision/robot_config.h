// Which programs make up the robot: the file robot.yaml as values.
#ifndef COPPICE_ROBOT_APP_SUPERVISION_ROBOT_CONFIG_H_
#define COPPICE_ROBOT_APP_SUPERVISION_ROBOT_CONFIG_H_

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/diagnostic.h"

namespace coppice::robot {

/// When a started process counts as ready for those that depend on it.
enum class Readiness {
  kNode,   ///< its node answers a ping
  kTopic,  ///< its node answers and publishes ready_topic
  kNone,   ///< as soon as it is started
};

/// Who decides that a process that ended by itself is started again.
enum class RestartRule {
  kByTree,     ///< the monitor tree, by the restart service; the supervisor only reports the end
  kOnFailure,  ///< the supervisor, after a back-off, unless the exit status was 0
  kAlways,     ///< the supervisor, after a back-off
};

struct ProcessConfig {
  std::string name;
  std::vector<std::string> command;  ///< program and arguments, variables filled in
  std::string node;                  ///< its ROS node, with slash; may be empty
  std::vector<std::size_t> depends;  ///< indices of processes that must be ready before its start
  std::vector<std::size_t> after;    ///< as depends, but only if they run at all
  Readiness ready = Readiness::kNode;
  std::string ready_topic;
  Duration start_timeout = std::chrono::seconds(20);  ///< started but not ready: it is ended
  RestartRule restart = RestartRule::kByTree;
  std::string log;  ///< file name within the log folder
};

/// No more than `restarts` within `window`; the next one is refused and the process given up
/// (intensity and period of Erlang/OTP supervisors).
struct RestartIntensity {
  int restarts = 3;
  Duration window = std::chrono::seconds(60);
};

/// For the rules other than kByTree: the first restart at once, then after `first`, twice that, ...
/// `most`.
struct BackOff {
  Duration first = std::chrono::seconds(1);
  Duration most = std::chrono::seconds(30);
};

/// A set of processes that run together, as indices.
struct Configuration {
  std::string name;
  std::vector<std::size_t> processes;
};

struct RobotConfig {
  std::vector<ProcessConfig> processes;
  std::vector<Configuration> configurations;
  std::size_t initial = 0;                        ///< configuration that is in force at the start
  std::map<std::string, std::string> parameters;  ///< set on the ROS parameter server first
  RestartIntensity intensity;
  BackOff back_off;
  Duration stop_timeout = std::chrono::seconds(3);  ///< between SIGTERM and SIGKILL
};

/// Values of `${name}` in commands. `${name:-default}` stands for the default if there is none; the
/// default may contain variables.
using Variables = std::map<std::string, std::string>;

/// Reads and checks a file. Everything that is wrong is reported at once; with errors the result is
/// not to be used.
RobotConfig LoadRobotConfig(const std::string& path, const Variables& variables,
                            Diagnostics& diagnostics);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_SUPERVISION_ROBOT_CONFIG_H_
