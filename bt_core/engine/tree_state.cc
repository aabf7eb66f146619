#include "bt_core/engine/tree_state.h"

#include <stdexcept>

#include "bt_core/engine/executor.h"

namespace coppice {

TreeState Executor::Save() const { return {statuses(), memory_, blackboard_}; }

void Executor::Restore(const TreeState& state) {
  if (state.statuses.size() != statuses_.size() || state.blackboard.size() != blackboard_.size()) {
    throw std::invalid_argument("the state is that of another tree");
  }
  KeepPretending({});
  statuses_ = statuses();
  for (NodeIndex i = 0; i < statuses_.size(); ++i) {
    const bool is_user = IsUserNode(nodes_[i].type);
    Status status = state.statuses[i];
    if (is_user && statuses_[i] == Status::kRunning && status != Status::kRunning) HaltUser(i);
    // A node of the user that does not run cannot be made to: the next tick starts it.
    if (is_user && statuses_[i] != Status::kRunning && status == Status::kRunning) {
      status = Status::kIdle;
    }
    statuses_[i] = status;
  }
  // What a node of the user has begun is known to that node only.
  for (NodeIndex i = 0; i < memory_.size(); ++i) {
    if (!IsUserNode(nodes_[i].type)) memory_[i] = state.memory[i];
  }
  CountKept();
  RestoreBlackboard(state.blackboard);
  ReportJump();
}

// Mailboxes of user nodes belong to what those remember.
void Executor::RestoreBlackboard(const Blackboard& saved) {
  std::vector<bool> is_mailbox(blackboard_.size(), false);
  for (const LeafRecord& leaf : program_->leaves) {
    const Registry::Entry* entry = program_->info[leaf.node].entry;
    if (!entry) continue;
    for (std::size_t k = 0; k < entry->declarations.size(); ++k) {
      if (entry->declarations[k].direction != PortDirection::kMailbox) continue;
      is_mailbox[program_->ports[leaf.first_port + k].slot] = true;
    }
  }
  for (SlotIndex i = 0; i < blackboard_.size(); ++i) {
    if (is_mailbox[i]) continue;
    blackboard_[i] = saved[i];
  }
}

}  // namespace coppice
