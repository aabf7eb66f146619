// coppice-topic-monitor --config FILE: node /topic_monitor. Counts the messages of any type without
// reading them and reports rates and silence every report_period of wall time.
#include <ros/ros.h>

#include "robot_app/monitoring/any_message.h"
#include "robot_app/monitoring/monitor_node.h"
#include "robot_app/monitoring/topic_monitor.h"

namespace coppice::robot {
namespace {

// Long enough for a burst; a lost message would count as not sent.
constexpr int kQueue = 1000;

class Program {
 public:
  explicit Program(const MonitorConfig& config)
      : monitor_(config.patience),
        node_(config, [this](const WatchList& list) { Watch(list.topics); }) {
    Subscribe();
    const ros::WallDuration period(std::chrono::duration<double>(config.report_period).count());
    timer_ = node_.handle().createWallTimer(period, [this](const ros::WallTimerEvent&) {
      node_.Publish(monitor_.Report(node_.processes(), MonitorNode::Now()));
    });
  }

 private:
  void Watch(const std::vector<TopicWatch>& topics) {
    monitor_.Watch(topics);
    topics_ = topics;
    if (timer_.isValid()) Subscribe();
  }

  void Subscribe() {
    std::map<std::string, ros::Subscriber> subscribers;
    for (const TopicWatch& watch : topics_) {
      const auto known = subscribers_.find(watch.topic);
      if (known != subscribers_.end()) {
        subscribers.insert(*known);
        continue;
      }
      subscribers[watch.topic] = node_.handle().subscribe<AnyMessage>(
          watch.topic, kQueue,
          [this, topic = watch.topic](const boost::shared_ptr<AnyMessage const>&) {
            monitor_.OnMessage(topic, MonitorNode::Now());
          });
    }
    subscribers_ = std::move(subscribers);
  }

  TopicMonitor monitor_;
  std::vector<TopicWatch> topics_;
  MonitorNode node_;
  std::map<std::string, ros::Subscriber> subscribers_;
  ros::WallTimer timer_;
};

}  // namespace
}  // namespace coppice::robot

int main(int argc, char** argv) {
  const auto config = coppice::robot::StartMonitor(argc, argv, "topic_monitor");
  if (!config) return 2;
  const coppice::robot::Program program(*config);
  ros::spin();
  return 0;
}
