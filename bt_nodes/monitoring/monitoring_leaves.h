// Leaves of the monitor tree: take in what the monitors report, and ask what is wrong.
#ifndef COPPICE_BT_NODES_MONITORING_MONITORING_LEAVES_H_
#define COPPICE_BT_NODES_MONITORING_MONITORING_LEAVES_H_

#include <string>

#include "bt_core/nodes/leaf.h"
#include "bt_nodes/monitoring/health.h"

namespace coppice::leaves {

/// The second step of every tick of the monitor tree: with reports too old to act on it fails, so
/// that nothing is repaired blindly.
class ReadHealth : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Takes in the aggregated reports of the monitors; fails if they are too old to act on.";
  Input<Health> monitoring{this, "monitoring", "newest aggregated report, fed from outside",
                           kOptional};
  Input<double> max_age{this, "max_age", "oldest report to act on [s]", 10.0};
  Output<Health> health{this, "health", "the report, if it is fresh"};
  Output<int> errors{this, "errors", "number of entries that are errors or stale"};
  Status Run() override;

 private:
  std::uint32_t seen_ = 0;  // writes of the input that were passed on
};

/// Common to the fault conditions: is some entry of one kind of monitor an error?
class FaultCondition : public Condition {
 public:
  Input<Health> health{this, "health", "from ReadHealth"};
  Output<std::string> subject{this, "subject", "what has the fault"};
  Output<std::string> node{this, "node", "ROS node to restart"};
  bool Check() override;

 protected:
  /// `also_stale`: a monitor of that kind that has fallen silent counts as a fault.
  explicit FaultCondition(const char* monitor, bool also_stale = true)
      : monitor_(monitor), also_stale_(also_stale) {}

 private:
  const char* monitor_;
  bool also_stale_;
};

class NodeFault : public FaultCondition {
 public:
  static constexpr const char* kDescription = "Does some ROS node not answer?";
  NodeFault() : FaultCondition("node") {}
};

class TopicFault : public FaultCondition {
 public:
  static constexpr const char* kDescription = "Is the rate of some topic outside of its band?";
  TopicFault() : FaultCondition("topic") {}
};

class LoggerFault : public FaultCondition {
 public:
  static constexpr const char* kDescription = "Does something that should be recorded not grow?";
  LoggerFault() : FaultCondition("logger") {}
};

class NavigationFault : public FaultCondition {
 public:
  static constexpr const char* kDescription =
      "Is there no path, and have the navigation's own recoveries failed?";
  NavigationFault() : FaultCondition("navigation") {}
};

class LocalizationFault : public FaultCondition {
 public:
  static constexpr const char* kDescription = "Is the robot's position on the map lost?";
  LocalizationFault() : FaultCondition("localization") {}
};

class DockingFault : public FaultCondition {
 public:
  static constexpr const char* kDescription = "Has the robot failed to reach its station?";
  DockingFault() : FaultCondition("docking") {}
};

class ChargingFault : public FaultCondition {
 public:
  static constexpr const char* kDescription =
      "Does the robot stand on the station without current?";
  ChargingFault() : FaultCondition("charging") {}
};

class EmergencyStopFault : public FaultCondition {
 public:
  static constexpr const char* kDescription = "Is the emergency stop pressed?";
  EmergencyStopFault() : FaultCondition("emergency_stop", false) {}
};

class SupervisorFault : public FaultCondition {
 public:
  static constexpr const char* kDescription =
      "Is the process supervisor silent, so that nothing that ends is started again?";
  SupervisorFault() : FaultCondition("supervisor", false) {}
};

/// For recoveries that need a program: without it they would be used up in vain.
class NodeIsWell : public Condition {
 public:
  static constexpr const char* kDescription = "Does no monitor blame that ROS node?";
  Input<Health> health{this, "health", "from ReadHealth"};
  Input<std::string> node{this, "node", "name of the ROS node"};
  Input<std::string> kinds{this, "kinds", "monitors that blame nodes", "node;topic"};
  bool Check() override;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_MONITORING_MONITORING_LEAVES_H_
