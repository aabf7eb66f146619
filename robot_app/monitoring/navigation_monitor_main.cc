// coppice-navigation-monitor --config FILE: node /navigation_monitor. Judges the states of the
// navigation server in ROS time and reports every report_period of wall time.
#include <coppice_msgs/NavigationState.h>
#include <ros/ros.h>

#include "robot_app/monitoring/monitor_node.h"
#include "robot_app/monitoring/navigation_monitor.h"

namespace coppice::robot {
namespace {

constexpr int kQueue = 20;

NavigationReport FromMessage(const coppice_msgs::NavigationState& message) {
  NavigationReport report;
  report.phase = static_cast<NavigationPhase>(message.state);
  report.in_phase =
      std::chrono::duration_cast<Duration>(std::chrono::duration<double>(message.seconds_in_state));
  report.consecutive_failures = message.consecutive_failures;
  report.message = message.message;
  return report;
}

class Program {
 public:
  explicit Program(const MonitorStart& start)
      : monitor_(start.config.patience),
        node_(start, [this](const WatchList& list) { Watch(list.navigation); }) {
    Subscribe();
    timer_ = node_.Every(start.config.report_period, [this] {
      node_.Publish(monitor_.Report(node_.processes(), MonitorNode::Now()));
    });
  }

 private:
  void Watch(const std::optional<NavigationWatch>& watch) {
    monitor_.Watch(watch);
    topic_ = watch ? watch->topic : "";
    if (timer_.isValid()) Subscribe();
  }

  void Subscribe() {
    if (topic_ == subscriber_.getTopic()) return;
    subscriber_.shutdown();
    if (topic_.empty()) return;
    subscriber_ = node_.handle().subscribe<coppice_msgs::NavigationState>(
        topic_, kQueue, [this](const coppice_msgs::NavigationState::ConstPtr& message) {
          monitor_.OnState(FromMessage(*message), MonitorNode::Now().ros);
        });
  }

  NavigationMonitor monitor_;
  std::string topic_;
  MonitorNode node_;
  ros::Subscriber subscriber_;
  ros::WallTimer timer_;
};

}  // namespace
}  // namespace coppice::robot

int main(int argc, char** argv) {
  const auto start = coppice::robot::StartMonitor(argc, argv, "navigation_monitor");
  if (!start) return 2;
  const coppice::robot::Program program(*start);
  ros::spin();
  return 0;
}
