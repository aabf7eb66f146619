// The state of a tree as a value: taken out and put in again.
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
  for (NodeIndex i{0}; i < statuses_.size(); ++i) {
    if (IsUserNode(nodes_[i].type)) {
      RestoreUser(i, state);
    } else {
      statuses_[i] = state.statuses[i];
      memory_[i] = state.memory[i];
    }
  }
  CountKept();
  RestoreBlackboard(state.blackboard);
  if (statuses_[0] == Status::kRunning) tick_again_ = true;  // timers are armed by a tick
  reporter_.Jump(*this);
}

// Only the node knows what it has begun: it can go on or be halted, but not be made to run.
void Executor::RestoreUser(NodeIndex node, const TreeState& state) {
  const bool had_begun = state.statuses[node] == Status::kRunning || state.memory[node] != 0;
  const bool goes_on = had_begun && HasBegun(node);
  if (!goes_on && (statuses_[node] == Status::kRunning || Keeps(node))) HaltUser(node);
  const bool must_start = !goes_on && state.statuses[node] == Status::kRunning;
  statuses_[node] = must_start ? Status::kIdle : state.statuses[node];
  memory_[node] = goes_on ? state.memory[node] : 0;
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
  for (SlotIndex i{0}; i < blackboard_.size(); ++i) {
    if (is_mailbox[i]) continue;
    blackboard_[i] = saved[i];
  }
}

}  // namespace coppice
