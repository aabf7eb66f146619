// What depends on what, worked out once from the configuration: between processes for starting and
// ending, between groups for the escalation.
//
// A group depends on those that it names and on the groups of the processes that its processes
// depend on. There are no circles; LoadRobotConfig reports them.
#ifndef COPPICE_ROBOT_APP_PROCESSES_CONFIG_GROUP_ORDER_H_
#define COPPICE_ROBOT_APP_PROCESSES_CONFIG_GROUP_ORDER_H_

#include <cstddef>
#include <vector>

#include "robot_app/processes/config/robot_config.h"

namespace coppice::robot::processes {

using Indices = std::vector<std::size_t>;

bool Contains(const Indices& list, std::size_t wanted);

class GroupOrder {
 public:
  explicit GroupOrder(const RobotConfig& config);

  /// Processes that must be ready before this one starts, as far as they are wanted at all: those
  /// that it names and those of the groups that its group names.
  const Indices& needs(std::size_t process) const { return needs_[process]; }

  /// Groups that this group depends on, directly or through others, and itself; dependencies first.
  const Indices& upstream(std::size_t group) const { return upstream_[group]; }

  /// The dependency closure: this group and all that depend on it, directly or through others;
  /// dependencies first.
  const Indices& closure(std::size_t group) const { return closure_[group]; }

  /// The processes of those groups.
  Indices Members(const Indices& groups) const;

  /// What the strategy of its group restarts with a process, and itself, in the order of starting.
  Indices RestartedWith(std::size_t process) const;

  /// Groups that wait for themselves.
  const Indices& circular() const { return circular_; }

 private:
  const RobotConfig& config_;
  std::vector<Indices> needs_;
  std::vector<Indices> upstream_, closure_;
  Indices circular_;
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_CONFIG_GROUP_ORDER_H_
