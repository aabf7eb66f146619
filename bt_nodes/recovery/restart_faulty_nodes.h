// RestartFaultyNodes: the recovery of dead, hung and silent programs.
#ifndef COPPICE_BT_NODES_RECOVERY_RESTART_FAULTY_NODES_H_
#define COPPICE_BT_NODES_RECOVERY_RESTART_FAULTY_NODES_H_

#include <optional>
#include <string>

#include "bt_core/nodes/leaf.h"
#include "bt_nodes/processes/process_manager.h"
#include "bt_nodes/recovery/node_repairs.h"
#include "bt_nodes/recovery/recovery_log.h"

namespace coppice::leaves {

/// RUNNING while restarts help or may help, FAILURE when only nodes are left that need a person,
/// SUCCESS when no node is blamed any more. What it knows of the nodes outlives an activation.
class RestartFaultyNodes : public Action {
 public:
  static constexpr const char* kDescription =
      "Restarts every node that a monitor blames, several at once if need be, and waits until they "
      "are well; fails when only nodes are left that do not come back.";
  RestartFaultyNodes(ProcessManager& processes, RecoveryLog& log)
      : processes_(processes), log_(log) {}
  Input<Health> health{this, "health", "from ReadHealth"};
  Input<std::string> kinds{this, "kinds", "monitors that blame nodes", "node;topic"};
  Input<Pose2D> pose{this, "pose", "of the robot, fed from outside", kOptional};
  Input<double> grace{this, "grace", "after a restart a node must be well within this [s]", 60};
  Input<int> times{this, "times", "budget of one node: no more than so many restarts ...", 10};
  Input<double> period{this, "period", "... in so long [s]", 600};
  Input<double> again{this, "again", "a node that does not come back is tried again after [s]", 60};
  Output<std::string> given_up{this, "given_up", "the nodes that need a person"};

  Status OnStart() override { return OnRunning(); }
  Status OnRunning() override;
  void OnHalted() override {}  // what was begun is carried through

 private:
  void TakeInHealth();
  void TakeAnswer();
  void RestartNext();
  void Record(const RepairOutcome& repair, RecoveryPhase phase, const std::string& message = {});

  ProcessManager& processes_;
  RecoveryLog& log_;
  Mailbox<ActionResult> answer_{this, "answer"};
  std::optional<NodeRepairs> repairs_;  // from the first tick on, when the ports can be read
  std::optional<RepairOutcome> asked_;  // the restart that has no answer yet
  std::string told_;                    // what stands in given_up
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_RECOVERY_RESTART_FAULTY_NODES_H_
