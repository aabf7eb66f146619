// Whether what a configuration requires is true: judges the values of a topic. A charger that only
// touches is no charger, so a value may have to last.
#ifndef COPPICE_ROBOT_APP_PROCESSES_CONFIG_CONDITIONS_H_
#define COPPICE_ROBOT_APP_PROCESSES_CONFIG_CONDITIONS_H_

#include <optional>
#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/processes/config/robot_config.h"

namespace coppice::robot::processes {

/// One condition of the configuration file. Times are ROS time. For one thread.
class TopicCondition {
 public:
  explicit TopicCondition(ConditionConfig config) : config_(std::move(config)) {}

  /// A value of its topic: a current in A, or 0 and 1.
  void Observe(double value, Time now);

  /// Whether it holds.
  Outcome Check(Time now) const;

  const ConditionConfig& config() const { return config_; }

 private:
  bool Holds(double value) const { return value >= config_.current.value_or(1); }

  ConditionConfig config_;
  double value_ = 0;
  std::optional<Time> heard_at_, holds_since_;
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_CONFIG_CONDITIONS_H_
