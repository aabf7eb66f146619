// Does nobody else speak on a topic? A stranger on the topic of the drive's commands moves the
// robot, whatever navigation and people want.
//
// Judged by what comes: who only advertises a topic does no harm. Wall time.
#ifndef COPPICE_ROBOT_APP_MONITORING_PUBLISHER_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_PUBLISHER_MONITOR_H_

#include <string>
#include <vector>

#include "robot_app/monitoring/monitor.h"

namespace coppice::robot::monitoring {

class PublisherMonitor : public Monitor {
 public:
  void Watch(const WatchList& list, const Times&) override { Watch(list.publishers); }
  /// Watches these topics from now on.
  void Watch(const std::vector<PublisherWatch>& topics);

  /// A message from that node. Topics that are not watched are ignored.
  void OnMessage(const std::string& topic, const std::string& node, const Times& now);

  /// One finding per topic: an error for five seconds after each message of a stranger. It names no
  /// node: what nobody has started nobody can restart.
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now) override;

 private:
  struct Watched {
    PublisherWatch watch;
    std::string stranger;  // the last one; empty: none
    Time heard_at{};       // its last message
  };
  std::vector<Watched> topics_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_PUBLISHER_MONITOR_H_
