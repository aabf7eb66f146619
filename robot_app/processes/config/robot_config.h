// Which programs make up the robot: the file robot.yaml as values. docs/supervision.md is its
// manual.
#ifndef COPPICE_ROBOT_APP_PROCESSES_CONFIG_ROBOT_CONFIG_H_
#define COPPICE_ROBOT_APP_PROCESSES_CONFIG_ROBOT_CONFIG_H_

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/diagnostic.h"
#include "robot_app/processes/config/variables.h"

namespace coppice::robot::processes {

/// When a started process counts as ready for those that depend on it.
enum class Readiness {
  kNode,     ///< its node answers a ping
  kTopic,    ///< its node answers and publishes `ready_name`
  kService,  ///< its node answers and the service `ready_name` can be reached
  kNone,     ///< as soon as it is started
};

/// What happens when a process ends by itself (permanent, transient and temporary of Erlang/OTP).
enum class RestartRule {
  kAlways,     ///< it is started again
  kOnFailure,  ///< it is started again, unless its exit status was 0: then it has done its work
  kNever,      ///< it is not
};

/// A topic of any type on which a process shows that it works, not only that it is there.
struct HeartbeatConfig {
  std::string topic;
  Duration timeout = std::chrono::seconds(5);  ///< silent for longer: it has failed
};

struct ProcessConfig {
  std::string name;
  std::vector<std::string> command;  ///< program and arguments, variables filled in
  std::string node;                  ///< its ROS node, with slash; may be empty
  bool is_enabled = true;            ///< off: no configuration runs it, whichever names it
  std::size_t group = 0;
  std::optional<std::size_t> host;   ///< nothing: the supervisor's own
  std::vector<std::size_t> depends;  ///< indices of processes that must be ready before its start
  std::vector<std::size_t> after;    ///< as depends, but only if they run at all
  Readiness ready = Readiness::kNode;
  std::string ready_name;                             ///< of the topic or service
  Duration start_timeout = std::chrono::seconds(20);  ///< started but not ready: it has failed
  RestartRule restart = RestartRule::kAlways;
  std::optional<HeartbeatConfig> heartbeat;
  std::vector<std::string> state;  ///< its files and folders, deleted by a start from cleared state
  std::string log;                 ///< file name within the log folder
};

/// Which others of its group are restarted with a process (restart strategies of Erlang/OTP).
enum class Strategy {
  kOneForOne,   ///< none
  kRestForOne,  ///< those after it in the file
  kOneForAll,   ///< all
};

/// How often a group may be restarted (restart intensity of Erlang/OTP, with a memory: a restart
/// counts until it is older than the window *and* the group has been healthy since).
struct RestartLimits {
  int restarts = 3;
  Duration window = std::chrono::seconds(60);
  Duration floor = std::chrono::seconds(5);           ///< between two starts of a process
  Duration healthy_after = std::chrono::seconds(60);  ///< ready so long without a pause: healthy
  int hourly = 10;  ///< healthy in between or not: a crash loop that takes its time
};

/// The unit of restart: processes that share a strategy, a budget of restarts and dependencies.
struct GroupConfig {
  std::string name;
  Strategy strategy = Strategy::kOneForOne;
  RestartLimits limits;
  std::vector<std::size_t> depends;    ///< groups whose processes must be ready before its start
  std::vector<std::size_t> processes;  ///< in the order of the file
  bool essential = true;  ///< without it the robot stops; only for such a group the stack restarts
};

/// The first restart of a group is at once, then after `first`, twice that, ... `most`.
struct BackOff {
  Duration first = std::chrono::seconds(5);
  Duration most = std::chrono::seconds(300);
};

/// How many restarts there are on each step of the ladder above the group, and when it ends.
struct EscalationLimits {
  int closure = 1;  ///< of a group with all that depends on it, from a cleared state
  int stack = 1;    ///< of everything, with the ROS master
  Duration ask_within = std::chrono::seconds(540);  ///< of the first failure, whatever the step
};

/// Another computer.
struct HostConfig {
  std::string name;
  std::vector<std::string> command;  ///< runs there what is appended: [ssh, user@host, --]
  bool shell = true;                 ///< the words pass through a shell there, as those of ssh do
  std::string bin;                   ///< folder of Coppice's programs there
  std::string address;               ///< its IP address, as ROS_IP of its nodes; may be empty
};

/// Something that must be true for a configuration to be entered, known from a topic.
struct ConditionConfig {
  std::string name;
  std::string topic;
  /// Nothing: std_msgs/Bool. Else sensor_msgs/BatteryState with at least this current in A.
  std::optional<double> current;
  Duration lasting{0};                           ///< so long without a pause; ROS time
  Duration staleness = std::chrono::seconds(5);  ///< older than that is not known; ROS time
};

/// A set of processes that run together, as indices.
struct Configuration {
  std::string name;
  std::vector<std::size_t> processes;  ///< those that are enabled
  std::vector<std::size_t> requires_conditions;
};

/// A place of work: a building, a floor, a campus. Its name is the value of the variable `site`, so
/// all that is written with `${site}` in the file belongs to it: map, places, world, bands.
struct SiteConfig {
  std::string name;
  std::size_t configuration = 0;  ///< begun with there
};

/// What happens when a group is given up.
struct GivenUpConfig {
  std::vector<std::string> command;          ///< told to a person: the reason is appended
  std::optional<std::size_t> configuration;  ///< the robot's safe stop, if the group is essential
};

struct RobotConfig {
  std::vector<ProcessConfig> processes;
  std::vector<GroupConfig> groups;  ///< every process is in exactly one
  std::vector<Configuration> configurations;
  std::vector<HostConfig> hosts;
  std::vector<ConditionConfig> conditions;
  std::vector<SiteConfig> sites;                  ///< the table; may be empty: one without a name
  std::size_t site = 0;                           ///< whose values stand in all that follows
  std::string site_folder;                        ///< of what is learnt there; may be empty
  std::size_t initial = 0;                        ///< configuration that is in force at the start
  std::map<std::string, std::string> parameters;  ///< set on the ROS parameter server first
  BackOff back_off;
  EscalationLimits escalation;
  GivenUpConfig given_up;
  std::vector<std::string> switch_off;              ///< command that cuts the power; empty: none
  Duration stop_timeout = std::chrono::seconds(3);  ///< between SIGTERM and SIGKILL
};

/// Reads and checks a file. Everything that is wrong is reported at once; with errors the result is
/// not to be used. The variable `site` says which site it is read for; else it is the file's own
/// choice.
RobotConfig LoadRobotConfig(const std::string& path, const Variables& variables,
                            Diagnostics& diagnostics);

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_CONFIG_ROBOT_CONFIG_H_
