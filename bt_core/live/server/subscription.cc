#include "bt_core/live/server/subscription.h"

#include <algorithm>
#include <utility>

#include "bt_core/frames/payload_coding.h"

namespace coppice {
namespace {

constexpr std::size_t kMaxPush = 256 << 10;  // bytes, unless a single frame is larger

void AppendGapFrame(const HistoryGap& gap, std::string& out) {
  Bytes frame;
  OpenFrame(frame, FrameType::kGap);
  Encoder encoder(frame);
  EncodeGap(gap, encoder);
  CloseFrame(frame, 0);
  SealFrame(frame.data());
  out.append(frame.begin(), frame.end());
}

}  // namespace

Subscription::Subscription(const FrameStore& store, From from, std::uint64_t number,
                           std::size_t window)
    : window_(std::min(window, kMaxWindow)) {
  if (from == From::kNumber && number >= store.first() && number <= store.next()) {
    next_ = number;
    if (next_ > store.first()) tick_ = store[next_ - 1].tick;
    return;
  }
  Enter(from == From::kYoungest ? store.YoungestEntry() : store.OldestEntry());
  const std::uint64_t wanted = from == From::kNumber && number < next_ ? number : 0;
  const bool tree_is_next_to_it = next_ > 0 && next_ == store.first() + 1;
  missed_ = next_ - wanted - (tree_is_next_to_it ? 1 : 0);
}

void Subscription::Enter(const FrameStore::Entry& entry) {
  unnumbered_ += entry.tree->bytes;
  next_ = entry.start;
}

// The client was too slow: what it should get next is kept no longer.
void Subscription::CrossHole(const FrameStore& store) {
  const FrameStore::Entry entry = store.OldestEntry();
  const std::uint64_t tick = store[entry.start].tick;
  HistoryGap gap;
  gap.cause = HistoryGap::Cause::kOutput;
  gap.time = store[entry.start].time;
  gap.first_tick = tick_ + 1;
  gap.last_tick = std::max(tick, gap.first_tick);
  gap.lost_ticks = gap.last_tick - gap.first_tick + 1;
  AppendGapFrame(gap, unnumbered_);
  Enter(entry);
}

std::optional<Push> Subscription::Next(const FrameStore& store) {
  if (in_flight_ > 0 && in_flight_ >= window_) return std::nullopt;
  if (next_ < store.first()) CrossHole(store);
  if (next_ == store.next() && unnumbered_.empty()) return std::nullopt;
  Push push;
  push.first = next_;
  push.frames = std::exchange(unnumbered_, {});
  const std::size_t room = std::min(kMaxPush, window_ - std::min(window_, in_flight_));
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
