// A leaf that starts something on the robot, waits for its end, and cancels it when halted. The
// derived class says what to start and how to cancel it; the waiting is the same for all of them.
#ifndef COPPICE_BT_NODES_BASICS_CAPABILITY_ACTION_H_
#define COPPICE_BT_NODES_BASICS_CAPABILITY_ACTION_H_

#include "bt_core/nodes/leaf.h"
#include "bt_nodes/basics/action_result.h"
#include "bt_nodes/basics/turn.h"

namespace coppice::leaves {

class CapabilityAction : public Action {
 public:
  Status OnStart() final {
    if (Turn* const turn = this->turn()) number_ = turn->Begin();
    Begin(result_.NewSender());
    return Status::kRunning;
  }

  Status OnRunning() final {
    const ActionResult* result = result_.Take();
    if (!result) return Status::kRunning;
    return result->ok ? Status::kSuccess : Fail(result->message);
  }

  void OnHalted() final {
    const Turn* const turn = this->turn();
    if (!turn || turn->IsNewest(number_)) Cancel();
  }

 protected:
  /// Starts the action; `done` may be used from any thread, once.
  virtual void Begin(Sender<ActionResult> done) = 0;
  /// Not called when another leaf has begun an action of the same kind since.
  virtual void Cancel() = 0;
  /// Of the actions of which the robot carries out one at a time; null: of no such kind.
  virtual Turn* turn() { return nullptr; }

 private:
  std::uint64_t number_ = 0;
  Mailbox<ActionResult> result_{this, "result"};
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_BASICS_CAPABILITY_ACTION_H_
