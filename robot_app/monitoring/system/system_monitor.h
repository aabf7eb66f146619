// Is the computer well? Judges what the operating system says about load, temperature, memory,
// disks, network and processes (system_sample.h), and what other computers say. All is handed in.
//
// All times are wall time: a computer is busy however fast simulated time runs.
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_MONITOR_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_MONITOR_H_

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "robot_app/monitoring/gauges/gauge_board.h"
#include "robot_app/monitoring/monitor.h"
#include "robot_app/monitoring/system/counter_rate.h"
#include "robot_app/monitoring/system/reach.h"
#include "robot_app/monitoring/system/sntp.h"
#include "robot_app/monitoring/system/system_sample.h"
#include "robot_app/monitoring/system/system_watch.h"

namespace coppice::robot::monitoring {

class SystemMonitor : public Monitor {
 public:
  /// A computer is no matter of the configuration.
  void Watch(const WatchList&, const Times&) override {}
  /// Null: nothing is watched. What is known of numbers that stay is kept.
  void Watch(const SystemWatch* watch);
  /// The others on which nodes of the robot run: they take the place of "*". True: others than
  /// before, so whoever asks them is to ask anew.
  bool OnComputers(const std::vector<Computer>& others);
  /// What is watched now: each link and each computer by its name.
  const SystemWatch& watched() const { return watched_; }

  /// What to look at now. `pids`: of the ROS nodes; a node that is missing or 0 does not run, which
  /// is for others to judge.
  SystemQuestion Question(const std::map<std::string, int>& pids) const;
  /// One look; to be handed in every period. Without one for long the computer does not answer.
  void OnSample(const SystemSample& sample);

  /// The answers of other computers, in the order of watched().
  void OnClocks(const std::vector<Expected<ClockReading>>& readings, Time now);
  void OnHosts(const std::vector<ReachDelay>& results, Time now);

  /// One finding per number that can be measured on this computer.
  std::vector<Finding> Report(const ProcessTable& processes, const Times& now) override;

 private:
  void Expand();
  void OnLinksUp(const std::vector<std::string>& links);
  void OnCpu(const CpuTimes& times, Time now);
  void OnLink(const InterfaceWatch& watch, const LinkSample& link, Time now);
  void OnProcess(const std::string& node, const ProcessSample& process, Time now);
  void TellSilence(Time now);
  /// The growth of a counter per second, if it is known already.
  std::optional<double> Rate(const std::string& counter, double reading, Time now);

  bool is_on_ = false;
  SystemWatch watch_;    // as it is written
  SystemWatch watched_;  // with names instead of patterns
  std::vector<Computer> others_;
  std::vector<std::string> links_;
  std::set<std::string> serving_;  // hosts whose time server has answered
  std::optional<Time> last_sample_;
  GaugeBoard board_;
  std::map<std::string, CounterRate> rates_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_MONITOR_H_
