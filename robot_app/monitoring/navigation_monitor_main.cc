// coppice-navigation-monitor --config FILE: node /navigation_monitor. Judges navigation,
// localization and transforms in ROS time and reports every report_period of wall time.
#include <coppice_msgs/LocalizationState.h>
#include <coppice_msgs/NavigationState.h>
#include <ros/ros.h>

#include <optional>

#include "robot_app/monitoring/localization_monitor.h"
#include "robot_app/monitoring/monitor_program.h"
#include "robot_app/monitoring/navigation_monitor.h"
#include "robot_app/monitoring/tf_monitor.h"
#include "robot_app/monitoring/tf_sample.h"

namespace coppice::robot::monitoring {
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

LocalizationReading FromMessage(const coppice_msgs::LocalizationState& message) {
  return {static_cast<LocalizationReading::Phase>(message.phase), message.seconds_since_confirmed,
          message.score, message.deviation, message.message};
}

class Program {
 public:
  explicit Program(const MonitorStart& start)
      : navigation_(start.config.patience),
        localization_(start.config.patience),
        transforms_(start.config.patience),
        program_(start, {&navigation_, &localization_, &transforms_}) {
    program_.OnList([this](const WatchList& list) { Subscribe(list); });
    program_.ReportRegularly([this](const Times& now) { Look(now); });
  }

 private:
  void Subscribe(const WatchList& list) {
    program_.node().Subscribe<coppice_msgs::NavigationState>(
        navigation_subscriber_, list.navigation ? list.navigation->topic : "", kQueue,
        [this](const coppice_msgs::NavigationState& state) {
          navigation_.OnState(FromMessage(state), MonitorNode::Now());
        });
    program_.node().Subscribe<coppice_msgs::LocalizationState>(
        localization_subscriber_, list.localization ? list.localization->topic : "", kQueue,
        [this](const coppice_msgs::LocalizationState& state) {
          localization_.OnState(FromMessage(state), MonitorNode::Now());
        });
    if (list.transforms.empty()) tf_.reset();
    if (!list.transforms.empty() && !tf_) tf_.emplace(program_.node().handle());
  }

  void Look(const Times& now) {
    if (!tf_) return;
    std::vector<Expected<TransformSample>> samples;
    for (const auto& [parent, child] : transforms_.Pairs()) {
      samples.push_back(SampleOf(*tf_, parent, child));
    }
    transforms_.OnSamples(samples, now);
  }

  NavigationMonitor navigation_;
  LocalizationMonitor localization_;
  TfMonitor transforms_;
  MonitorProgram program_;
  ros::Subscriber navigation_subscriber_, localization_subscriber_;
  std::optional<Transforms> tf_;
};

}  // namespace
}  // namespace coppice::robot::monitoring

int main(int argc, char** argv) {
  namespace robot = coppice::robot;
  return robot::monitoring::RunMonitor<robot::monitoring::Program>(argc, argv, "navigation_monitor",
                                                                   std::chrono::milliseconds(100));
}
