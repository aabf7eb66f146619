// The files of the shipped robot that a deployment needs, read once.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_SHIPPED_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_SHIPPED_H_

#include <optional>
#include <string>

#include "robot_app/assistance/assistance_config.h"
#include "robot_app/monitoring/monitor_config.h"
#include "robot_app/processes/config/robot_config.h"
#include "robot_app/simulation/floor.h"

namespace coppice::robot::deployment {

struct Shipped {
  std::string root;  ///< of the project
  processes::RobotConfig robot;
  monitoring::MonitorConfig monitors;
  assistance::AssistanceConfig people;
  simulation::Floor floor;

  std::string Path(const std::string& file) const { return root + "/" + file; }
};

/// `root`: of the project. Nothing if something is wrong, which is in `diagnostics`.
std::optional<Shipped> LoadShipped(const std::string& root, Diagnostics& diagnostics);

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_SHIPPED_H_
