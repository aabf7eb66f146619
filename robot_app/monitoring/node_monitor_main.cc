// coppice-node-monitor --config FILE: node /node_monitor. Pings all nodes at the same time, every
// report_period of wall time, and reports after every sweep.
#include <ros/ros.h>

#include "robot_app/monitoring/monitor_node.h"
#include "robot_app/monitoring/node_monitor.h"

namespace coppice::robot {
namespace {

// How often a sweep that is under way is looked after.
const ros::WallDuration kRound(0.01);

class Program {
 public:
  explicit Program(const MonitorStart& start)
      : config_(start.config),
        node_(start, [this](const WatchList& list) { monitor_.Watch(list.nodes); }),
        probe_(ParseUri(ros::master::getURI()).value(), ros::this_node::getName()) {
    timer_ =
        node_.handle().createWallTimer(kRound, [this](const ros::WallTimerEvent&) { Round(); });
  }

 private:
  void Round() {
    if (probe_.busy()) {
      if (probe_.Work(Duration::zero())) Report();
      return;
    }
    const Time now = MonitorNode::Now().wall;
    if (now < next_sweep_) return;
    next_sweep_ = now + config_.report_period;
    probe_.Begin(monitor_.Requests(), config_.ping_deadline);
  }

  void Report() {
    for (std::size_t i = 0; i < probe_.requests().size(); ++i) {
      monitor_.Observe(probe_.requests()[i].node, probe_.results()[i]);
    }
    node_.Publish(monitor_.Report(node_.processes(), MonitorNode::Now().ros));
  }

  const MonitorConfig& config_;
  NodeMonitor monitor_;
  MonitorNode node_;
  NodeProbe probe_;
  Time next_sweep_{0};
  ros::WallTimer timer_;
};

}  // namespace
}  // namespace coppice::robot

int main(int argc, char** argv) {
  const auto start = coppice::robot::StartMonitor(argc, argv, "node_monitor");
  if (!start) return 2;
  const coppice::robot::Program program(*start);
  ros::spin();
  return 0;
}
