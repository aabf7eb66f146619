// Which other computers the robot consists of: those on which the process supervisor has nodes, and
// its own. Their addresses are those under which the nodes are registered.
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_OTHER_COMPUTERS_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_OTHER_COMPUTERS_H_

#include <map>
#include <string>
#include <vector>

#include "robot_app/monitoring/process_table.h"
#include "robot_app/monitoring/system/system_watch.h"

namespace coppice::robot::monitoring {

class OtherComputers {
 public:
  /// `own`: name of this computer. `master`: where the ROS master is, and with it the supervisor.
  OtherComputers(std::string own, std::string master)
      : own_(std::move(own)), master_(std::move(master)) {}

  /// One node on each computer whose address is not known yet: to be asked where it is.
  std::vector<std::string> NodesToAsk(const ProcessTable& processes) const;

  /// The node has answered from there.
  void OnAddress(const ProcessTable& processes, const std::string& node,
                 const std::string& address);

  /// Those whose address is known, in the order of their names. Once found they stay. For a
  /// computer that is not the supervisor's own, that one is among them, as "main".
  std::vector<Computer> List(const ProcessTable& processes) const;

 private:
  std::string own_, master_;
  std::map<std::string, std::string> addresses_;  // by name
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_OTHER_COMPUTERS_H_
