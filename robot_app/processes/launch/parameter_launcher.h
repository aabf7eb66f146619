// Sets the stack's ROS parameters before every start of a process, so that a program that is
// restarted finds them (simulated time above all) even if somebody has wiped the parameter server.
#ifndef COPPICE_ROBOT_APP_PROCESSES_LAUNCH_PARAMETER_LAUNCHER_H_
#define COPPICE_ROBOT_APP_PROCESSES_LAUNCH_PARAMETER_LAUNCHER_H_

#include <map>
#include <string>

#include "robot_app/common/node_probe.h"
#include "robot_app/processes/launch/process_launcher.h"

namespace coppice::robot::processes {

/// Values are numbers, true, false or texts. Up to the first one that the master does not take.
Outcome SetParameters(const NodeAddress& master,
                      const std::map<std::string, std::string>& parameters);

class ParameterLauncher : public ProcessLauncher {
 public:
  /// `next` starts the processes and must outlive it.
  ParameterLauncher(ProcessLauncher& next, NodeAddress master,
                    std::map<std::string, std::string> parameters);

  /// Nothing is started when the master does not take the parameters.
  Expected<int> Start(const ProcessConfig& config) override;
  void Signal(int pid, int signal) override { next_.Signal(pid, signal); }
  Outcome ClearState(const ProcessConfig& config) override { return next_.ClearState(config); }
  bool IsConnected(int pid) const override { return next_.IsConnected(pid); }

 private:
  ProcessLauncher& next_;
  const NodeAddress master_;
  const std::map<std::string, std::string> parameters_;
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_LAUNCH_PARAMETER_LAUNCHER_H_
