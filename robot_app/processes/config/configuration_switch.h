// Which configuration is wanted, and who may change that.
//
// Three hands reach for it, the stronger one wins: the safe stop (a group was given up; only a
// reset ends it), a person (held until it is released), the trees.
#ifndef COPPICE_ROBOT_APP_PROCESSES_CONFIG_CONFIGURATION_SWITCH_H_
#define COPPICE_ROBOT_APP_PROCESSES_CONFIG_CONFIGURATION_SWITCH_H_

#include <functional>
#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/processes/config/robot_config.h"

namespace coppice::robot::processes {

enum class Hand { kTree, kPerson };

/// Whether a condition holds, or why not.
using CheckCondition = std::function<Outcome(std::size_t condition)>;

class ConfigurationSwitch {
 public:
  /// The configuration must outlive it.
  explicit ConfigurationSwitch(const RobotConfig& config)
      : config_(config), current_(config.initial), before_(config.initial) {}

  /// Refused if it is unknown, one of its conditions does not hold, or a stronger hand has it.
  /// Returns what is done, for people.
  Expected<std::string> Request(const std::string& name, Hand hand, const CheckCondition& check);

  /// The person lets go; the trees decide again. Returns what is done, for people.
  std::string Release();

  /// To the configuration for the safe stop, if there is one.
  void SafeStop();
  /// Back to what was wanted before the safe stop.
  void EndSafeStop();

  std::size_t current() const { return current_; }
  /// What is wanted apart from the safe stop.
  std::size_t before_safe_stop() const { return safe_stop_ ? before_ : current_; }
  bool manual() const { return manual_; }
  bool safe_stop() const { return safe_stop_; }

  /// Takes up what an earlier supervisor has left.
  void Restore(std::size_t configuration, bool manual, bool safe_stop);

 private:
  const RobotConfig& config_;
  std::size_t current_;
  std::size_t before_;
  bool manual_ = false;
  bool safe_stop_ = false;
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_CONFIG_CONFIGURATION_SWITCH_H_
