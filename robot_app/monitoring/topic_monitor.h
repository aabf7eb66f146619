// Do the topics flow, neither too slowly nor too fast? Rates are two-sided: a sensor that sends
// twice as fast as it should is as broken as one that is half asleep.
//
// By default in ROS time, because that is what a publisher's rate is defined in: a simulation at
// eight times real time sends eight times as often on the wall clock. When ROS time itself stands
// still nothing can be stale in it, so the clock's topic is to be watched in wall time.
#ifndef COPPICE_ROBOT_APP_MONITORING_TOPIC_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_TOPIC_MONITOR_H_

#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot_app/common/laser_scan.h"
#include "robot_app/monitoring/gauges/patience.h"
#include "robot_app/monitoring/gauges/statistics_watch.h"
#include "robot_app/monitoring/monitor.h"

namespace coppice::robot::monitoring {

/// Watches one topic on one time line.
class RateWatch {
 public:
  explicit RateWatch(TopicWatch watch) : watch_(std::move(watch)), judge_(watch_.band, "Hz") {}

  /// Forgets everything: silence and window count from the next Assess on.
  void Reset();
  /// Takes over what another watch of the same topic has seen.
  void Continue(const RateWatch& other);
  void OnMessage(Time now);
  /// A message came that counts as none; `what` is wrong with it.
  void OnUnusable(std::string what) { unusable_ = std::move(what); }
  /// The rate is the number of messages in the window that ends now; until the first window is full
  /// there is no judgement on it. Time that jumps back starts anew.
  Finding Assess(Time now);

  const TopicWatch& watch() const { return watch_; }

 private:
  TopicWatch watch_;
  Judge judge_;
  std::optional<Time> since_;  // start of the observation
  std::deque<Time> messages_;  // the last one, and all within the window
  std::string unusable_;       // what was wrong with the newest message; empty: nothing
};

class TopicMonitor : public Monitor {
 public:
  explicit TopicMonitor(Duration patience = Duration::zero()) : patience_(patience) {}

  void Watch(const WatchList& list, const Times&) override { Watch(list.topics); }
  /// Watches these topics from now on; a watch that stays the same keeps what it has seen.
  void Watch(const std::vector<TopicWatch>& topics);
  /// Topics that are not watched are ignored, and those of which the content is read.
  void OnMessage(const std::string& topic, const Times& now);
  /// For the topics that are watched as scans. One with a stamp that is seconds off counts as none:
  /// nobody moves by it.
  void OnScan(const std::string& topic, const LaserScan& scan, const Times& now);
  /// The same for the topics that are watched as ranges; not a number: the sensor is blind [m].
  void OnRange(const std::string& topic, float range, double stamp, const Times& now);
  /// For the topics that are watched by statistics.
  void OnStatistics(const SubscriberStatistics& statistics, const Times& now);
  /// One finding per topic, value: rate in Hz. A topic whose publisher is being started is reset.
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now) override;

 private:
  struct Watched {
    RateWatch rate;
    StatisticsWatch statistics;  // used instead of `rate` if the watch says so
    Patience patience;
    int pid = 0;  // of the publisher's process at the last report; 0: none, or not known
  };
  // `problem`: why the message counts as none; empty: it counts.
  void OnContent(const std::string& topic, Content content, const std::string& problem,
                 const Times& now);
  static Finding Assess(Watched& entry, const Times& now);

  Duration patience_;
  std::vector<Watched> topics_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_TOPIC_MONITOR_H_
