// What the process supervisor says about the processes behind the nodes. Monitors look here so that
// a node that is just being started raises no alarm.
#ifndef COPPICE_ROBOT_APP_MONITORING_PROCESS_TABLE_H_
#define COPPICE_ROBOT_APP_MONITORING_PROCESS_TABLE_H_

#include <map>
#include <string>

#include "robot_app/common/process_phase.h"
#include "robot_app/monitoring/gauges/finding.h"

namespace coppice::robot::monitoring {

/// The process behind a node.
struct NodeProcess {
  ProcessPhase phase = ProcessPhase::kStopped;
  int pid = 0;          ///< 0: not running
  std::string message;  ///< why it is in that phase, for people; may be empty
};

/// /processes as a value. Empty while there is no supervisor: then nothing has a grace.
struct ProcessTable {
  std::string configuration;
  std::map<std::string, NodeProcess> by_node;
  std::map<std::string, std::string> hosts;  ///< of the nodes that run on other computers

  /// The supervisor is about to start this node, or waits for it to become ready.
  bool IsStarting(const std::string& node) const;
  /// The supervisor runs this node in other configurations, or was told to leave it out.
  bool IsOff(const std::string& node) const;
  /// The process of the node; 0 if it does not run or is not known.
  int PidOf(const std::string& node) const;
  /// The computer on which the node runs; empty: the supervisor's own, or not known.
  std::string HostOf(const std::string& node) const;
};

/// Said of what is optional and switched off.
inline constexpr char kOff[] = "switched off";

/// Takes what the supervisor knows into account: OK while the node starts; no worse than WARN while
/// the supervisor itself is about to start it again; else its message is added to an error's.
void ApplyGrace(const ProcessTable& processes, const std::string& node, Finding& finding);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_PROCESS_TABLE_H_
