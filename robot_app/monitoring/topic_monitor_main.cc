// coppice-topic-monitor --config FILE [--folder FOLDER]: node /topic_monitor. Counts the messages
// of any type without reading them, or takes what their subscribers say on /statistics; looks
// whether loggers log (their paths begin in FOLDER), and reads what other programs say on
// /diagnostics. Reports every report_period of wall time.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <rosgraph_msgs/TopicStatistics.h>

#include <map>
#include <mutex>
#include <set>

#include "robot_app/monitoring/aggregator/at_once_queue.h"
#include "robot_app/monitoring/aggregator/health_messages.h"
#include "robot_app/common/any_message.h"
#include "robot_app/monitoring/diagnostics_monitor.h"
#include "robot_app/monitoring/logger_monitor.h"
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
        loggers_(start.folder),
        node_(start, [this](const WatchList& list) { Watch(list); }) {
    Subscribe();
    timer_ = node_.Every(start.config.report_period, [this] { Report(); });
  }

 private:
  void Watch(const WatchList& list) {
    {
      const std::lock_guard<std::mutex> lock(counting_);
      monitor_.Watch(list.topics);
      loggers_.Watch(list.loggers);
    }
    topics_ = list.topics;
    logger_topics_.clear();
    for (const LoggerWatch& watch : list.loggers) {
      if (!watch.topic.empty()) logger_topics_.push_back(watch.topic);
    }
    diagnostics_.Watch(list.diagnostics, MonitorNode::Now().wall);
    reads_diagnostics_ = list.diagnostics.has_value();
    if (timer_.isValid()) Subscribe();
  }

  void Report() {
    const Times now = MonitorNode::Now();
    std::vector<Finding> findings;
    const auto add = [&findings](std::vector<Finding> more) {
      for (Finding& finding : more) findings.push_back(std::move(finding));
    };
    {
      const std::lock_guard<std::mutex> lock(counting_);
      loggers_.Look(now.wall);
      add(monitor_.Report(node_.processes(), now));
      add(loggers_.Report(node_.processes(), now));
    }
    add(diagnostics_.Report(now));
    node_.Publish(std::move(findings));
  }

  void Subscribe() {
    std::set<std::string> counted(logger_topics_.begin(), logger_topics_.end());
    bool needs_statistics = false;
    for (const TopicWatch& watch : topics_) {
      needs_statistics = needs_statistics || watch.by_statistics;
      if (!watch.by_statistics) counted.insert(watch.topic);
    }
    std::map<std::string, ros::Subscriber> subscribers;
    for (const std::string& topic : counted) {
      const auto known = subscribers_.find(topic);
      subscribers[topic] = known == subscribers_.end() ? Count(topic) : known->second;
    }
    subscribers_ = std::move(subscribers);
    SubscribeStatistics(needs_statistics);
    SubscribeDiagnostics();
  }

  ros::Subscriber Count(const std::string& topic) {
    using Event = ros::MessageEvent<AnyMessage const>;
    ros::SubscribeOptions options;
    options.initByFullCallbackType<const Event&>(topic, kQueue, [this, topic](const Event& event) {
      const Times now{FromRos(event.getReceiptTime()), MonitorNode::Now().wall};
      const std::lock_guard<std::mutex> lock(counting_);
      monitor_.OnMessage(topic, now);
      loggers_.OnMessage(topic, now.wall);
    });
    options.callback_queue = &at_once_;
    return node_.handle().subscribe(options);
  }

  void SubscribeStatistics(bool is_needed) {
    node_.Subscribe<rosgraph_msgs::TopicStatistics>(
        statistics_, is_needed ? "/statistics" : "", kQueue,
        [this](const rosgraph_msgs::TopicStatistics& message) {
          const double seconds = (message.window_stop - message.window_start).toSec();
          if (seconds <= 0) return;
          const std::lock_guard<std::mutex> lock(counting_);
          monitor_.OnStatistics(
              {message.topic, message.node_pub, message.node_sub, message.delivered_msgs / seconds},
              MonitorNode::Now());
        });
  }

  void SubscribeDiagnostics() {
    node_.Subscribe<diagnostic_msgs::DiagnosticArray>(
        diagnostics_subscriber_, reads_diagnostics_ ? "/diagnostics" : "", kQueue,
        [this](const diagnostic_msgs::DiagnosticArray& message) {
          const Time now = MonitorNode::Now().wall;
          for (const diagnostic_msgs::DiagnosticStatus& status : message.status) {
            diagnostics_.OnStatus(status.name, status.level, status.message, now);
          }
        });
  }

  AtOnceQueue at_once_;
  std::mutex counting_;  // for the two below; never held while (un)subscribing
  TopicMonitor monitor_;
  LoggerMonitor loggers_;
  DiagnosticsMonitor diagnostics_;
  std::vector<TopicWatch> topics_;
  std::vector<std::string> logger_topics_;
  bool reads_diagnostics_ = false;
  MonitorNode node_;
  std::map<std::string, ros::Subscriber> subscribers_;
  ros::Subscriber statistics_, diagnostics_subscriber_;
  ros::WallTimer timer_;
};

}  // namespace
}  // namespace coppice::robot

int main(int argc, char** argv) {
  const auto start = coppice::robot::StartMonitor(argc, argv, "topic_monitor");
  if (!start) return 2;
  const coppice::robot::Program program(*start);
  coppice::robot::SpinInBatches(std::chrono::milliseconds(50));
  return 0;
}
