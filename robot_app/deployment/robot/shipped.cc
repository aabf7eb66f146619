#include "robot_app/deployment/robot/shipped.h"

#include <utility>

#include "robot_app/monitoring/site_bands.h"

namespace coppice::robot::deployment {

std::optional<Shipped> LoadShipped(const std::string& root, Diagnostics& diagnostics) {
  Shipped shipped;
  shipped.root = root;
  const std::string config = shipped.Path("robot_app/config");
  // Nothing is started from it, so any folder will do.
  const processes::Variables variables = {
      {"bin", "/not/a/folder"}, {"config", config}, {"record", "/not/a/folder"}};
  shipped.robot = processes::LoadRobotConfig(config + "/robot.yaml", variables, diagnostics);
  shipped.monitors = monitoring::LoadMonitorConfig(config + "/monitors.yaml", diagnostics);
  monitoring::ReadSiteBands(config + "/sites/institute/bands.yaml", shipped.monitors, diagnostics);
  // Its warnings are of channels without a password.
  Diagnostics of_people;
  const auto no_environment = [](const std::string&) { return std::optional<std::string>(); };
  shipped.people =
      assistance::LoadAssistanceConfig(config + "/supervisors.yaml", no_environment, of_people);
  if (of_people.has_errors()) diagnostics = of_people;
  auto floor = simulation::LoadFloor(shipped.Path("robot_app/config/sites/institute/world.yaml"),
                                     diagnostics);
  if (!floor || diagnostics.has_errors()) return std::nullopt;
  shipped.floor = *std::move(floor);
  return shipped;
}

}  // namespace coppice::robot::deployment
