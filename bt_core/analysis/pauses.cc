#include "bt_core/analysis/pauses.h"

#include <algorithm>

namespace coppice {

Pauses::Pauses(const Recording& run) {
  for (const Recording::Note& note : run.notes()) {
    const std::optional<Pause> pause = PauseOf(note.note);
    if (pause) pauses_.push_back(*pause);
    if (pause && pause->tick > 0) in_ticks_.push_back({pause->tick, pause->of_tick});
  }
  std::stable_sort(in_ticks_.begin(), in_ticks_.end(),
                   [](const InTick& a, const InTick& b) { return a.tick < b.tick; });
  std::sort(pauses_.begin(), pauses_.end(),
            [](const Pause& a, const Pause& b) { return a.from < b.from; });
  Time end = Time::min();
  for (Pause& pause : pauses_) {
    pause.from = std::max(pause.from, end);
    pause.to = end = std::max(pause.to, pause.from);
  }
}

Duration Pauses::Within(Time from, Time to) const {
  auto pause = std::partition_point(pauses_.begin(), pauses_.end(),
                                    [from](const Pause& p) { return p.to <= from; });
  Duration stood{0};
  if (to <= from) return stood;  // the clock was set back
  for (; pause != pauses_.end() && pause->from < to; ++pause) {
    stood += std::min(pause->to, to) - std::max(pause->from, from);
  }
  return stood;
}

// What the notes do not say of their ticks is taken from the tree's clock, in which they tell when
// it stood: right if that is real time.
Duration Pauses::RunIn(const TickEvents& tick) const {
  auto stood = std::partition_point(in_ticks_.begin(), in_ticks_.end(),
                                    [&](const InTick& one) { return one.tick < tick.tick; });
  if (stood == in_ticks_.end() || stood->tick != tick.tick) {
    return RunWithin(tick.start, tick.start + tick.duration);
  }
  Duration ran = tick.duration;
  for (; stood != in_ticks_.end() && stood->tick == tick.tick; ++stood) ran -= stood->stood;
  return std::max(ran, Duration(0));
}

}  // namespace coppice
