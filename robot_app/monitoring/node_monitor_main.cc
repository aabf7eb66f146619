// coppice-node-monitor --config FILE: node /node_monitor. Pings all nodes at the same time, every
// report_period of wall time, and reports after every sweep.
#include <ros/ros.h>

#include "robot_app/monitoring/monitor_program.h"
#include "robot_app/monitoring/node_monitor.h"

namespace coppice::robot::monitoring {
namespace {

// How often a sweep that is not done at once is looked after.
constexpr Duration kRound = std::chrono::milliseconds(10);
// Nodes that are well answer within this.
constexpr Duration kAtOnce = std::chrono::milliseconds(50);

class Program {
 public:
  explicit Program(const MonitorStart& start)
      : config_(start.config),
        program_(start, {&monitor_}),
        probe_(ParseUri(ros::master::getURI()).value(), ros::this_node::getName()) {
    sweep_timer_ = program_.node().Every(config_.report_period, [this] { Sweep(); });
    round_timer_ = program_.node().Every(kRound, [this] { Round(Duration::zero()); });
    round_timer_.stop();
  }

 private:
  void Sweep() {
    is_due_ = probe_.busy();
    if (is_due_) return;
    probe_.Begin(monitor_.Requests(), config_.ping_deadline);
    Round(kAtOnce);
    if (probe_.busy()) round_timer_.start();
  }

  void Round(Duration at_most) {
    if (!probe_.busy() || !probe_.Work(at_most)) return;
    round_timer_.stop();
    for (std::size_t i = 0; i < probe_.requests().size(); ++i) {
      monitor_.Observe(probe_.requests()[i].node, probe_.results()[i]);
    }
    program_.Report(MonitorNode::Now());
    if (is_due_) Sweep();
  }

  const MonitorConfig& config_;
  NodeMonitor monitor_;
  MonitorProgram program_;
  NodeProbe probe_;
  bool is_due_ = false;  // the next sweep; it waits for the one that is under way
  ros::WallTimer sweep_timer_, round_timer_;
};

}  // namespace
}  // namespace coppice::robot::monitoring

int main(int argc, char** argv) {
  namespace robot = coppice::robot;
  return robot::monitoring::RunMonitor<robot::monitoring::Program>(argc, argv, "node_monitor");
}
