// What leaves need of whoever starts and restarts the robot's programs. Implemented on the process
// supervisor in robot_app/ros, and on test doubles.
//
// All functions are called on the ticking thread and return at once. Answers come through the
// sender, from any thread.
#ifndef COPPICE_BT_NODES_PROCESSES_PROCESS_MANAGER_H_
#define COPPICE_BT_NODES_PROCESSES_PROCESS_MANAGER_H_

#include <string>

#include "bt_core/data/inbox.h"
#include "bt_nodes/basics/action_result.h"

namespace coppice::leaves {

class ProcessManager {
 public:
  virtual ~ProcessManager() = default;
  /// Ends the program behind a ROS node and starts it again. Done when the restart has begun;
  /// refused when the program was restarted too often. `cleared`: what it remembers of earlier
  /// lives, for example the last pose, is forgotten first.
  virtual void RestartNode(const std::string& node, bool cleared, Sender<ActionResult> done) = 0;
  /// Asks for a configuration: the set of programs that should run.
  virtual void SetConfiguration(const std::string& configuration) = 0;
  /// The robot was brought to another site: asks for all that belongs to it. `done`: ok when it has
  /// begun; then this tree, too, is ended and begins anew there.
  virtual void SetSite(const std::string& site, Sender<ActionResult> done) = 0;
  /// The last step: stops everything and switches off, as far as the robot is set up for that.
  /// `done`: ok when it has begun.
  virtual void SwitchOff(const std::string& reason, Sender<ActionResult> done) = 0;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_PROCESSES_PROCESS_MANAGER_H_
