// What watchers get to know (events.h). All of this runs only while somebody listens.
#include <algorithm>

#include "bt_core/engine/executor.h"

namespace coppice {

void Executor::AddSink(TickSink* sink) {
  sinks_.push_back(sink);
  if (!listening_) StartListening();
}

void Executor::RemoveSink(TickSink* sink) {
  sinks_.erase(std::remove(sinks_.begin(), sinks_.end(), sink), sinks_.end());
  listening_ = !sinks_.empty();
  events_.Clear();
}

void Executor::StartListening() {
  listening_ = true;
  written_slots_ = WrittenSlotsOf(*program_);
  reported_writes_.clear();
  for (const Slot& slot : blackboard_) reported_writes_.push_back(slot.writes);
  events_.Clear();
}

// Most nodes write nothing; those that do are left to another function, so that this one is short.
Status Executor::StoreAndReport(NodeIndex node, Status result) {
  const std::uint32_t* const first = written_slots_.first.data() + node;
  if (first[0] != first[1] || !events_.has_room()) return StoreAndReportWrites(node, result);
  events_.Status(node, result);
  return statuses_[node] = result;
}

Status Executor::StoreAndReportWrites(NodeIndex node, Status result) {
  ReportWrites(node);
  events_.Status(node, result);
  return statuses_[node] = result;
}

// The slots that this node has written since they were looked at last.
void Executor::ReportWrites(NodeIndex node) {
  const std::uint32_t end = written_slots_.first[node + 1];
  for (std::uint32_t i = written_slots_.first[node]; i != end; ++i) {
    ReportWrite(written_slots_.slots[i], node);
  }
}

void Executor::ReportWrite(SlotIndex slot, NodeIndex writer) {
  if (blackboard_[slot].writes == reported_writes_[slot]) return;
  reported_writes_[slot] = blackboard_[slot].writes;
  events_.Write(slot, writer, blackboard_[slot].value);
}

void Executor::ReportDelivery(SlotIndex slot) {
  reported_writes_[slot] = blackboard_[slot].writes;
  events_.Delivery(slot, blackboard_[slot].value);
}

void Executor::AddMessage(std::string text) {
  if (!listening_) return;
  ReportWrites(current_);
  events_.Text(current_, EventText::kMessage, text);
}

void Executor::AddException(NodeIndex node, const std::string& text) {
  if (!listening_) return;
  ReportWrites(node);
  events_.Text(node, EventText::kException, text);
}

void Executor::ReportTick(Status result) {
  for (SlotIndex slot = 0; slot < blackboard_.size(); ++slot) ReportWrite(slot, kNoNode);
  Report(result, std::chrono::steady_clock::now() - tick_start_, true);
}

void Executor::ReportHalt() {
  if (listening_ && !events_.empty()) Report(Status::kIdle, Duration(0), true);
}

void Executor::ReportSoFar() {
  if (listening_) Report(Status::kRunning, Duration(0), false);
}

void Executor::Report(Status result, Duration duration, bool is_whole) {
  const TickEvents events{ticks_, now_, duration, result, is_whole, events_.words()};
  for (TickSink* sink : sinks_) sink->OnTick(events);
  events_.Clear();
}

void Executor::ReportJump() {
  if (!listening_) return;
  StartListening();
  for (TickSink* sink : sinks_) sink->OnJump(*this);
}

}  // namespace coppice
