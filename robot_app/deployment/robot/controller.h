// Who drives the robot in a deployment: the file controllers.yaml as values.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_CONTROLLER_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_CONTROLLER_H_

#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/base/status.h"
#include "robot_app/monitoring/monitor_config.h"
#include "robot_app/processes/config/robot_config.h"

namespace coppice::robot::deployment {

/// A node whose result is given instead of asking it.
struct Pretended {
  std::string tree;  ///< "application" or "monitor"
  std::string node;  ///< all nodes of that name
  Status result = Status::kSuccess;
};

/// Who restarts programs.
enum class Restarts : std::uint8_t { kByThemselves, kEndless, kByMonitors };

struct Controller {
  std::string name;
  std::string says;         ///< for people
  std::string application;  ///< file of its tree, relative to the project
  std::string monitor;
  std::vector<Pretended> pretended;
  Restarts restarts = Restarts::kByThemselves;
  bool contact_is_success = false;
  bool plans_charging = true;
  bool asks_all = true;            ///< else the first supervisor alone
  double gives_up = 28;            ///< s, a goal that is held
  double navigation_error = 60;    ///< s
  double lost_after = 10;          ///< s
  double localization_error = 20;  ///< s
  double monitor_period = 0.5;     ///< s
  bool watches_topics = true;
};

/// With errors the result is not to be used.
std::vector<Controller> LoadControllers(const std::string& path, Diagnostics& diagnostics);

/// The shipped configurations, changed as the controller says.
processes::RobotConfig Changed(processes::RobotConfig config, const Controller& controller);
monitoring::MonitorConfig Changed(monitoring::MonitorConfig config, const Controller& controller);

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_CONTROLLER_H_
