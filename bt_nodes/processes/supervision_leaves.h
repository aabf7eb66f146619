// Leaves that act on the robot's programs and on its human supervisors, and the interfaces that
// they need.
#ifndef COPPICE_BT_NODES_PROCESSES_SUPERVISION_LEAVES_H_
#define COPPICE_BT_NODES_PROCESSES_SUPERVISION_LEAVES_H_

#include <string>

#include "bt_nodes/basics/capability_action.h"

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
  /// The last step: stops everything and switches off, as far as the robot is set up for that.
  /// `done`: ok when it has begun.
  virtual void SwitchOff(const std::string& reason, Sender<ActionResult> done) = 0;
};

/// The people who look after the robot. Called on the ticking thread; returns at once.
///
/// A request is known by its subject, for example "navigation" or "node /docking"; there is one
/// request for each subject at most, and any number of subjects at the same time.
class SupervisorChannel {
 public:
  virtual ~SupervisorChannel() = default;
  /// Opens a request about a subject, or joins the one that is open; the newest question and sender
  /// count. `done`, from any thread and once: ok when a person has confirmed that it is fixed; not
  /// ok when nobody could fix it or nobody answered in time. With the answer the request is closed.
  virtual void Ask(const std::string& subject, const std::string& question,
                   Sender<ActionResult> done) = 0;
  /// The fault has gone: closes the request, tells those who were asked (all-clear), and the sender
  /// is not used any more. Without effect if no request about the subject is open.
  virtual void Withdraw(const std::string& subject) = 0;
  /// A message that asks nothing and needs no answer.
  virtual void Tell(const std::string& subject, const std::string& message) = 0;
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
  Input<std::string> subject{this, "subject", "what the request is about; one request for each"};
  Input<std::string> question{this, "question", "what is wrong and what to do"};

 protected:
  void Begin(Sender<ActionResult> done) override {
    asked_about_ = *subject;
    channel_.Ask(asked_about_, *question, done);
  }
  void Cancel() override { channel_.Withdraw(asked_about_); }

 private:
  SupervisorChannel& channel_;
  std::string asked_about_;
};

class TellSupervisor : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Sends a message to the robot's supervisors that asks nothing.";
  explicit TellSupervisor(SupervisorChannel& channel) : channel_(channel) {}
  Input<std::string> subject{this, "subject", "what the message is about"};
  Input<std::string> message{this, "message", "what to tell"};
  Status Run() override {
    channel_.Tell(*subject, *message);
    return Status::kSuccess;
  }

 private:
  SupervisorChannel& channel_;
};

}  // namespace coppice

#endif  // COPPICE_BT_NODES_PROCESSES_SUPERVISION_LEAVES_H_
