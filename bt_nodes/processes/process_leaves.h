// Leaves that act on the robot's programs: RestartNode, SwitchConfiguration, SwitchSite, SwitchOff.
#ifndef COPPICE_BT_NODES_PROCESSES_PROCESS_LEAVES_H_
#define COPPICE_BT_NODES_PROCESSES_PROCESS_LEAVES_H_

#include <string>

#include "bt_nodes/basics/capability_action.h"
#include "bt_nodes/processes/process_manager.h"

namespace coppice::leaves {

class RestartNode : public CapabilityAction {
 public:
  static constexpr const char* kDescription = "Restarts the program behind a ROS node.";
  explicit RestartNode(ProcessManager& processes) : processes_(processes) {}
  Input<std::string> node{this, "node", "ROS node, with slash"};
  Input<bool> cleared{this, "cleared",
                      "forget first what it remembers of earlier lives, such as the last pose",
                      false};

 protected:
  void Begin(Sender<ActionResult> done) override { processes_.RestartNode(*node, *cleared, done); }
  void Cancel() override {}  // a restart that has begun is carried through

 private:
  ProcessManager& processes_;
};

class SwitchOff : public CapabilityAction {
 public:
  static constexpr const char* kDescription =
      "Brings the robot to its safe stop, has its records written and switches it off. The last "
      "thing to do.";
  explicit SwitchOff(ProcessManager& processes) : processes_(processes) {}
  Input<std::string> reason{this, "reason", "why, for people", "asked for"};

 protected:
  void Begin(Sender<ActionResult> done) override { processes_.SwitchOff(*reason, done); }
  void Cancel() override {}  // it cannot be called back

 private:
  ProcessManager& processes_;
};

/// Once it is granted nothing comes after it: the program of the trees ends with all others.
class SwitchSite : public CapabilityAction {
 public:
  static constexpr const char* kDescription =
      "The robot was brought to another site: all programs begin anew with its map, places, bands and "
      "parameters. Succeeds when it is there already; else its tree begins anew there.";
  explicit SwitchSite(ProcessManager& processes) : processes_(processes) {}
  Input<std::string> site{this, "site", "its name in the table of robot.yaml"};

 protected:
  void Begin(Sender<ActionResult> done) override { processes_.SetSite(*site, done); }
  void Cancel() override {}  // it cannot be called back

 private:
  ProcessManager& processes_;
};

/// Desired state: asks again as long as the robot is not there yet, and never holds up the tree.
class SwitchConfiguration : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Asks for a configuration of programs unless it is already in force. Does not wait for it.";
  explicit SwitchConfiguration(ProcessManager& processes) : processes_(processes) {}
  Input<std::string> configuration{this, "configuration",
                                   "the wanted one: operating, charging, ..."};
  Input<std::string> current{this, "current", "the one in force, fed from outside", kOptional};
  Input<double> period{this, "period", "ask at most this often [s]", 5.0};
  Status Run() override;

 private:
  ProcessManager& processes_;
  std::string asked_for_;
  Time asked_at_{};
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_PROCESSES_PROCESS_LEAVES_H_
