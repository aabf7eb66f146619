#include "behaviortree_cpp/action_node.h"

#include <chrono>

namespace BT {

NodeStatus SyncActionNode::executeTick() {
  const NodeStatus status = TickAsItself();
  if (status != NodeStatus::RUNNING) return status;
  throw LogicError("SyncActionNode MUST never return RUNNING");
}

NodeStatus ThreadedAction::executeTick() {
  if (!IsEngineCalling()) return TickThroughEngine();
  if (!result_.valid()) {
    halt_requested_ = false;
    result_ = std::async(std::launch::async, [this] {
      // The tree is roused when the thread ends: then the result is there for it.
      struct AtExit {
        ~AtExit() {
          if (node) node->emitWakeUpSignal();
        }
        ThreadedAction* node = nullptr;
      };
      thread_local AtExit at_exit;
      at_exit.node = this;
      return tick();
    });
  }
  if (result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return NodeStatus::RUNNING;
  }
  return result_.get();
}

void ThreadedAction::halt() {
  halt_requested_ = true;
  if (result_.valid()) result_.wait();
  result_ = {};
  resetStatus();
}

NodeStatus StatefulActionNode::tick() {
  const NodeStatus before = status();
  if (before == NodeStatus::RUNNING) return onRunning();
  halt_requested_ = false;
  return onStart();
}

void StatefulActionNode::halt() {
  halt_requested_ = true;
  if (status() == NodeStatus::RUNNING) onHalted();
  resetStatus();
}

}  // namespace BT
