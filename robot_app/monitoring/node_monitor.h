// Are the nodes alive? Judges the pings of NodeProbe: one lost ping is a warning, several in a row
// are an error. All times are wall time: a hung node is hung however fast simulated time runs.
#ifndef COPPICE_ROBOT_APP_MONITORING_NODE_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_NODE_MONITOR_H_

#include <string>
#include <vector>

#include "robot_app/common/node_probe.h"
#include "robot_app/monitoring/monitor.h"

namespace coppice::robot::monitoring {

class NodeMonitor : public Monitor {
 public:
  void Watch(const WatchList& list, const Times&) override { Watch(list.nodes); }
  /// Watches these nodes from now on; what is known about those that were watched before is kept.
  void Watch(const std::vector<NodeWatch>& nodes);

  /// What to ask for in the next sweep.
  std::vector<ProbeRequest> Requests() const;

  /// The result of a ping. A node that is not watched (any more) is ignored.
  void Observe(const std::string& node, const ProbeResult& result);

  /// One finding per node, value: seconds until the answer. Misses of a node that is being started
  /// are forgotten.
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now) override;

 private:
  struct Watched {
    NodeWatch watch;
    int misses = 0;  // in a row
    ProbeResult last;
  };
  std::vector<Watched> nodes_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_NODE_MONITOR_H_
