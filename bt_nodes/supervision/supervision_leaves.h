// Leaves that act on the robot's programs and on its human supervisors, and the interfaces that
// they need.
#ifndef COPPICE_BT_NODES_SUPERVISION_SUPERVISION_LEAVES_H_
#define COPPICE_BT_NODES_SUPERVISION_SUPERVISION_LEAVES_H_

#include <string>

#include "bt_nodes/system/capability_action.h"

namespace coppice {

/// The process supervisor. Called on the ticking thread; returns at once.
class ProcessManager {
 public:
  virtual ~ProcessManager() = default;
  /// Ends the program behind a ROS node and starts it again. Done when the restart has begun;
  /// refused when the program was restarted too often.
  virtual void RestartNode(const std::string& node, Sender<ActionResult> done) = 0;
  /// Asks for a configuration: the set of programs that should run.
  virtual void SetConfiguration(const std::string& configuration) = 0;
};

/// The people who look after the robot. Called on the ticking thread; returns at once.
class SupervisorChannel {
 public:
  virtual ~SupervisorChannel() = default;
  /// Asks for help. ok: somebody confirmed that it is fixed.
  virtual void Ask(const std::string& question, Sender<ActionResult> done) = 0;
  /// The question has settled itself.
  virtual void Withdraw() = 0;
};

class RestartNode : public CapabilityAction {
 public:
  static constexpr const char* kDescription = "Restarts the program behind a ROS node.";
  explicit RestartNode(ProcessManager& processes) : processes_(processes) {}
  Input<std::string> node{this, "node", "ROS node, with slash"};

 protected:
  void Begin(Sender<ActionResult> done) override { processes_.RestartNode(*node, done); }
  void Cancel() override {}  // a restart that has begun is carried through

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
  Time asked_at_{0};
};

class AskSupervisor : public CapabilityAction {
 public:
  static constexpr const char* kDescription =
      "Asks the robot's supervisors for help and waits for a confirmation.";
  explicit AskSupervisor(SupervisorChannel& channel) : channel_(channel) {}
  Input<std::string> question{this, "question", "what is wrong and what to do"};

 protected:
  void Begin(Sender<ActionResult> done) override { channel_.Ask(*question, done); }
  void Cancel() override { channel_.Withdraw(); }

 private:
  SupervisorChannel& channel_;
};

}  // namespace coppice

#endif  // COPPICE_BT_NODES_SUPERVISION_SUPERVISION_LEAVES_H_
