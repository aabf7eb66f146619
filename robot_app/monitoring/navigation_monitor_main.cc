// coppice-navigation-monitor --config FILE: node /navigation_monitor. Judges navigation,
// localization and transforms in ROS time and reports every report_period of wall time.
#include <coppice_msgs/LocalizationState.h>
#include <coppice_msgs/NavigationState.h>
#include <ros/ros.h>

#include <optional>

#include "robot_app/monitoring/localization_monitor.h"
#include "robot_app/monitoring/monitor_node.h"
#include "robot_app/monitoring/navigation_monitor.h"
#include "robot_app/monitoring/tf_monitor.h"
#include "robot_app/monitoring/tf_tree.h"

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

LocalizationReport FromMessage(const coppice_msgs::LocalizationState& message) {
  return {static_cast<LocalizationPhase>(message.phase), message.seconds_since_confirmed,
          message.score, message.deviation, message.message};
}

class Program {
 public:
  explicit Program(const MonitorStart& start)
      : navigation_(start.config.patience),
        localization_(start.config.patience),
        transforms_(start.config.patience),
        node_(start, [this](const WatchList& list) { Watch(list); }) {
    Subscribe();
    timer_ = node_.Every(start.config.report_period, [this] { Report(); });
  }

 private:
  void Watch(const WatchList& list) {
    navigation_.Watch(list.navigation);
    localization_.Watch(list.localization);
    transforms_.Watch(list.transforms);
    navigation_topic_ = list.navigation ? list.navigation->topic : "";
    localization_topic_ = list.localization ? list.localization->topic : "";
    if (timer_.isValid()) Subscribe();
  }

  void Subscribe() {
    node_.Subscribe<coppice_msgs::NavigationState>(
        navigation_subscriber_, navigation_topic_, kQueue,
        [this](const coppice_msgs::NavigationState& state) {
          navigation_.OnState(FromMessage(state), MonitorNode::Now());
        });
    node_.Subscribe<coppice_msgs::LocalizationState>(
        localization_subscriber_, localization_topic_, kQueue,
        [this](const coppice_msgs::LocalizationState& state) {
          localization_.OnState(FromMessage(state), MonitorNode::Now());
        });
    if (transforms_.Pairs().empty()) tf_.reset();
    if (!transforms_.Pairs().empty() && !tf_) tf_.emplace(node_.handle());
  }

  void Report() {
    const Times now = MonitorNode::Now();
    if (tf_) Look(now);
    std::vector<Finding> findings = navigation_.Report(node_.processes(), now);
    const auto add = [&findings](std::vector<Finding> more) {
      for (Finding& finding : more) findings.push_back(std::move(finding));
    };
    add(localization_.Report(node_.processes(), now));
    add(transforms_.Report(node_.processes(), now));
    node_.Publish(std::move(findings));
  }

  void Look(const Times& now) {
    std::vector<TransformSample> samples;
    for (const auto& [parent, child] : transforms_.Pairs()) {
      samples.push_back(tf_->Look(parent, child));
    }
    transforms_.OnSamples(samples, now);
  }

  NavigationMonitor navigation_;
  LocalizationMonitor localization_;
  TfMonitor transforms_;
  std::string navigation_topic_, localization_topic_;
  MonitorNode node_;
  ros::Subscriber navigation_subscriber_, localization_subscriber_;
  std::optional<TfTree> tf_;
  ros::WallTimer timer_;
};

}  // namespace
}  // namespace coppice::robot

int main(int argc, char** argv) {
  const auto start = coppice::robot::StartMonitor(argc, argv, "navigation_monitor");
  if (!start) return 2;
  const coppice::robot::Program program(*start);
  coppice::robot::SpinInBatches(std::chrono::milliseconds(100));
  return 0;
}
