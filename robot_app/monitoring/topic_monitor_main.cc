// coppice-topic-monitor --config FILE [--folder FOLDER]: node /topic_monitor. Counts the messages
// of any type without reading them (scans and ranges it reads), or takes what their subscribers say
// on
// /statistics; sees who sends them; looks whether loggers log (their paths begin in FOLDER), and
// reads what other programs say on /diagnostics. Reports every report_period of wall time.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <rosgraph_msgs/TopicStatistics.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/Range.h>

#include <map>
#include <mutex>
#include <set>

#include "robot_app/common/any_message.h"
#include "robot_app/common/ros_support.h"
#include "robot_app/common/transforms/at_once_queue.h"
#include "robot_app/monitoring/aggregator/health_messages.h"
#include "robot_app/monitoring/diagnostics_monitor.h"
#include "robot_app/monitoring/logger_monitor.h"
#include "robot_app/monitoring/monitor_program.h"
#include "robot_app/monitoring/publisher_monitor.h"
#include "robot_app/monitoring/topic_monitor.h"

namespace coppice::robot::monitoring {
namespace {

// Long enough for a burst; a lost message would count as not sent.
constexpr int kQueue = 1000;

class Program {
 public:
  explicit Program(const MonitorStart& start)
      : topics_(start.config.patience),
        loggers_(start.folder),
        program_(start, {&topics_, &publishers_, &loggers_, &diagnostics_}, &counting_) {
    program_.OnList([this](const WatchList& list) { Subscribe(list); });
    program_.ReportRegularly();
  }

 private:
  void Subscribe(const WatchList& list) {
    std::set<std::string> counted, scans, ranges;
    bool needs_statistics = false;
    for (const TopicWatch& watch : list.topics) {
      needs_statistics = needs_statistics || watch.by_statistics;
      if (watch.content == Content::kLaserScan) {
        scans.insert(watch.topic);
      } else if (watch.content == Content::kRange) {
        ranges.insert(watch.topic);
      } else if (!watch.by_statistics) {
        counted.insert(watch.topic);
      }
    }
    for (const PublisherWatch& watch : list.publishers) counted.insert(watch.topic);
    for (const LoggerWatch& watch : list.loggers) {
      if (!watch.topic.empty()) counted.insert(watch.topic);
    }
    Keep(counted_, counted, [this](const std::string& topic) { return Count(topic); });
    Keep(scans_, scans, [this](const std::string& topic) { return ReadScans(topic); });
    Keep(ranges_, ranges, [this](const std::string& topic) { return ReadRanges(topic); });
    SubscribeStatistics(needs_statistics);
    SubscribeDiagnostics(list.diagnostics.has_value());
  }

  using Subscribers = std::map<std::string, ros::Subscriber>;

  // Those of these topics; one that is there stays.
  template <class Subscribe>
  static void Keep(Subscribers& subscribers, const std::set<std::string>& topics,
                   Subscribe subscribe) {
    Subscribers kept;
    for (const std::string& topic : topics) {
      const auto known = subscribers.find(topic);
      kept[topic] = known == subscribers.end() ? subscribe(topic) : known->second;
    }
    subscribers = std::move(kept);
  }

  ros::Subscriber ReadScans(const std::string& topic) {
    using Event = ros::MessageEvent<sensor_msgs::LaserScan const>;
    return program_.node().handle().subscribe<sensor_msgs::LaserScan>(
        topic, kQueue, boost::function<void(const Event&)>([this, topic](const Event& event) {
          const Times now{FromRos(event.getReceiptTime()), MonitorNode::Now().wall};
          const LaserScan scan = ToLaserScan(*event.getMessage(), {});
          const std::lock_guard<std::mutex> lock(counting_);
          topics_.OnScan(topic, scan, now);
        }));
  }

  ros::Subscriber ReadRanges(const std::string& topic) {
    using Event = ros::MessageEvent<sensor_msgs::Range const>;
    return program_.node().handle().subscribe<sensor_msgs::Range>(
        topic, kQueue, boost::function<void(const Event&)>([this, topic](const Event& event) {
          const Times now{FromRos(event.getReceiptTime()), MonitorNode::Now().wall};
          const std::lock_guard<std::mutex> lock(counting_);
          const sensor_msgs::Range& reading = *event.getMessage();
          topics_.OnRange(topic, reading.range, reading.header.stamp.toSec(), now);
        }));
  }

  ros::Subscriber Count(const std::string& topic) {
    using Event = ros::MessageEvent<AnyMessage const>;
    ros::SubscribeOptions options;
    options.initByFullCallbackType<const Event&>(topic, kQueue, [this, topic](const Event& event) {
      const Times now{FromRos(event.getReceiptTime()), MonitorNode::Now().wall};
      const std::lock_guard<std::mutex> lock(counting_);
      topics_.OnMessage(topic, now);
      publishers_.OnMessage(topic, event.getPublisherName(), now);
      loggers_.OnMessage(topic, now.wall);
    });
    options.callback_queue = &at_once_;
    return program_.node().handle().subscribe(options);
  }

  void SubscribeStatistics(bool is_needed) {
    program_.node().Subscribe<rosgraph_msgs::TopicStatistics>(
        statistics_, is_needed ? "/statistics" : "", kQueue,
        [this](const rosgraph_msgs::TopicStatistics& message) {
          const double seconds = message.window_stop.toSec() - message.window_start.toSec();
          if (seconds <= 0) return;
          const std::lock_guard<std::mutex> lock(counting_);
          topics_.OnStatistics(
              {message.topic, message.node_pub, message.node_sub, message.delivered_msgs / seconds},
              MonitorNode::Now());
        });
  }

  void SubscribeDiagnostics(bool is_needed) {
    program_.node().Subscribe<diagnostic_msgs::DiagnosticArray>(
        diagnostics_subscriber_, is_needed ? "/diagnostics" : "", kQueue,
        [this](const diagnostic_msgs::DiagnosticArray& message) {
          const Time now = MonitorNode::Now().wall;
          for (const diagnostic_msgs::DiagnosticStatus& status : message.status) {
            diagnostics_.OnStatus(status.name, status.level, status.message, now);
          }
        });
  }

  AtOnceQueue at_once_;
  std::mutex counting_;  // for the monitors; never held while (un)subscribing
  TopicMonitor topics_;
  PublisherMonitor publishers_;
  LoggerMonitor loggers_;
  DiagnosticsMonitor diagnostics_;
  MonitorProgram program_;
  Subscribers counted_, scans_, ranges_;
  ros::Subscriber statistics_, diagnostics_subscriber_;
};

}  // namespace
}  // namespace coppice::robot::monitoring

int main(int argc, char** argv) {
  namespace robot = coppice::robot;
  return robot::monitoring::RunMonitor<robot::monitoring::Program>(argc, argv, "topic_monitor",
                                                                   std::chrono::milliseconds(50));
}
