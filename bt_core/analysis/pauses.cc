#include "bt_core/analysis/pauses.h"

#include <algorithm>

namespace coppice {

Pauses::Pauses(const Recording& run) {
  for (const Recording::Note& note : run.notes()) {
    if (const std::optional<Pause> pause = PauseOf(note.note)) pauses_.push_back(*pause);
  }
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

}  // namespace coppice
