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
#include "robot_app/monitoring/monitor_node.h"
#include "robot_app/monitoring/power/battery_monitor.h"
#include "robot_app/monitoring/power/charging_monitor.h"
#include "robot_app/monitoring/power/docking_monitor.h"
#include "robot_app/monitoring/power/emergency_stop_monitor.h"
#include "robot_app/monitoring/power/power_messages.h"
#include "robot_app/monitoring/tf_tree.h"

namespace coppice::robot {
namespace {

constexpr int kQueue = 20;

class Program {
 public:
  explicit Program(const MonitorStart& start)
      : battery_(start.config.patience),
        docking_(start.config.patience),
        emergency_stop_(start.config.patience),
        node_(start, [this](const WatchList& list) { Watch(list); }) {
    Subscribe();
    timer_ = node_.Every(start.config.report_period, [this] { Report(); });
  }

 private:
  void Watch(const WatchList& list) {
    battery_.Watch(list.battery);
    charging_.Watch(list.charging);
    docking_.Watch(list.docking);
    emergency_stop_.Watch(list.emergency_stop);
    battery_topic_ = list.battery ? list.battery->topic : "";
    dock_ = list.battery ? list.battery->dock : std::nullopt;
    if (dock_) way_ = WayHome(dock_->detour);
    docking_action_ = list.docking ? list.docking->action : "";
    stop_topic_ = list.emergency_stop ? list.emergency_stop->topic : "";
    if (timer_.isValid()) Subscribe();
  }

  void Subscribe() {
    node_.Subscribe<sensor_msgs::BatteryState>(battery_subscriber_, battery_topic_, kQueue,
                                               [this](const sensor_msgs::BatteryState& state) {
                                                 const Time now = MonitorNode::Now().ros;
                                                 const BatteryReading reading =
                                                     ToBatteryReading(state, now);
                                                 battery_.OnReading(reading, now);
                                                 charging_.OnReading(reading, now);
                                               });
    node_.Subscribe<actionlib_msgs::GoalStatusArray>(
        docking_subscriber_, TopicOf(docking_action_, "/status"), kQueue,
        [this](const actionlib_msgs::GoalStatusArray& goals) {
          docking_.OnGoals(FromMessage(goals), MonitorNode::Now());
        });
    node_.Subscribe<coppice_msgs::DockingActionFeedback>(
        progress_subscriber_, TopicOf(docking_action_, "/feedback"), kQueue,
        [this](const coppice_msgs::DockingActionFeedback& message) {
          docking_.OnProgress(message.status.goal_id.id, message.feedback.failed_attempts,
                              message.feedback.why_failed, MonitorNode::Now().ros);
        });
    node_.Subscribe<std_msgs::Bool>(stop_subscriber_, stop_topic_, kQueue,
                                    [this](const std_msgs::Bool& pressed) {
                                      emergency_stop_.OnState(pressed.data, MonitorNode::Now().ros);
                                    });
    node_.Subscribe<std_msgs::Float64>(way_subscriber_, dock_ ? dock_->way : "", kQueue,
                                       [this](const std_msgs::Float64& way) {
                                         way_.OnMeasured(way.data, MonitorNode::Now().wall);
                                       });
    if (!dock_) tf_.reset();
    if (dock_ && !tf_) tf_.emplace(node_.handle());
  }

  static std::string TopicOf(const std::string& action, const std::string& topic) {
    return action.empty() ? "" : action + topic;
  }

  void Report() {
    if (tf_) LookAtDistance();
    const Times now = MonitorNode::Now();
    std::vector<Finding> findings = battery_.Report(node_.processes(), now);
    const auto add = [&findings](std::vector<Finding> more) {
      for (Finding& finding : more) findings.push_back(std::move(finding));
    };
    add(charging_.Report(now.ros));
    add(docking_.Report(node_.processes(), now));
    add(emergency_stop_.Report(now));
    node_.Publish(std::move(findings));
  }

  // The last known distance stays: a robot that is lost is not at its station.
  void LookAtDistance() {
    const TransformSample robot = tf_->Look(dock_->map_frame, dock_->base_frame);
    if (!robot.found) return;
    const double straight = std::hypot(robot.x - dock_->x, robot.y - dock_->y);
    battery_.OnDistance(way_.Length(straight, MonitorNode::Now().wall));
  }

  BatteryMonitor battery_;
  ChargingMonitor charging_;
  DockingMonitor docking_;
  EmergencyStopMonitor emergency_stop_;
  std::string battery_topic_, docking_action_, stop_topic_;
  std::optional<DockPlace> dock_;
  WayHome way_;
  MonitorNode node_;
  ros::Subscriber battery_subscriber_, docking_subscriber_, progress_subscriber_, stop_subscriber_;
  ros::Subscriber way_subscriber_;
  std::optional<TfTree> tf_;
  ros::WallTimer timer_;
};

}  // namespace
}  // namespace coppice::robot

int main(int argc, char** argv) {
  const auto start = coppice::robot::StartMonitor(argc, argv, "power_monitor");
  if (!start) return 2;
  const coppice::robot::Program program(*start);
  coppice::robot::SpinInBatches(std::chrono::milliseconds(100));
  return 0;
}
