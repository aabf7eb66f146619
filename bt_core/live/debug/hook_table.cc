#include "bt_core/live/debug/hook_table.h"

#include <algorithm>

#include "bt_core/live/debug/hook_condition.h"
#include "bt_core/live/debug/hook_nodes.h"

namespace coppice {
namespace {

constexpr std::size_t kShownPath = 200;  // bytes, of a hook that there is no room for

// Wrong in any tree.
Outcome CheckAnywhere(const Hook& hook) {
  if (hook.path.empty() && hook.node == kNoNode) return Problem{"a hook needs a node or a path"};
  if (hook.action == HookAction::kReplace && hook.status == Status::kIdle) {
    return Problem{"IDLE is no result; expected RUNNING, SUCCESS, FAILURE or SKIPPED"};
  }
  if (hook.action == HookAction::kDelay && hook.position == HookPosition::kAfter) {
    return Problem{"a node can be delayed only before it is ticked"};
  }
  if (hook.action == HookAction::kDelay && hook.delay <= Duration::zero()) {
    return Problem{"a delay must be longer than 0"};
  }
  if (hook.from_hit == 0) return Problem{"hits are counted from 1"};
  return {};
}

}  // namespace

Expected<HookAnswer> HookTable::Add(const Hook& hook, OwnerId owner) {
  if (entries_.size() >= kMaxHooks) {
    return Problem{"there are " + std::to_string(kMaxHooks) + " hooks already"};
  }
  if (const Outcome checked = Check(hook); !checked) return Problem{checked.problem()};
  Entry entry;
  entry.info.id = last_id_ + 1;
  entry.info.owner = owner;
  entry.info.hook = hook;
  Expected<HookAnswer> answer = Resolve(entry);
  if (!answer) return answer;
  if (const Outcome room = CheckRoom(entry); !room) return Problem{room.problem()};
  ++last_id_;
  entries_.push_back(std::move(entry));
  RebuildPlaces();
  return answer;
}

Expected<HookAnswer> HookTable::Change(HookId id, const Hook& hook) {
  Entry* const old = Find(id);
  if (!old) return Problem{"there is no hook " + std::to_string(id)};
  if (const Outcome checked = Check(hook); !checked) return Problem{checked.problem()};
  Entry entry;
  entry.info.id = id;
  entry.info.owner = old->info.owner;
  entry.info.hook = hook;
  Expected<HookAnswer> answer = Resolve(entry);
  if (!answer) return answer;
  if (const Outcome room = CheckRoom(entry); !room) return Problem{room.problem()};
  *old = std::move(entry);
  RebuildPlaces();
  return answer;
}

bool HookTable::Remove(HookId id) {
  const Entry* const entry = Find(id);
  if (!entry) return false;
  entries_.erase(entries_.begin() + (entry - entries_.data()));
  RebuildPlaces();
  return true;
}

void HookTable::SetProgram(std::shared_ptr<const Program> program) {
  const std::shared_ptr<const Program> old = std::exchange(program_, std::move(program));
  for (Entry& entry : entries_) {
    Hook& hook = entry.info.hook;
    if (hook.path.empty()) hook.path = old->Path(std::exchange(hook.node, kNoNode));
    entry.delayed.clear();
    entry.info.problem = Resolve(entry).problem();
    if (const Outcome room = CheckRoom(entry); !room) {
      entry.info.nodes.clear();
      entry.info.problem = room.problem();
      hook.path.resize(std::min(hook.path.size(), kShownPath));
    }
  }
  RebuildPlaces();
}

const HookTable::Entry* HookTable::Find(HookId id) const {
  const auto at = std::lower_bound(entries_.begin(), entries_.end(), id,
                                   [](const Entry& e, HookId key) { return e.info.id < key; });
  return at != entries_.end() && at->info.id == id ? &*at : nullptr;
}

std::vector<HookId> HookTable::IdsOf(OwnerId owner) const {
  std::vector<HookId> ids;
  for (const Entry& entry : entries_) {
    if (entry.info.owner == owner) ids.push_back(entry.info.id);
  }
  return ids;
}

std::vector<HookId> HookTable::At(NodeIndex node, HookPosition position) const {
  std::vector<std::pair<HookAction, HookId>> found;
  const auto at_node =
      std::lower_bound(places_.begin(), places_.end(), std::make_pair(node, kNoHook));
  for (auto at = at_node; at != places_.end() && at->first == node; ++at) {
    const Entry& entry = *Find(at->second);
    const Hook& hook = entry.info.hook;
    if (hook.enabled && hook.position == position) found.emplace_back(hook.action, at->second);
  }
  std::sort(found.begin(), found.end());
  std::vector<HookId> ids;
  for (const auto& [action, id] : found) ids.push_back(id);
  return ids;
}

std::vector<NodeIndex> HookTable::Nodes() const {
  std::vector<NodeIndex> nodes;
  for (const auto& [node, id] : places_) {
    if (nodes.empty() || nodes.back() != node) nodes.push_back(node);
  }
  return nodes;
}

Outcome HookTable::Check(const Hook& hook) const {
  if (Outcome anywhere = CheckAnywhere(hook); !anywhere) return anywhere;
  const std::size_t nodes = program_->nodes.size();
  if (hook.path.empty() && hook.node >= nodes) {
    return Problem{"there is no node " + std::to_string(hook.node) +
                   "; the tree has the nodes 0 to " + std::to_string(nodes - 1)};
  }
  return {};
}

// A path may mean each node of a large tree, and the list of all hooks is told in one answer.
Outcome HookTable::CheckRoom(const Entry& entry) const {
  const auto text_of = [](const Hook& hook) { return hook.path.size() + hook.condition.size(); };
  std::size_t text = text_of(entry.info.hook);
  std::size_t places = entry.info.nodes.size();
  for (const Entry& other : entries_) {
    if (other.info.id == entry.info.id) continue;
    text += text_of(other.info.hook);
    places += other.info.nodes.size();
  }
  if (text > kMaxTextBytes) return Problem{"the paths and conditions of all hooks are too long"};
  if (places > kMaxPlaces) {
    return Problem{"all hooks together would be at more than " + std::to_string(kMaxPlaces) +
                   " nodes"};
  }
  return {};
}

// Finds its nodes and compiles its condition for them. A hook whose condition is wrong here has no
// nodes.
Expected<HookAnswer> HookTable::Resolve(Entry& entry) const {
  HookInfo& info = entry.info;
  info.nodes = info.hook.path.empty() ? std::vector<NodeIndex>{info.hook.node}
                                      : FindNodes(*program_, info.hook.path);
  entry.condition.reset();
  HookAnswer answer{info.id, {}};
  if (info.nodes.empty()) answer.remark = DescribeMissingNode(*program_, info.hook.path);
  if (info.hook.condition.empty()) return answer;
  if (info.nodes.empty()) {
    const Outcome read =
        CheckCondition(info.hook.condition, program_->registry->script_constants());
    if (!read) return Problem{read.problem()};
    return answer;
  }
  const ScopeIndex scope = program_->info[info.nodes[0]].scope;
  Expected<Script> condition = CompileCondition(info.hook.condition, *program_, scope);
  if (condition) {
    entry.condition = *std::move(condition);
    return answer;
  }
  info.nodes.clear();
  return Problem{condition.problem()};
}

void HookTable::RebuildPlaces() {
  places_.clear();
  for (const Entry& entry : entries_) {
    for (const NodeIndex node : entry.info.nodes) places_.emplace_back(node, entry.info.id);
  }
  std::sort(places_.begin(), places_.end());
}

}  // namespace coppice
