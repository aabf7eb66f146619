// Ticks the child once for each element of a queue of the user's type.
//
//   factory.registerNodeType<BT::LoopNode<Pose2D>>("LoopPose");
//
// LoopInt, LoopBool, LoopDouble and LoopString are built in.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "behaviortree_cpp/decorator_node.h"

namespace BT {

template <class T>
using SharedQueue = std::shared_ptr<std::deque<T>>;

/// "1;2;3" as a queue of any type whose elements have a text.
template <class T>
SharedQueue<T> ReadQueue(StringView text) {
  auto queue = std::make_shared<std::deque<T>>();
  for (const StringView part : splitString(text, ';')) {
    queue->push_back(convertFromString<T>(part));
  }
  return queue;
}

/// Takes the first element of `queue`, which loses it, writes it to `value` and ticks the child.
/// FAILURE of the child ends the loop. RUNNING after each element; `if_empty` when none is left.
template <class T = Any>
class LoopNode : public DecoratorNode {
 public:
  LoopNode(const std::string& name, const NodeConfig& config) : DecoratorNode(name, config) {}

  static PortsList providedPorts() {
    return {BidirectionalPort("queue"),
            InputPort<NodeStatus>("if_empty", NodeStatus::SUCCESS,
                                  "Status to return if queue is empty: SUCCESS, FAILURE, SKIPPED"),
            OutputPort<T>("value")};
  }

 private:
  NodeStatus tick() override {
    if (status() == NodeStatus::IDLE) {
      child_runs_ = false;
      queue_ = FindQueue();
    }
    setStatus(NodeStatus::RUNNING);
    if (!child_runs_ && !TakeNext()) {
      return getInput<NodeStatus>("if_empty").value_or(NodeStatus::SUCCESS);
    }
    const NodeStatus result = child_node_->executeTick();
    child_runs_ = result == NodeStatus::RUNNING;
    if (isStatusCompleted(result)) resetChild();
    if (result == NodeStatus::FAILURE) return NodeStatus::FAILURE;
    if (!child_runs_) emitWakeUpSignal();
    return NodeStatus::RUNNING;
  }

  bool TakeNext() {
    if (SharedQueue<T> present = QueueOfKey()) queue_ = std::move(present);
    if (!queue_ || queue_->empty()) return false;
    const T value = std::move(queue_->front());
    queue_->pop_front();
    setOutput("value", value);
    return true;
  }

  // Somebody may have written another one meanwhile.
  SharedQueue<T> QueueOfKey() {
    AnyPtrLocked any = getLockedPortContent("queue");
    if (!any || any->empty()) return nullptr;
    return any->template tryCast<SharedQueue<T>>().value_or(nullptr);
  }

  SharedQueue<T> FindQueue() {
    SharedQueue<T> queue;
    if (getInput("queue", queue) && queue) return queue;
    std::vector<T> list;
    if (!getInput("queue", list)) return nullptr;
    return std::make_shared<std::deque<T>>(list.begin(), list.end());
  }

  SharedQueue<T> queue_;
  bool child_runs_ = false;
};

template <>
inline SharedQueue<int> convertFromString<SharedQueue<int>>(StringView text) {
  return ReadQueue<int>(text);
}
template <>
inline SharedQueue<bool> convertFromString<SharedQueue<bool>>(StringView text) {
  return ReadQueue<bool>(text);
}
template <>
inline SharedQueue<double> convertFromString<SharedQueue<double>>(StringView text) {
  return ReadQueue<double>(text);
}
template <>
inline SharedQueue<std::string> convertFromString<SharedQueue<std::string>>(StringView text) {
  return ReadQueue<std::string>(text);
}

}  // namespace BT
