// A leaf that starts something on the robot, waits for its end, and cancels it when halted. The
// derived class says what to start and how to cancel it; the waiting is the same for all of them.
#ifndef COPPICE_BT_NODES_BASICS_CAPABILITY_ACTION_H_
#define COPPICE_BT_NODES_BASICS_CAPABILITY_ACTION_H_

#include "bt_core/nodes/leaf.h"
#include "bt_nodes/basics/action_result.h"

namespace coppice::leaves {

class CapabilityAction : public Action {
 public:
  Status OnStart() final {
    Begin(result_.NewSender());
    return Status::kRunning;
  }

  Status OnRunning() final {
    const ActionResult* result = result_.Take();
    if (!result) return Status::kRunning;
    return result->ok ? Status::kSuccess : Fail(result->message);
  }

  void OnHalted() final { Cancel(); }

 protected:
  /// Starts the action; `done` may be used from any thread, once.
  virtual void Begin(Sender<ActionResult> done) = 0;
  virtual void Cancel() = 0;

 private:
  Mailbox<ActionResult> result_{this, "result"};
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_BASICS_CAPABILITY_ACTION_H_
