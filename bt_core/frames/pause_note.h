// How a history tells that its tree stood still on somebody's wish, at a breakpoint or paused: a
// note at the time when it began to stand. Figures leave these times out (analysis/pauses.h).
#ifndef COPPICE_BT_CORE_FRAMES_PAUSE_NOTE_H_
#define COPPICE_BT_CORE_FRAMES_PAUSE_NOTE_H_

#include <cstdint>
#include <optional>

#include "bt_core/frames/history.h"

namespace coppice {

inline constexpr char kPauseKind[] = "pause";

struct Pause {
  Time from{};  ///< in the tree's clock, which may stand still meanwhile (SimulatedClock)
  Time to{};
  /// The one in which it stood, at a breakpoint or a step: so long in real time, in which the
  /// duration of a tick is measured. 0: it stood between ticks, or whoever wrote it did not say.
  std::uint64_t tick = 0;
  Duration of_tick{0};
};

/// The note's text is a number of seconds, "2.500000 s", in a tick "0.000000 s, 2.500000 s of tick
/// 7".
HistoryNote NoteOf(const Pause& pause);
/// Nothing if the note tells something else, or what no program writes.
std::optional<Pause> PauseOf(const HistoryNote& note);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_PAUSE_NOTE_H_
