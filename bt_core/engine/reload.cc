// Swapping the program of a running executor.
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt_core/engine/executor.h"

namespace coppice {
namespace {

constexpr NodeIndex kNone = kNoNode;

bool AreWrittenTheSame(const Program& a, NodeIndex i, const Program& b, NodeIndex k) {
  return a.TagOf(i) == b.TagOf(k);
}

std::uint32_t ChildCountOf(const Program& program, NodeIndex node) {
  std::uint32_t count = 0;
  for (NodeIndex i = node + 1; i < program.nodes[node].end; i = program.nodes[i].end) ++count;
  return count;
}

// The number in `next` of a child of `i` in `old`; 0 for none.
std::uint64_t SameChild(const Program& old, NodeIndex i, std::uint64_t child, const Program& next,
                        NodeIndex k) {
  if (child == 0) return 0;
  NodeIndex same = k + 1;
  for (NodeIndex c = i + 1; c != child; c = old.nodes[c].end) same = next.nodes[same].end;
  return same;
}

// What the other control nodes remember may be numbers of nodes in a way that only they know: they
// live on only where the numbers stay as they are.
bool HasItsNumbers(const Program& old, NodeIndex i, const Program& next, NodeIndex k) {
  if (RunsOneChild(next.nodes[k].type) || ChildCountOf(next, k) < 2) return true;
  NodeIndex child = i + 1;
  for (NodeIndex c = k + 1; c < next.nodes[k].end; c = next.nodes[c].end) {
    if (c != child) return false;
    child = old.nodes[child].end;
  }
  return true;
}

// For each node of `next` the node of `old` that lives on in it, or kNone.
std::vector<NodeIndex> MatchNodes(const Program& old, const Program& next) {
  std::vector<NodeIndex> matches(next.nodes.size(), kNone);
  std::vector<std::pair<NodeIndex, NodeIndex>> open(1);
  while (!open.empty()) {
    const auto [i, k] = open.back();
    open.pop_back();
    if (old.nodes[i].type != next.nodes[k].type || !AreWrittenTheSame(old, i, next, k) ||
        ChildCountOf(old, i) != ChildCountOf(next, k) || !HasItsNumbers(old, i, next, k)) {
      continue;
    }
    matches[k] = i;
    NodeIndex child = i + 1;
    for (NodeIndex c = k + 1; c < next.nodes[k].end; c = next.nodes[c].end) {
      open.emplace_back(child, c);
      child = old.nodes[child].end;
    }
  }
  return matches;
}

// For each slot of `old` its number in `next`, or kNoSlot: keys by scope and name, private slots by
// the node that has lived on.
std::vector<SlotIndex> MatchSlots(const Program& old, const Program& next,
                                  const std::vector<NodeIndex>& nodes) {
  std::vector<SlotIndex> numbers(old.layout.slots.size(), kNoSlot);
  using Name = std::pair<std::string_view, std::string_view>;  // scope, key
  std::map<Name, SlotIndex> keys;
  for (SlotIndex i{0}; i < next.layout.slots.size(); ++i) {
    const SlotDefinition& slot = next.layout.slots[i];
    if (!slot.key.empty()) keys.emplace(Name(next.layout.scopes[slot.scope], slot.key), i);
  }
  for (SlotIndex i{0}; i < numbers.size(); ++i) {
    const SlotDefinition& slot = old.layout.slots[i];
    const auto found = keys.find(Name(old.layout.scopes[slot.scope], slot.key));
    if (slot.key.empty() || found == keys.end()) continue;
    if (next.layout.slots[found->second].type == slot.type) numbers[i] = found->second;
  }
  for (NodeIndex k{0}; k < nodes.size(); ++k) {
    if (nodes[k] == kNone || !next.info[k].entry) continue;
    const auto& declarations = next.info[k].entry->declarations;
    for (std::size_t n = 0; n < declarations.size(); ++n) {
      if (declarations[n].direction != PortDirection::kMailbox) continue;
      const SlotIndex from = old.ports[old.FirstPort(nodes[k]) + n].slot;
      numbers[from] = next.ports[next.FirstPort(k) + n].slot;
    }
  }
  return numbers;
}

}  // namespace

void Executor::Reload(std::shared_ptr<const Program> next) {
  const std::vector<NodeIndex> lives_on = MatchNodes(*program_, *next);
  HaltWhatEnds(lives_on);
  reporter_.EndHalt(ticks_, now_);
  NodeHooks* const hooks = hooked_.hooks();
  SetHooks(nullptr);
  const std::vector<SlotIndex> slots = MatchSlots(*program_, *next, lives_on);
  statuses_ = statuses();

  const std::shared_ptr<const Program> old_program = std::exchange(program_, std::move(next));
  nodes_ = program_->nodes.data();
  MoveBlackboard(slots);
  MoveNodes(*old_program, lives_on);
  inbox_->Renumber(slots);
  if (statuses_[0] == Status::kRunning) tick_again_ = true;  // what is new begins
  reporter_.Jump(*this);
  if (hooks) hooks->OnReload();
}

// A node ends if it does not live on; what runs below it is halted before anything is moved.
void Executor::HaltWhatEnds(const std::vector<NodeIndex>& lives_on) {
  std::vector<bool> ends(statuses_.size(), true);
  for (const NodeIndex old : lives_on) {
    if (old != kNone) ends[old] = false;
  }
  for (NodeIndex i{0}; i < ends.size(); ++i) {
    if (ends[i]) Halt(i);
  }
}

void Executor::MoveBlackboard(const std::vector<SlotIndex>& slots) {
  Blackboard moved = MakeBlackboard(program_->layout);
  for (SlotIndex i{0}; i < slots.size(); ++i) {
    if (slots[i] != kNoSlot) moved[slots[i]] = std::move(blackboard_[i]);
  }
  moved.set_now(blackboard_.now());
  blackboard_ = std::move(moved);
}

void Executor::MoveNodes(const Program& old, const std::vector<NodeIndex>& lives_on) {
  std::vector<Status> statuses = std::exchange(statuses_, {});
  std::vector<std::uint64_t> memory = std::exchange(memory_, {});
  statuses_.assign(program_->nodes.size(), Status::kIdle);
  memory_.assign(program_->nodes.size(), 0);
  for (NodeIndex k{0}; k < lives_on.size(); ++k) {
    if (lives_on[k] == kNone) continue;
    statuses_[k] = statuses[lives_on[k]];
    memory_[k] = RunsOneChild(nodes_[k].type)
                     ? SameChild(old, lives_on[k], memory[lives_on[k]], *program_, k)
                     : memory[lives_on[k]];
  }
  MoveUsers(old, lives_on);
  CountKept();
}

void Executor::MoveUsers(const Program& old, const std::vector<NodeIndex>& lives_on) {
  std::vector<User> users = std::exchange(users_, {});
  const std::vector<PortBase*> ports = std::exchange(user_ports_, {});
  std::vector<Draining> drains = std::exchange(drains_, {});
  std::vector<std::size_t> first_port;  // of each old user node, in `ports`
  std::size_t next = 0;
  for (const LeafRecord& record : old.leaves) {
    first_port.push_back(next);
    const Registry::Entry* entry = old.info[record.node].entry;
    next += entry ? entry->declarations.size() : 0;
  }
  for (const LeafRecord& record : program_->leaves) {
    const NodeIndex from = lives_on[record.node];
    if (from == kNone) {
      BuildUser(record);
      continue;
    }
    const std::uint32_t number = old.nodes[from].first_port;
    users_.push_back(std::move(users[number]));
    for (std::size_t n = first_port[number];
         n < (number + 1 < first_port.size() ? first_port[number + 1] : ports.size()); ++n) {
      user_ports_.push_back(ports[n]);
    }
    BindPorts(record);
    for (Draining& drain : drains) {
      if (drain.node != from || drain.orphan) continue;
      drains_.push_back({record.node, drain.until, drain.tick, nullptr});
      drain.node = kNone;
    }
  }
  for (Draining& drain : drains) {
    if (drain.node == kNone) continue;
    if (!drain.orphan) drain.orphan = std::move(users[old.nodes[drain.node].first_port].node);
    drains_.push_back(std::move(drain));
  }
}

}  // namespace coppice
