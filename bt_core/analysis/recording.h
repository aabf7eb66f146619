// A recorded run in memory: every tick, and how the tree stood before it.
//
//   Diagnostics diagnostics;
//   std::optional<Recording> run = LoadRecording("run.coppice", diagnostics);
//   const TickView view = run->Before(run->Find(57));   // what is known when tick 57 begins
#ifndef COPPICE_BT_CORE_ANALYSIS_RECORDING_H_
#define COPPICE_BT_CORE_ANALYSIS_RECORDING_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/frames/history.h"

namespace coppice {

/// One tick, and everything that held when it began.
struct TickView {
  TickEvents events;
  std::vector<Status> statuses;     ///< before it
  std::vector<std::string> values;  ///< before it, per slot, as in data/value_bytes.h
};

class Recording final : public HistoryHandler {
 public:
  /// A tick, a halt, or what happened between two ticks. Parts of a tick that was stopped at
  /// breakpoints are one.
  struct Tick {
    std::uint64_t number;
    Time start;
    Duration duration;
    Status result;  ///< kIdle: no tick
    bool is_whole;
    std::size_t first_word;
    std::size_t words;
  };
  /// A place at which the state is known.
  struct Section {
    std::size_t tree;        ///< of trees()
    std::size_t first_tick;  ///< of ticks(): the first one behind it
    HistoryState state;
  };
  struct Place {
    std::size_t tick;  ///< of ticks(): it stands before this one
  };
  struct Gap : Place {
    HistoryGap gap;
  };
  struct Note : Place {
    HistoryNote note;
  };

  const std::vector<TreeDescription>& trees() const { return trees_; }
  const std::vector<Section>& sections() const { return sections_; }
  const std::vector<Tick>& ticks() const { return ticks_; }
  const std::vector<Gap>& gaps() const { return gaps_; }
  const std::vector<Note>& notes() const { return notes_; }
  const std::optional<HistoryEnd>& end() const { return end_; }
  std::size_t damages() const { return damages_; }
  /// Whether the recording was closed in order.
  bool is_closed() const { return end_ && end_->cause == HistoryEnd::Cause::kClosed; }

  /// Start of the run: of the first tree, in its clock.
  Time start() const { return trees_.front().info.start; }

  /// Valid as long as the recording stands still.
  TickEvents EventsOf(std::size_t tick) const;

  /// The tree of a tick: its number in trees().
  std::size_t TreeOf(std::size_t tick) const;

  /// The state before a tick; with ticks().size() the last one known.
  TickView Before(std::size_t tick) const;

  /// The tick of the same section before it that was a tick of the root, or nothing.
  std::optional<std::size_t> TickBefore(std::size_t tick) const;

  /// The entry of a tick number, or the next one behind it; ticks().size() if there is none.
  std::size_t Find(std::uint64_t number) const;
  /// The last entry that began at that time or before; 0 if all began later.
  std::size_t FindTime(Time time) const;

  void OnTree(const TreeDescription& tree) override;
  void OnState(const HistoryState& state) override;
  void OnTick(const TickEvents& events) override;
  void OnGap(const HistoryGap& gap) override;
  void OnNote(const HistoryNote& note) override;
  void OnEnd(const HistoryEnd& end) override;
  /// Something could not be read.
  void OnDamage() { ++damages_; }

 private:
  const Section& SectionOf(std::size_t tick) const;
  bool Continues(const TickEvents& events) const;

  std::vector<TreeDescription> trees_;
  std::vector<Section> sections_;
  std::vector<Tick> ticks_;
  std::vector<std::uint32_t> words_;  // of all ticks
  std::vector<Gap> gaps_;
  std::vector<Note> notes_;
  std::optional<HistoryEnd> end_;
  std::size_t damages_ = 0;
};

/// True where a section goes on from the one before it, so that nothing is missing in between.
bool FollowsOn(const Recording::Section& section);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_RECORDING_H_
