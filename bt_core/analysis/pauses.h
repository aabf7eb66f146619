// When the tree of a run stood at a breakpoint or was paused, so that figures can leave it out.
#ifndef COPPICE_BT_CORE_ANALYSIS_PAUSES_H_
#define COPPICE_BT_CORE_ANALYSIS_PAUSES_H_

#include <vector>

#include "bt_core/analysis/recording.h"
#include "bt_core/frames/pause_note.h"

namespace coppice {

class Pauses {
 public:
  /// Those that the run's notes tell (frames/pause_note.h). One that has not ended is not known.
  explicit Pauses(const Recording& run);

  /// How long the tree stood between two times of its clock.
  Duration Within(Time from, Time to) const;
  /// How long it ran between them: the rest.
  Duration RunWithin(Time from, Time to) const { return to - from - Within(from, to); }
  /// How long it ran in that tick, in real time.
  Duration RunIn(const TickEvents& tick) const;

 private:
  struct InTick {
    std::uint64_t tick;
    Duration stood;
  };

  std::vector<InTick> in_ticks_;  // by number
  std::vector<Pause> pauses_;     // by time; none begins before the one before it has ended
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_PAUSES_H_
