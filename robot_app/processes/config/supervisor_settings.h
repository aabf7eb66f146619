// The command line of coppice-supervisor.
#ifndef COPPICE_ROBOT_APP_PROCESSES_CONFIG_SUPERVISOR_SETTINGS_H_
#define COPPICE_ROBOT_APP_PROCESSES_CONFIG_SUPERVISOR_SETTINGS_H_

#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/command_line.h"
#include "robot_app/processes/config/variables.h"

namespace coppice::robot::processes {

struct SupervisorSettings {
  std::optional<int> exit;    ///< as in Options
  std::string config;         ///< robot.yaml
  int port = 11311;           ///< of the ROS master; 0: a free one
  std::string address;        ///< of this computer for nodes on other hosts; empty: as in ROS_IP
  std::string port_file;      ///< gets the port as text; may be empty
  std::string logs;           ///< folder, absolute
  std::string state;          ///< file of the supervisor's memory, absolute
  std::string configuration;  ///< to begin with; empty: the file's
  Variables variables;        ///< bin, config and record among them
};

const Command& SupervisorCommand();

/// `bin`: folder of this program.
SupervisorSettings ReadSupervisorSettings(const std::vector<std::string>& arguments,
                                          const std::string& bin);

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_CONFIG_SUPERVISOR_SETTINGS_H_
