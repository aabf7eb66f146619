#include "bt_core/frames/follower.h"

#include <utility>

namespace coppice {

HistoryFollower::HistoryFollower(TreeShape shape, const HistoryState& state)
    : statuses_(std::move(shape), state.statuses, state.last),
      tick_(state.tick),
      time_(state.time),
      values_(state.values) {}

void HistoryFollower::Set(const HistoryState& state) {
  *this = HistoryFollower(statuses_.shape(), state);
}

void HistoryFollower::Apply(const TickEvents& events) {
  Apply(
      events, [](const StatusChange&) {}, [](const Event&) {});
}

// A tick that stands at a breakpoint has nodes whose parents are not yet what they will be.
void HistoryFollower::Note(const TickEvents& events) {
  if (!events.is_whole) return Apply(events);
  Pass(events);
  is_noted_ = true;
  ForEachRun(
      events.words,
      [this](const std::uint32_t* at, const std::uint32_t* end) { return statuses_.Note(at, end); },
      [this](const Event& event) { ApplyWrite(event); });
}

void HistoryFollower::Settle() {
  if (std::exchange(is_noted_, false)) statuses_.Settle();
}

// What a follower knows of the children that were ticked last is the same after each of these
// calls, so equal statuses are the whole of its state.
bool HistoryFollower::ApplyAgain(const TickEvents& events) {
  Settle();
  const std::vector<Status> statuses = statuses_.statuses();
  const std::vector<Status> lasts = statuses_.lasts();
  Apply(events);
  return statuses == statuses_.statuses() && lasts == statuses_.lasts();
}

void HistoryFollower::ApplyWrite(const Event& event) {
  const bool is_write = event.code == EventCode::kWrite || event.code == EventCode::kDelivery;
  if (is_write && event.index < values_.size()) values_[event.index].assign(event.bytes);
}

std::vector<Status> HistoryFollower::LastsWith(const std::vector<Status>& statuses) const {
  std::vector<Status> lasts = statuses_.lasts();
  for (std::size_t i = 0; i < statuses.size() && i < lasts.size(); ++i) {
    if (statuses[i] != Status::kIdle) lasts[i] = statuses[i];
  }
  return lasts;
}

HistoryState HistoryFollower::State(HistoryState::Cause cause) const {
  return {cause, tick_, time_, statuses_.statuses(), statuses_.lasts(), values_};
}

}  // namespace coppice
