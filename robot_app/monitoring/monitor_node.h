// What the monitors' programs have in common: the start, the active configuration, the reports.
//
// A monitor reports every report_period of wall time, so that readers notice a silent monitor just
// as fast when simulated time is slow, fast or stands still.
#ifndef COPPICE_ROBOT_APP_MONITORING_MONITOR_NODE_H_
#define COPPICE_ROBOT_APP_MONITORING_MONITOR_NODE_H_

#include <ros/node_handle.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/monitoring/monitor_config.h"
#include "robot_app/monitoring/process_table.h"

namespace coppice::robot {

/// Reads `--config FILE` and starts a ROS node of this name (ROS remappings work). On a problem
/// prints one line and returns nothing; the program is to end with status 2. SIGTERM and SIGINT end
/// ros::spin.
std::optional<MonitorConfig> StartMonitor(int argc, char** argv, const std::string& name);

/// For the thread that spins.
class MonitorNode {
 public:
  /// `on_list` is called at once and whenever another configuration comes into force.
  MonitorNode(const MonitorConfig& config, std::function<void(const WatchList&)> on_list);

  ros::NodeHandle& handle() { return handle_; }
  const ProcessTable& processes() const { return processes_; }
  static Times Now();

  /// To /monitoring/reports.
  void Publish(const std::vector<Finding>& findings);

 private:
  void OnProcesses(const ProcessTable& processes);

  const MonitorConfig& config_;
  std::function<void(const WatchList&)> on_list_;
  ros::NodeHandle handle_;
  ProcessTable processes_;
  std::string configuration_;
  ros::Publisher reports_;
  ros::Subscriber subscriber_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_MONITORING_MONITOR_NODE_H_
