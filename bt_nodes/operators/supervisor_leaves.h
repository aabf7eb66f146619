// Leaves that ask the people who look after the robot and wait for them, or only tell them.
#ifndef COPPICE_BT_NODES_OPERATORS_SUPERVISOR_LEAVES_H_
#define COPPICE_BT_NODES_OPERATORS_SUPERVISOR_LEAVES_H_

#include <string>

#include "bt_nodes/basics/capability_action.h"
#include "bt_nodes/operators/supervisor_channel.h"

namespace coppice::leaves {

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

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_OPERATORS_SUPERVISOR_LEAVES_H_
