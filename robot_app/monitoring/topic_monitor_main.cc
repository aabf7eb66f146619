// coppice-topic-monitor --config FILE: node /topic_monitor. Counts the messages of any type without
// reading them, or takes what their subscribers say on /statistics, and reports rates and silence
// every report_period of wall time.
#include <ros/ros.h>
#include <rosgraph_msgs/TopicStatistics.h>

#include <algorithm>

#include "robot_app/monitoring/any_message.h"
#include "robot_app/monitoring/monitor_node.h"
#include "robot_app/monitoring/topic_monitor.h"

namespace coppice::robot {
namespace {

// Long enough for a burst; a lost message would count as not sent.
constexpr int kQueue = 1000;

class Program {
 public:
  explicit Program(const MonitorStart& start)
      : monitor_(start.config.patience),
        node_(start, [this](const WatchList& list) { Watch(list.topics); }) {
    Subscribe();
    timer_ = node_.Every(start.config.report_period, [this] {
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
      if (watch.by_statistics) continue;
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
    SubscribeStatistics();
  }

  void SubscribeStatistics() {
    const bool needed = std::any_of(topics_.begin(), topics_.end(),
                                    [](const TopicWatch& watch) { return watch.by_statistics; });
    if (!needed) statistics_.shutdown();
    if (!needed || !statistics_.getTopic().empty()) return;
    statistics_ = node_.handle().subscribe<rosgraph_msgs::TopicStatistics>(
        "/statistics", kQueue, [this](const rosgraph_msgs::TopicStatistics::ConstPtr& message) {
          const double seconds = (message->window_stop - message->window_start).toSec();
          if (seconds <= 0) return;
          monitor_.OnStatistics({message->topic, message->node_pub, message->node_sub,
                                 message->delivered_msgs / seconds},
                                MonitorNode::Now());
        });
  }

  TopicMonitor monitor_;
  std::vector<TopicWatch> topics_;
  MonitorNode node_;
  std::map<std::string, ros::Subscriber> subscribers_;
  ros::Subscriber statistics_;
  ros::WallTimer timer_;
};

}  // namespace
}  // namespace coppice::robot

int main(int argc, char** argv) {
  const auto start = coppice::robot::StartMonitor(argc, argv, "topic_monitor");
  if (!start) return 2;
  const coppice::robot::Program program(*start);
  ros::spin();
  return 0;
}
