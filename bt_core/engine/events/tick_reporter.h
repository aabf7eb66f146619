// What the watchers on the ticking thread get to know: collects the events of a tick
// (event_words.h) and hands them to the sinks. While there are none, each call is one branch.
#ifndef COPPICE_BT_CORE_ENGINE_EVENTS_TICK_REPORTER_H_
#define COPPICE_BT_CORE_ENGINE_EVENTS_TICK_REPORTER_H_

#include <chrono>
#include <cstdint>
#include <string_view>
#include <vector>

#include "bt_core/engine/events.h"
#include "bt_core/engine/program.h"

namespace coppice {

/// Which slots each node may write, so that after its tick only those need a look: those of node i
/// are slots[first[i]] .. slots[first[i + 1]], of its output and inout ports, and those that its
/// scripts, guards and hooks assign.
struct WrittenSlots {
  std::vector<std::uint32_t> first;
  std::vector<SlotIndex> slots;
};

WrittenSlots WrittenSlotsOf(const Program& program);

class TickReporter {
 public:
  /// The blackboard of the tree. It must live as long, wherever its slots lie.
  explicit TickReporter(const Blackboard& blackboard) : blackboard_(blackboard) {}

  void Add(TickSink* sink, const Program& program);
  void Remove(TickSink* sink);
  bool is_listening() const { return listening_; }

  /// The result of a node, behind what it has written, which goes to `statuses` as well. Only while
  /// somebody listens.
  Status Store(Status* statuses, NodeIndex node, Status result);
  void Reset(NodeIndex node) {
    if (listening_) events_.Reset(node);
  }
  /// The slots that this node has written since they were looked at last.
  void Writes(NodeIndex node) {
    if (listening_) AddWrites(node);
  }
  void Delivery(SlotIndex slot) {
    if (listening_) AddDelivery(slot);
  }
  void Text(NodeIndex node, EventText kind, std::string_view text) {
    if (listening_) AddText(node, kind, text);
  }

  void BeginTick() {
    if (listening_) begin_ = std::chrono::steady_clock::now();
  }
  /// `tick` and `now` go to the sinks: number and time of the tick. Only while somebody listens.
  void EndTick(std::uint64_t tick, Time now, Status result);
  /// After a halt: nothing, if nothing has happened.
  void EndHalt(std::uint64_t tick, Time now);
  /// Within a tick.
  void SoFar(std::uint64_t tick, Time now);
  void Jump(const Executor& executor);

 private:
  void Start(const Program& program);
  Status StoreBehindWrites(Status* statuses, NodeIndex node, Status result);
  void AddWrites(NodeIndex node);
  void AddWrite(SlotIndex slot, NodeIndex writer);
  void AddDelivery(SlotIndex slot);
  void AddText(NodeIndex node, EventText kind, std::string_view text);
  void Report(const TickEvents& events);

  const Blackboard& blackboard_;
  bool listening_ = false;  // there are sinks; the others are in use then
  std::vector<TickSink*> sinks_;
  EventWriter events_;  // since the last report
  WrittenSlots written_;
  std::vector<std::uint32_t> reported_writes_;  // per slot: how many writes were reported
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_EVENTS_TICK_REPORTER_H_
