// The program around monitors: tells them what to watch, and sends what they have found. What is
// left to a program is to feed them.
#ifndef COPPICE_ROBOT_APP_MONITORING_MONITOR_PROGRAM_H_
#define COPPICE_ROBOT_APP_MONITORING_MONITOR_PROGRAM_H_

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "robot_app/monitoring/monitor.h"
#include "robot_app/monitoring/monitor_node.h"

namespace coppice::robot::monitoring {

/// For the thread that spins.
class MonitorProgram {
 public:
  /// The monitors must outlive it. `guard`: held whenever they are called, for monitors that other
  /// threads feed.
  MonitorProgram(const MonitorStart& start, std::vector<Monitor*> monitors,
                 std::mutex* guard = nullptr);

  /// Calls at once, and whenever the monitors were told of another configuration.
  void OnList(std::function<void(const WatchList&)> subscribe);

  /// Reports again and again from now on; `look` is called before every report.
  void ReportRegularly(std::function<void(const Times&)> look = [](const Times&) {});
  /// Reports once.
  void Report(const Times& now);

  MonitorNode& node() { return node_; }

 private:
  void Watch(const WatchList& list);
  std::unique_lock<std::mutex> Guard() const;

  const MonitorStart& start_;
  std::vector<Monitor*> monitors_;
  std::mutex* guard_;
  std::function<void(const WatchList&)> subscribe_;
  MonitorNode node_;
  ros::WallTimer timer_;
};

/// A program's main: with the Program, made of a MonitorStart, spins until it is to end. `batch`:
/// what has come is taken in only so often (SpinInBatches).
template <class Program>
int RunMonitor(int argc, char** argv, const std::string& name, Duration batch = Duration::zero()) {
  const auto start = StartMonitor(argc, argv, name);
  if (!start) return 2;
  const Program program(*start);
  if (batch == Duration::zero()) {
    SpinWhenCalled();
  } else {
    SpinInBatches(batch);
  }
  return 0;
}

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_MONITOR_PROGRAM_H_
