#include "bt_core/live/server/subscription.h"

#include <algorithm>
#include <utility>

#include "bt_core/frames/payload_coding.h"

namespace coppice {
namespace {

constexpr std::size_t kMaxPush = 256 << 10;  // bytes, unless a single frame is larger

constexpr std::size_t kMaxGapFrame = 128;

}  // namespace

Subscription::Subscription(const FrameStore& store, From from, std::uint64_t number,
                           std::size_t window)
    : window_(std::min(window, kMaxWindow)) {
  if (from == From::kNumber && number >= store.first() && number <= store.next()) {
    next_ = number;
    if (next_ > store.first()) tick_ = store[next_ - 1].tick;
    return;
  }
  Enter(from == From::kYoungest ? store.youngest_state() : store.oldest_state());
  const std::uint64_t wanted = from == From::kNumber && number < next_ ? number : 0;
  const bool tree_is_next_to_it = next_ > 0 && next_ == store.first() + 1;
  missed_ = next_ - wanted - (tree_is_next_to_it ? 1 : 0);
}

void Subscription::Enter(std::uint64_t state) {
  needs_tree_ = true;
  next_ = state;
}

// The client was too slow: what it should get next is kept no longer.
void Subscription::CrossHole(const FrameStore& store) {
  const StoredFrame& state = store[store.oldest_state()];
  HistoryGap& gap = gap_.emplace();
  gap.cause = HistoryGap::Cause::kOutput;
  gap.time = state.time;
  gap.first_tick = tick_ + 1;
  gap.last_tick = std::max(state.tick, gap.first_tick);
  gap.lost_ticks = gap.last_tick - gap.first_tick + 1;
  Enter(store.oldest_state());
}

std::size_t Subscription::LeastBytes(const FrameStore& store) const {
  if (!needs_tree_) return store[next_].bytes.size();
  return store.TreeAt(next_).bytes.size() + (gap_ ? kMaxGapFrame : 0);
}

// What goes before the next frame and has no number.
std::string Subscription::Unnumbered(const FrameStore& store) const {
  std::string frames = gap_ ? MakeGapFrame(*gap_) : "";
  if (needs_tree_) frames += store.TreeAt(next_).bytes;
  return frames;
}

std::optional<Push> Subscription::Next(const FrameStore& store, std::size_t room) {
  if (in_flight_ > 0 && in_flight_ >= window_) return std::nullopt;
  if (next_ < store.first()) CrossHole(store);
  if (next_ == store.next()) return std::nullopt;
  if (LeastBytes(store) > room) return Push{next_, next_, ""};
  Push push{next_, next_, Unnumbered(store)};
  gap_.reset();
  needs_tree_ = false;
  room = std::min({room, kMaxPush, window_ - std::min(window_, in_flight_)});
  for (; next_ < store.next(); ++next_) {
    const StoredFrame& frame = store[next_];
    if (!push.frames.empty() && push.frames.size() + frame.bytes.size() > room) break;
    push.frames += frame.bytes;
    tick_ = frame.tick;
  }
  push.next = next_;
  sent_.push_back({next_, push.frames.size()});
  in_flight_ += push.frames.size();
  return push;
}

void Subscription::Acknowledge(std::uint64_t next) {
  while (!sent_.empty() && sent_.front().next <= next) {
    in_flight_ -= sent_.front().bytes;
    sent_.pop_front();
  }
}

}  // namespace coppice
