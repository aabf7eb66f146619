// The rate of a topic as its subscribers see it: for topics that are too big to subscribe to only
// for counting. ROS nodes with the parameter /enable_statistics report what they receive on
// /statistics (http://wiki.ros.org/Topics#Topic_statistics); nobody reports a topic without
// subscribers, nor one that is silent.
#ifndef COPPICE_ROBOT_APP_MONITORING_GAUGES_STATISTICS_WATCH_H_
#define COPPICE_ROBOT_APP_MONITORING_GAUGES_STATISTICS_WATCH_H_

#include <optional>
#include <string>
#include <vector>

#include "robot_app/monitoring/gauges/finding.h"
#include "robot_app/monitoring/gauges/watch.h"

namespace coppice::robot::monitoring {

/// What one subscriber has received from one publisher.
struct SubscriberStatistics {
  std::string topic;
  std::string publisher;   ///< node
  std::string subscriber;  ///< node
  double rate = 0;         ///< Hz
};

/// Watches one topic on one time line.
class StatisticsWatch {
 public:
  explicit StatisticsWatch(const TopicWatch& watch) : watch_(watch), judge_(watch.band, "Hz") {}

  /// Forgets everything: silence counts from the next Assess on.
  void Reset();
  /// Takes over what another watch of the same topic has seen.
  void Continue(const StatisticsWatch& other);
  void OnStatistics(const SubscriberStatistics& statistics, Time now);
  /// The rate is the sum over the publishers, of the subscriber that receives the most: one that
  /// is too slow to take all says nothing about the topic.
  Finding Assess(Time now);

 private:
  struct Link {
    SubscriberStatistics statistics;
    Time heard_at{};
  };
  double Rate() const;

  TopicWatch watch_;
  Judge judge_;
  std::optional<Time> since_;  // start of the observation
  std::vector<Link> links_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_GAUGES_STATISTICS_WATCH_H_
