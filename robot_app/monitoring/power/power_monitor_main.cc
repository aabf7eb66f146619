// coppice-power-monitor --config FILE: node /power_monitor. Judges battery, charging, docking and
// the emergency stop in ROS time and reports every report_period of wall time.
#include <actionlib_msgs/GoalStatusArray.h>
#include <coppice_msgs/DockingActionFeedback.h>
#include <ros/ros.h>
#include <sensor_msgs/BatteryState.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>

#include <cmath>
#include <optional>

#include "bt_nodes/power/way_home.h"
#include "robot_app/common/battery_message.h"
#include "robot_app/monitoring/monitor_program.h"
#include "robot_app/monitoring/power/battery_monitor.h"
#include "robot_app/monitoring/power/charging_monitor.h"
#include "robot_app/monitoring/power/docking_monitor.h"
#include "robot_app/monitoring/power/emergency_stop_monitor.h"
#include "robot_app/monitoring/power/power_messages.h"
#include "robot_app/monitoring/tf_sample.h"

namespace coppice::robot::monitoring {
namespace {

constexpr int kQueue = 20;

class Program {
 public:
  explicit Program(const MonitorStart& start)
      : battery_(start.config.patience),
        docking_(start.config.patience),
        emergency_stop_(start.config.patience),
        program_(start, {&battery_, &charging_, &docking_, &emergency_stop_}) {
    program_.OnList([this](const WatchList& list) { Subscribe(list); });
    program_.ReportRegularly([this](const Times&) { LookAtDistance(); });
  }

 private:
  void Subscribe(const WatchList& list) {
    SubscribeBattery(list);
    const std::string action = list.docking ? list.docking->action : "";
    program_.node().Subscribe<actionlib_msgs::GoalStatusArray>(
        docking_subscriber_, action.empty() ? "" : action + "/status", kQueue,
        [this](const actionlib_msgs::GoalStatusArray& goals) {
          docking_.OnGoals(FromMessage(goals), MonitorNode::Now());
        });
    program_.node().Subscribe<coppice_msgs::DockingActionFeedback>(
        progress_subscriber_, action.empty() ? "" : action + "/feedback", kQueue,
        [this](const coppice_msgs::DockingActionFeedback& message) {
          docking_.OnProgress(message.status.goal_id.id, message.feedback.failed_attempts,
                              message.feedback.why_failed, MonitorNode::Now().ros);
        });
    program_.node().Subscribe<std_msgs::Bool>(
        stop_subscriber_, list.emergency_stop ? list.emergency_stop->topic : "", kQueue,
        [this](const std_msgs::Bool& pressed) {
          emergency_stop_.OnState(pressed.data, MonitorNode::Now());
        });
  }

  void SubscribeBattery(const WatchList& list) {
    program_.node().Subscribe<sensor_msgs::BatteryState>(
        battery_subscriber_, list.battery ? list.battery->topic : "", kQueue,
        [this](const sensor_msgs::BatteryState& state) {
          const Times now = MonitorNode::Now();
          const leaves::BatteryReading reading = ToBatteryReading(state, now.ros);
          battery_.OnReading(reading, now);
          charging_.OnReading(reading, now.ros);
        });
    dock_ = list.battery ? list.battery->dock : std::nullopt;
    if (dock_) way_ = leaves::WayHome(dock_->detour);
    program_.node().Subscribe<std_msgs::Float64>(
        way_subscriber_, dock_ ? dock_->way : "", kQueue, [this](const std_msgs::Float64& way) {
          way_.OnMeasured(way.data, MonitorNode::Now().wall);
        });
    if (!dock_) tf_.reset();
    if (dock_ && !tf_) tf_.emplace(program_.node().handle());
  }

  // The last known distance stays: a robot that is lost is not at its station.
  void LookAtDistance() {
    if (!tf_) return;
    const auto robot = SampleOf(*tf_, dock_->map_frame, dock_->base_frame);
    if (!robot) return;
    const double straight = std::hypot(robot->x - dock_->x, robot->y - dock_->y);
    battery_.OnDistance(way_.Length(straight, MonitorNode::Now().wall));
  }

  BatteryMonitor battery_;
  ChargingMonitor charging_;
  DockingMonitor docking_;
  EmergencyStopMonitor emergency_stop_;
  std::optional<DockPlace> dock_;
  leaves::WayHome way_;
  MonitorProgram program_;
  ros::Subscriber battery_subscriber_, docking_subscriber_, progress_subscriber_, stop_subscriber_;
  ros::Subscriber way_subscriber_;
  std::optional<Transforms> tf_;
};

}  // namespace
}  // namespace coppice::robot::monitoring

int main(int argc, char** argv) {
  namespace robot = coppice::robot;
  return robot::monitoring::RunMonitor<robot::monitoring::Program>(argc, argv, "power_monitor",
                                                                   std::chrono::milliseconds(100));
}
