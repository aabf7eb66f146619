// What becomes of the nodes that somebody has chosen (node_hooks.h).
#include <algorithm>

#include "bt_core/engine/executor.h"

namespace coppice {

void Executor::SetHooks(NodeHooks* hooks, const std::vector<NodeIndex>& nodes) {
  KeepPretending(nodes);
  nodes_ = hooked_.Choose(hooks, nodes, *program_);
}

// What hooks throw counts as thrown by the node.
Status Executor::TickHooked(NodeIndex node) {
  try {
    const std::optional<Status> before = hooked_.hooks()->Before(node);
    if (before) return Inject(node, *before);
    if (hooked_.StopPretending(node)) statuses_[node] = Status::kIdle;
    const Status result = TickAsItself(node);
    const std::optional<Status> after = hooked_.hooks()->After(node, result);
    return after && *after != result ? Inject(node, *after) : result;
  } catch (const Abort&) {
    throw;
  } catch (...) {
    const Status result = FailByException(node);
    if (statuses_[node] == Status::kRunning) HaltRunning(node);
    return Store(node, result);
  }
}

Status Executor::Inject(NodeIndex node, Status status) {
  const bool begins = statuses_[node] != Status::kRunning && status == Status::kRunning;
  if (statuses_[node] == Status::kRunning && status != Status::kRunning) HaltRunning(node);
  const char byte = static_cast<char>(status);
  reporter_.Text(node, EventText::kInjected, std::string_view(&byte, 1));
  if (begins) {
    if (kept_ != 0) LetGo(node);
    ResetChildren(node);
    hooked_.Pretend(node);
  }
  return Store(node, status);
}

// Nobody will ask for the others any more: they begin when they are ticked.
void Executor::KeepPretending(const std::vector<NodeIndex>& nodes) {
  for (const NodeIndex node : std::vector<NodeIndex>(hooked_.pretending())) {
    const bool stays = std::find(nodes.begin(), nodes.end(), node) != nodes.end();
    if (!stays && hooked_.StopPretending(node)) MakeIdle(node);
  }
}

}  // namespace coppice
