// How a history tells that its tree stood still on somebody's wish, at a breakpoint or paused: a
// note at the time when it began to stand. Figures leave these times out (analysis/pauses.h).
#ifndef COPPICE_BT_CORE_FRAMES_PAUSE_NOTE_H_
#define COPPICE_BT_CORE_FRAMES_PAUSE_NOTE_H_

#include <optional>

#include "bt_core/frames/history.h"

namespace coppice {

inline constexpr char kPauseKind[] = "pause";

/// In the tree's clock, from..to.
struct Pause {
  Time from{};
  Time to{};
};

/// The note's text is a number of seconds, "2.500000 s".
HistoryNote NoteOf(const Pause& pause);
/// Nothing if the note tells something else, or what no program writes.
std::optional<Pause> PauseOf(const HistoryNote& note);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_PAUSE_NOTE_H_
