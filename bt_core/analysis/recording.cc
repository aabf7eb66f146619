#include "bt_core/analysis/recording.h"

#include <algorithm>

#include "bt_core/frames/follower.h"

namespace coppice {
void Recording::OnTree(const TreeDescription& tree) { trees_.push_back(tree); }

void Recording::OnState(const HistoryState& state) {
  if (trees_.empty()) return;
  sections_.push_back({trees_.size() - 1, ticks_.size(), state});
}

// Behind a breakpoint the same tick goes on.
bool Recording::Continues(const TickEvents& events) const {
  if (ticks_.empty() || sections_.empty()) return false;
  const Tick& last = ticks_.back();
  return !last.is_whole && last.number == events.tick &&
         (FollowsOn(sections_.back()) || sections_.back().first_tick != ticks_.size());
}

void Recording::OnTick(const TickEvents& events) {
  const std::size_t first = words_.size();
  words_.insert(words_.end(), events.words.data, events.words.data + events.words.size);
  if (Continues(events)) {
    Tick& tick = ticks_.back();
    tick.duration = events.duration;
    tick.result = events.result;
    tick.is_whole = events.is_whole;
    tick.words += events.words.size;
    return;
  }
  ticks_.push_back({events.tick, events.start, events.duration, events.result, events.is_whole,
                    first, events.words.size});
}

void Recording::OnGap(const HistoryGap& gap) { gaps_.push_back({{ticks_.size()}, gap}); }
void Recording::OnNote(const HistoryNote& note) { notes_.push_back({{ticks_.size()}, note}); }
void Recording::OnEnd(const HistoryEnd& end) { end_ = end; }

TickEvents Recording::EventsOf(std::size_t tick) const {
  const Tick& t = ticks_[tick];
  return {t.number, t.start,    t.duration,
          t.result, t.is_whole, {words_.data() + t.first_word, t.words}};
}

const Recording::Section& Recording::SectionOf(std::size_t tick) const {
  const auto behind = std::upper_bound(
      sections_.begin() + 1, sections_.end(), tick,
      [](std::size_t t, const Section& section) { return t < section.first_tick; });
  return *(behind - 1);
}

std::size_t Recording::TreeOf(std::size_t tick) const { return SectionOf(tick).tree; }

TickView Recording::Before(std::size_t tick) const {
  const Section& section = SectionOf(tick);
  HistoryFollower follower(ShapeOf(trees_[section.tree]), section.state);
  for (std::size_t i = section.first_tick; i < tick; ++i) follower.Apply(EventsOf(i));
  TickEvents events{follower.tick(), follower.time(), Duration(0), Status::kIdle, true, {}};
  if (tick < ticks_.size()) events = EventsOf(tick);
  return {events, follower.statuses(), follower.values()};
}

std::optional<std::size_t> Recording::TickBefore(std::size_t tick) const {
  const Section& section = SectionOf(tick);
  const bool reaches_back = FollowsOn(section) && &section != &sections_.front();
  const std::size_t first = reaches_back ? 0 : section.first_tick;
  while (tick-- > first) {
    if (TreeOf(tick) != section.tree) return std::nullopt;
    if (ticks_[tick].result != Status::kIdle) return tick;
  }
  return std::nullopt;
}

std::size_t Recording::Find(std::uint64_t number) const {
  const auto found =
      std::lower_bound(ticks_.begin(), ticks_.end(), number,
                       [](const Tick& tick, std::uint64_t wanted) { return tick.number < wanted; });
  return static_cast<std::size_t>(found - ticks_.begin());
}

std::size_t Recording::FindTime(Time time) const {
  const auto behind =
      std::upper_bound(ticks_.begin(), ticks_.end(), time,
                       [](Time wanted, const Tick& tick) { return wanted < tick.start; });
  return behind == ticks_.begin() ? 0 : static_cast<std::size_t>(behind - ticks_.begin() - 1);
}

bool FollowsOn(const Recording::Section& section) {
  return section.state.cause == HistoryState::Cause::kKeyframe;
}

}  // namespace coppice
