#include "bt_core/engine/events/tick_reporter.h"

#include <algorithm>

#include "bt_core/engine/executor.h"

namespace coppice {
namespace {

void AddScript(const Program& program, ScriptIndex script, std::vector<SlotIndex>& slots) {
  if (script == kNoScript) return;
  const std::vector<SlotIndex>& writes = program.scripts[script].writes();
  slots.insert(slots.end(), writes.begin(), writes.end());
}

void AddPorts(const Program& program, NodeIndex node, std::vector<SlotIndex>& slots) {
  const Registry::Entry* entry = program.info[node].entry;
  if (!entry) return;
  const std::uint32_t first = program.FirstPort(node);
  for (std::uint32_t k = 0; k < entry->declarations.size(); ++k) {
    const PortBinding& port = program.ports[first + k];
    const PortDirection direction = entry->declarations[k].direction;
    const bool writes = direction == PortDirection::kOutput || direction == PortDirection::kInOut;
    AddScript(program, port.script, slots);
    if (writes && port.slot != kNoSlot) slots.push_back(port.slot);
  }
}

}  // namespace

WrittenSlots WrittenSlotsOf(const Program& program) {
  WrittenSlots written;
  auto guards = program.guards.begin();
  for (NodeIndex node{0}; node < program.nodes.size(); ++node) {
    written.first.push_back(static_cast<std::uint32_t>(written.slots.size()));
    AddPorts(program, node, written.slots);
    if (guards == program.guards.end() || guards->node != node) continue;
    for (const ScriptIndex script : guards->scripts) AddScript(program, script, written.slots);
    ++guards;
  }
  written.first.push_back(static_cast<std::uint32_t>(written.slots.size()));
  return written;
}

void TickReporter::Add(TickSink* sink, const Program& program) {
  sinks_.push_back(sink);
  if (!listening_) Start(program);
}

void TickReporter::Remove(TickSink* sink) {
  sinks_.erase(std::remove(sinks_.begin(), sinks_.end(), sink), sinks_.end());
  listening_ = !sinks_.empty();
  events_.Clear();
}

void TickReporter::Start(const Program& program) {
  listening_ = true;
  written_ = WrittenSlotsOf(program);
  reported_writes_.clear();
  for (const Slot& slot : blackboard_) reported_writes_.push_back(slot.writes);
  events_.Clear();
}

// Most nodes write nothing; those that do are left to another function, so that this one is short.
Status TickReporter::Store(Status* statuses, NodeIndex node, Status result) {
  const std::uint32_t* const first = written_.first.data() + node;
  if (first[0] != first[1] || !events_.has_room()) {
    return StoreBehindWrites(statuses, node, result);
  }
  events_.Status(node, result);
  return statuses[node] = result;
}

[[gnu::noinline]] Status TickReporter::StoreBehindWrites(Status* statuses, NodeIndex node,
                                                         Status result) {
  AddWrites(node);
  events_.Status(node, result);
  return statuses[node] = result;
}

void TickReporter::AddWrites(NodeIndex node) {
  const std::uint32_t end = written_.first[node + 1];
  for (std::uint32_t i = written_.first[node]; i != end; ++i) AddWrite(written_.slots[i], node);
}

void TickReporter::AddWrite(SlotIndex slot, NodeIndex writer) {
  if (blackboard_[slot].writes == reported_writes_[slot]) return;
  reported_writes_[slot] = blackboard_[slot].writes;
  events_.Write(slot, writer, blackboard_[slot].value);
}

void TickReporter::AddDelivery(SlotIndex slot) {
  reported_writes_[slot] = blackboard_[slot].writes;
  events_.Delivery(slot, blackboard_[slot].value);
}

void TickReporter::AddText(NodeIndex node, EventText kind, std::string_view text) {
  AddWrites(node);
  events_.Text(node, kind, text);
}

void TickReporter::EndTick(std::uint64_t tick, Time now, Status result) {
  for (SlotIndex slot{0}; slot < blackboard_.size(); ++slot) AddWrite(slot, kNoNode);
  const Duration duration = std::chrono::steady_clock::now() - begin_;
  Report({tick, now, duration, result, true, events_.words()});
}

void TickReporter::EndHalt(std::uint64_t tick, Time now) {
  if (!listening_ || events_.empty()) return;
  Report({tick, now, Duration(0), Status::kIdle, true, events_.words()});
}

void TickReporter::SoFar(std::uint64_t tick, Time now) {
  if (!listening_) return;
  Report({tick, now, Duration(0), Status::kRunning, false, events_.words()});
}

void TickReporter::Report(const TickEvents& events) {
  for (TickSink* sink : sinks_) sink->OnTick(events);
  events_.Clear();
}

void TickReporter::Jump(const Executor& executor) {
  if (!listening_) return;
  Start(executor.program());
  for (TickSink* sink : sinks_) sink->OnJump(executor);
}

}  // namespace coppice
