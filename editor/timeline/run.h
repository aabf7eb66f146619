// A run, live or from a record: everything that was received of it, so that the user can go to any
// tick. It grows at its end. Ticks are numbered as in Recording::ticks(): halts, and what happened
// between ticks, have numbers of their own.
//
//   Run run;                                   // hand it a history: OnTree, OnState, OnTick, ...
//   run.TimeOf(run.size() - 1);                // on one axis, over restarts of the robot
//   RunPlace place(run);
//   place.Go(4711);
//   place.state().status(7);                   // after that tick
#ifndef COPPICE_EDITOR_TIMELINE_RUN_H_
#define COPPICE_EDITOR_TIMELINE_RUN_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "bt_core/analysis/recording.h"
#include "editor/timeline/peaks.h"
#include "editor/timeline/tracks.h"

namespace coppice::editor {

/// Between two ticks something is missing, or the tree was given another state.
struct RunBreak {
  std::size_t tick;  ///< it lies before this one
  HistoryState::Cause cause;
  std::uint64_t lost_ticks;
  bool is_other_run;   ///< the robot's program was started anew
  bool is_other_tree;  ///< another tree, or another version
};

class Run final : public HistoryHandler {
 public:
  const Recording& recording() const { return recording_; }
  /// Number of ticks.
  std::size_t size() const { return recording_.ticks().size(); }
  /// About the memory that it takes, with what is made of it in the editor.
  std::size_t bytes() const { return bytes_; }
  /// There is a tree with a state.
  bool has_tree() const { return follower_.has_value(); }

  /// Of the tree that runs at a tick; at the end: of the newest tree. There must be a tree.
  const Tracks& TracksAt(std::size_t tick) const;
  /// At the end the tree stands at a beginning: what was ticked is of a run before.
  bool is_at_beginning() const;
  /// How the tree stands at the end.
  const HistoryFollower& now() const { return *follower_; }

  /// Since the beginning of the run. Never falls; where the robot was started anew, a second
  /// passes.
  Time TimeOf(std::size_t tick) const;
  /// The last tick that began at that time or before; 0 if all began later.
  std::size_t TickAt(Time time) const;

  /// Behind the first state, all that do not go on from the one before.
  const std::vector<RunBreak>& breaks() const { return breaks_; }
  /// Real durations of the ticks [ms], without the time in which the tree stood, as far as notes
  /// before them tell it (frames/pause_note.h).
  const Peaks& durations() const { return durations_; }
  /// How much happened from one tick up to and without another: words of events.
  std::size_t Activity(std::size_t first, std::size_t end) const;

  /// The write that a slot holds after a tick, and the next ones; see Tracks.
  Event EventAt(const SlotWrite& write) const;

  /// The last place before or at a tick where the state is known.
  const Recording::Section& SectionAt(std::size_t tick) const;

  void OnTree(const TreeDescription& tree) override;
  void OnState(const HistoryState& state) override;
  void OnTick(const TickEvents& events) override;
  void OnGap(const HistoryGap& gap) override;
  void OnNote(const HistoryNote& note) override;
  void OnEnd(const HistoryEnd& end) override { recording_.OnEnd(end); }

 private:
  // From this tick on, TimeOf is the start of the tick plus the offset.
  struct Epoch {
    std::size_t tick;
    Duration offset;
  };
  // Of the tick that comes.
  struct Stood {
    std::uint64_t tick = 0;  // its number
    Duration time{0};
  };
  struct TracksFrom {
    std::size_t tick;
    std::shared_ptr<Tracks> tracks;
  };

  void KeepTime(std::size_t tick);
  void Begin(const HistoryState& state);
  void Keep(const HistoryState& state);
  void AddKeyframe();

  Recording recording_;
  std::vector<TracksFrom> tracks_;
  std::vector<Epoch> epochs_;
  std::vector<RunBreak> breaks_;
  Peaks durations_;
  std::optional<HistoryFollower> follower_;
  Stood stood_;
  std::uint64_t lost_ticks_ = 0;
  bool other_run_ = false;
  bool other_tree_ = false;
  std::size_t bytes_ = 0;
  std::size_t since_keyframe_ = 0;  // words
  std::size_t keyframe_every_ = 0;
};

/// How the tree stands behind a tick of a run. Going on by some ticks is quick, and going anywhere
/// takes some ten thousand events at most.
class RunPlace {
 public:
  /// The run must live longer.
  explicit RunPlace(const Run& run) : run_(run) {}

  /// The tick must be there.
  void Go(std::size_t tick);
  std::size_t tick() const { return tick_; }
  /// After Go.
  const HistoryFollower& state() const { return *state_; }

 private:
  const Run& run_;
  std::size_t tick_ = 0;
  std::optional<HistoryFollower> state_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_TIMELINE_RUN_H_
