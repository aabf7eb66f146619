// What all monitors have in common: they are told what to watch, fed with what happens, and say
// what they have found. A monitor knows no ROS; MonitorProgram carries it.
#ifndef COPPICE_ROBOT_APP_MONITORING_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_MONITOR_H_

#include <vector>

#include "robot_app/monitoring/gauges/finding.h"
#include "robot_app/monitoring/process_table.h"
#include "robot_app/monitoring/watch_list.h"

namespace coppice::robot::monitoring {

class Monitor {
 public:
  virtual ~Monitor() = default;

  /// A configuration has come into force: its part of the list is watched from now on. What stays
  /// the same keeps what was seen.
  virtual void Watch(const WatchList& list, const Times& now) = 0;

  /// What there is to say now, one finding per thing that is watched.
  virtual std::vector<Finding> Report(const ProcessTable& processes, const Times& now) = 0;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_MONITOR_H_
