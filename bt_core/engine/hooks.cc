// Nodes that somebody has chosen (node_hooks.h): they are dispatched as kHooked in a copy of the
// program's records, so the others pay nothing.
#include <algorithm>

#include "bt_core/engine/executor.h"

namespace coppice {

// From within a hook the copy stays where it is: the nodes above are being ticked by it.
void Executor::SetHooks(NodeHooks* hooks, const std::vector<NodeIndex>& nodes) {
  hooks_ = hooks;
  if (!pretending_.empty()) KeepPretending(nodes);
  hooked_nodes_.clear();
  nodes_ = program_->nodes.data();
  if (!hooks || nodes.empty()) return;
  hooked_nodes_ = program_->nodes;
  for (const NodeIndex node : nodes) {
    if (node < hooked_nodes_.size()) hooked_nodes_[node].dispatch = NodeType::kHooked;
  }
  nodes_ = hooked_nodes_.data();
}

Status Executor::TickHooked(NodeIndex node) {
  const std::optional<Status> before = hooks_->Before(node);
  if (before) return Inject(node, *before);
  if (StopPretending(node)) statuses_[node] = Status::kIdle;
  const Status result = TickAsItself(node);
  const std::optional<Status> after = hooks_->After(node, result);
  return after && *after != result ? Inject(node, *after) : result;
}

Status Executor::Inject(NodeIndex node, Status status) {
  const bool begins = statuses_[node] != Status::kRunning && status == Status::kRunning;
  if (statuses_[node] == Status::kRunning && status != Status::kRunning) HaltRunning(node);
  const char byte = static_cast<char>(status);
  reporter_.Text(node, EventText::kInjected, std::string_view(&byte, 1));
  if (begins) {
    if (kept_ != 0) LetGo(node);
    ResetChildren(node);
    pretending_.push_back(node);
  }
  return Store(node, status);
}

// True if it was pretending.
bool Executor::StopPretending(NodeIndex node) {
  if (pretending_.empty()) return false;
  const auto at = std::find(pretending_.begin(), pretending_.end(), node);
  if (at == pretending_.end()) return false;
  pretending_.erase(at);
  return true;
}

// Nobody will ask for the others any more: they begin when they are ticked.
void Executor::KeepPretending(const std::vector<NodeIndex>& nodes) {
  for (const NodeIndex node : std::vector<NodeIndex>(pretending_)) {
    const bool stays = std::find(nodes.begin(), nodes.end(), node) != nodes.end();
    if (!stays && StopPretending(node)) MakeIdle(node);
  }
}

}  // namespace coppice
