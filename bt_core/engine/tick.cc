// One tick of every kind of node. Most time is spent here, so the nodes that trees are made of have
// a function each, a leaf is called straight from the loop of its parent, and what only watchers
// need costs one branch.
#include <array>
#include <utility>

#include "bt_core/engine/executor.h"
#include "bt_core/nodes/control.h"
#include "bt_core/nodes/script_nodes.h"

namespace coppice {

/// The functions by NodeRecord::dispatch.
struct Executor::TickTable {
  using Function = Status (*)(Executor&, NodeIndex);
  static constexpr std::size_t kCount = static_cast<std::size_t>(NodeType::kHooked) + 1;
  static const std::array<Function, kCount> functions;

  static Status Call(Executor& executor, NodeIndex node, NodeType dispatch) {
    return functions[static_cast<std::size_t>(dispatch)](executor, node);
  }

  // The Tree of nodes/control.h for the functions below: the executor, with the array of nodes in a
  // register.
  class Tree {
   public:
    explicit Tree(Executor& executor) : executor_(executor), nodes_(executor.nodes_) {}

    Status Tick(NodeIndex node) {
      const NodeRecord& record = nodes_[node];
      if (record.dispatch != NodeType::kLeaf) return Call(executor_, node, record.dispatch);
      return TickLeaf(executor_, node, record.first_port);
    }
    void Halt(NodeIndex node) { executor_.Halt(node); }
    void ResetChildren(NodeIndex node) { executor_.ResetChildren(node); }
    void ChildrenAreIdle(NodeIndex node) {
      if (executor_.resets_children_) executor_.ResetChildren(node);
    }
    void LetGo(NodeIndex child) {
      if (executor_.kept_ != 0) executor_.LetGo(child);
    }
    std::uint64_t& memory(NodeIndex node) { return executor_.memory_[node]; }
    Status status(NodeIndex node) const { return executor_.statuses_[node]; }
    NodeIndex EndOf(NodeIndex node) const { return nodes_[node].end; }

   private:
    Executor& executor_;
    const NodeRecord* const nodes_;
  };

  static Status TickLeaf(Executor& executor, NodeIndex node, std::uint32_t number) {
    const User& user = executor.users_[number];
    executor.current_ = node;
    Status result;
    try {
      result = user.tick(*user.node, executor.statuses_[node]);
    } catch (...) {
      result = executor.FailByException(node);
    }
    return executor.Store(node, result);
  }

  static Status Leaf(Executor& executor, NodeIndex node) {
    return TickLeaf(executor, node, executor.nodes_[node].first_port);
  }

  template <Status (*kTick)(Tree&, NodeIndex)>
  static Status Control(Executor& executor, NodeIndex node) {
    Tree tree(executor);
    return executor.Store(node, kTick(tree, node));
  }

  template <Status kOnSuccess, Status kOnFailure>
  static Status Mapped(Executor& executor, NodeIndex node) {
    Tree tree(executor);
    Status result = tree.Tick(node + 1);
    if (IsCompleted(result)) tree.ChildrenAreIdle(node);
    if (result == Status::kSuccess) {
      result = kOnSuccess;
    } else if (result == Status::kFailure) {
      result = kOnFailure;
    }
    return executor.Store(node, result);
  }

  template <Status kResult>
  static Status Constant(Executor& executor, NodeIndex node) {
    return executor.Store(node, kResult);
  }

  static Status UserControlNode(Executor& executor, NodeIndex node) {
    const Status result = TickLeaf(executor, node, executor.nodes_[node].first_port);
    if (result != Status::kRunning) executor.ResetChildren(node);
    return result;
  }

  static Status ScriptCondition(Executor& executor, NodeIndex node) {
    Status result;
    try {
      result = TickScriptCondition(executor, node);
    } catch (...) {
      result = executor.FailByException(node);
    }
    return executor.Store(node, result);
  }

  static Status Guarded(Executor& executor, NodeIndex node) {
    return executor.TickGuarded(node, false);
  }

  static Status Hooked(Executor& executor, NodeIndex node) {
    return executor.IsGuarded(node) ? executor.TickGuarded(node, true) : executor.TickHooked(node);
  }

  static Status Other(Executor& executor, NodeIndex node) {
    if (executor.kept_ != 0) executor.Resume(node);
    Status result;
    try {
      result = executor.DispatchOthers(node, executor.nodes_[node].type);
    } catch (const Abort&) {
      throw;
    } catch (...) {
      executor.ResetChildren(node);
      result = executor.FailByException(node);
    }
    if (IsCompleted(result)) executor.memory_[node] = 0;
    if (result == Status::kSkipped) executor.KeepSomeMemory(node);
    return executor.Store(node, result);
  }

  static constexpr std::array<Function, kCount> Make() {
    std::array<Function, kCount> all{};
    for (Function& function : all) function = &Other;
    const auto set = [&all](NodeType type, Function function) {
      all[static_cast<std::size_t>(type)] = function;
    };
    set(NodeType::kSequence, &Control<&TickSequence<Tree>>);
    set(NodeType::kFallback, &Control<&TickFallback<Tree>>);
    set(NodeType::kReactiveSequence, &Control<&TickReactiveSequence<Tree>>);
    set(NodeType::kReactiveFallback, &Control<&TickReactiveFallback<Tree>>);
    set(NodeType::kInverter, &Mapped<Status::kFailure, Status::kSuccess>);
    set(NodeType::kForceSuccess, &Mapped<Status::kSuccess, Status::kSuccess>);
    set(NodeType::kForceFailure, &Mapped<Status::kFailure, Status::kFailure>);
    set(NodeType::kSubTree, &Mapped<Status::kSuccess, Status::kFailure>);
    set(NodeType::kAlwaysSuccess, &Constant<Status::kSuccess>);
    set(NodeType::kAlwaysFailure, &Constant<Status::kFailure>);
    set(NodeType::kScriptCondition, &ScriptCondition);
    set(NodeType::kLeaf, &Leaf);
    set(NodeType::kUser, &UserControlNode);
    set(NodeType::kGuarded, &Guarded);
    set(NodeType::kHooked, &Hooked);
    return all;
  }
};

const std::array<Executor::TickTable::Function, Executor::TickTable::kCount>
    Executor::TickTable::functions = Make();

Status Executor::Tick(NodeIndex node) {
  reporter_.Writes(program_->info[node].parent);
  return TickTable::Call(*this, node, nodes_[node].dispatch);
}

Status Executor::TickAsItself(NodeIndex node) {
  return TickTable::Call(*this, node, nodes_[node].type);
}

// For the user's control nodes: what they say or start afterwards is theirs, not the child's.
Status Executor::TickChild(NodeIndex node) {
  const NodeIndex caller = current_;
  const Status result = Tick(node);
  current_ = caller;
  return result;
}

void Executor::HaltChild(NodeIndex node) {
  const NodeIndex caller = current_;
  if (statuses_[node] != Status::kIdle) reporter_.Writes(caller);
  Halt(node);
  current_ = caller;
}

}  // namespace coppice
