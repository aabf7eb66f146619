// coppice-health-aggregator --config FILE: node /health_aggregator. Reads /monitoring/reports and
// publishes /monitoring (coppice_msgs/Health, latched): every publish_period of wall time, and at
// once when a level changes; the same on /diagnostics every diagnostics_period.
#include <coppice_msgs/Health.h>
#include <ros/ros.h>

#include "robot_app/monitoring/aggregator/diagnostics_messages.h"
#include "robot_app/monitoring/aggregator/health_aggregator.h"
#include "robot_app/monitoring/aggregator/health_messages.h"
#include "robot_app/monitoring/monitor_node.h"

namespace coppice::robot::monitoring {
namespace {

constexpr int kQueue = 100;

class Program {
 public:
  explicit Program(const MonitorStart& start)
      : aggregator_(start.config.hold, start.config.silent_periods),
        node_(start, [this](const WatchList& list) {
          aggregator_.Expect(list.sources, MonitorNode::Now().wall);
        }) {
    health_ = node_.handle().advertise<coppice_msgs::Health>("/monitoring", kQueue, true);
    reports_ = node_.handle().subscribe<coppice_msgs::Health>(
        "/monitoring/reports", kQueue,
        [this](const coppice_msgs::Health::ConstPtr& message) { OnReport(*message); });
    timer_ = node_.Every(start.config.publish_period, [this] {
      const Times now = MonitorNode::Now();
      aggregator_.CheckSilence(node_.processes(), now.wall, now.ros);
      Publish();
    });
    if (start.config.diagnostics_period == Duration::zero()) return;
    diagnostics_ =
        node_.handle().advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", kQueue);
    diagnostics_timer_ = node_.Every(start.config.diagnostics_period, [this] {
      if (diagnostics_.getNumSubscribers() > 0) diagnostics_.publish(ToDiagnostics(published_));
    });
  }

 private:
  void OnReport(const coppice_msgs::Health& message) {
    if (aggregator_.OnReport(message.source, FromMessage(message), MonitorNode::Now().wall)) {
      Publish();
    }
  }

  void Publish() {
    const Times now = MonitorNode::Now();
    published_ = aggregator_.Publish(now.wall, now.ros);
    for (Finding& finding : published_) {
      if (finding.host.empty()) finding.host = node_.host();
    }
    health_.publish(ToMessage(ros::this_node::getName(), published_));
  }

  HealthAggregator aggregator_;
  std::vector<Finding> published_;
  MonitorNode node_;
  ros::Publisher health_;
  ros::Subscriber reports_;
  ros::WallTimer timer_, diagnostics_timer_;
  ros::Publisher diagnostics_;
};

}  // namespace
}  // namespace coppice::robot::monitoring

int main(int argc, char** argv) {
  const auto start = coppice::robot::monitoring::StartMonitor(argc, argv, "health_aggregator");
  if (!start) return 2;
  const coppice::robot::monitoring::Program program(*start);
  coppice::robot::monitoring::SpinWhenCalled();
  return 0;
}
