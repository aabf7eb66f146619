#include "bt_core/live/client/client_history.h"

#include <algorithm>

#include "bt_core/frames/payload_coding.h"

namespace coppice {

bool ClientHistory::Begin(const RunId& run, std::uint64_t first) {
  const bool is_same_run = has_frames_ && run == run_;
  if (is_same_run && first == next_) return true;
  decoder_.Forget();
  has_hole_ = is_same_run;
  has_frames_ = false;
  run_ = run;
  next_ = first;
  return false;
}

Outcome ClientHistory::Add(std::uint64_t first, std::uint64_t next, std::string_view frames) {
  if (first < next_) return Problem{"the robot sent a frame twice"};
  const auto* at = reinterpret_cast<const std::uint8_t*>(frames.data());
  const std::uint8_t* const end = at + frames.size();
  while (at != end) {
    const auto left = static_cast<std::size_t>(end - at);
    if (left < kFrameHeaderSize) return Problem{"the robot sent a frame that is cut off"};
    const std::size_t size = kFrameHeaderSize + ReadFrameHeader(at).payload_size;
    if (size > left) return Problem{"the robot sent a frame that is cut off"};
    const Outcome decoded = decoder_.Decode(at, size, *this);
    if (!decoded) return Problem{"the robot sent what cannot be read: " + decoded.problem()};
    listener_.OnFrame(at, size);
    at += size;
  }
  next_ = next;
  has_frames_ = true;
  return {};
}

void ClientHistory::OnTree(const TreeDescription& tree) {
  nodes_ = tree.nodes.size();
  listener_.OnTree(tree);
}

void ClientHistory::OnState(const HistoryState& state) {
  if (has_hole_) TellHole(state);
  tick_ = state.tick;
  listener_.OnState(state);
}

// The robot has not kept what came while there was no connection.
void ClientHistory::TellHole(const HistoryState& state) {
  has_hole_ = false;
  if (state.tick <= tick_) return;
  HistoryGap gap;
  gap.cause = HistoryGap::Cause::kOutput;
  gap.time = state.time;
  gap.first_tick = tick_ + 1;
  gap.last_tick = state.tick;
  gap.lost_ticks = state.tick - tick_;
  listener_.OnGap(gap);
  const std::string frame = MakeGapFrame(gap);
  listener_.OnFrame(reinterpret_cast<const std::uint8_t*>(frame.data()), frame.size());
}

void ClientHistory::OnTick(const TickEvents& events) {
  tick_ = events.tick;
  listener_.OnTick(events);
}

void ClientHistory::OnGap(const HistoryGap& gap) {
  HistoryGap told = gap;
  if (has_hole_ && gap.first_tick <= tick_ && gap.last_tick > tick_) {  // the robot does not know
    told.first_tick = tick_ + 1;                                        // what came over another
    told.lost_ticks = gap.last_tick - tick_;                            // connection
  }
  has_hole_ = false;
  listener_.OnGap(told);
}

}  // namespace coppice
