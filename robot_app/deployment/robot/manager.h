// The leaves' way to the process supervisor, and its way to cut the power: the real ones, called
// without a network between them.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_MANAGER_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_MANAGER_H_

#include <optional>
#include <string>
#include <vector>

#include "bt_nodes/processes/process_manager.h"
#include "robot_app/deployment/robot/programs.h"
#include "robot_app/processes/config/conditions.h"
#include "robot_app/processes/switch_off.h"

namespace coppice::robot::deployment {

class Manager : public leaves::ProcessManager {
 public:
  Manager(World& world, Programs& programs, const processes::RobotConfig& config);

  void RestartNode(const std::string& node, bool cleared,
                   Sender<leaves::ActionResult> done) override;
  void SetConfiguration(const std::string& configuration) override;
  /// Refused: all days are at one site.
  void SetSite(const std::string& site, Sender<leaves::ActionResult> done) override;
  void SwitchOff(const std::string& reason, Sender<leaves::ActionResult> done) override;

  /// The power is to be cut now.
  bool TakeCut();
  /// The robot was switched on again.
  void Reset();

 private:
  void OnCurrent(double current);

  World& world_;
  Programs& programs_;
  std::vector<processes::TopicCondition> conditions_;
  std::optional<processes::PowerDown> power_down_;
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_MANAGER_H_
