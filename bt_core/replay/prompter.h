// Knows what comes next in a recorded run while it is played again: tells the played nodes
// (played_nodes.h) what they did then, and holds what the engine does now against the record, event
// by event.
//
// A tick is played in step with the record: before a node acts, it lets the prompter look at what
// the engine has done so far (Sync), so next() is what the record says comes now.
#ifndef COPPICE_BT_CORE_REPLAY_PROMPTER_H_
#define COPPICE_BT_CORE_REPLAY_PROMPTER_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/engine/executor.h"
#include "bt_core/replay/played_value.h"
#include "bt_core/replay/recorded_tree.h"

namespace coppice {

/// True if these events say that a node which had been halted stopped before the tick began, and
/// was ticked in it.
bool HasDrainedIn(const Event* begin, const Event* end, NodeIndex node);

/// Where a run that is played again does something else.
struct Divergence {
  std::uint64_t tick = 0;
  Time time{0};
  std::string node;      ///< its path; empty if it is about no node
  std::string expected;  ///< what the record says
  std::string actual;
};

class Prompter final : public TickSink, public NodeHooks {
 public:
  /// From here on, this tree is played, from these statuses on. It must live longer.
  void Begin(const RecordedTree& tree, const std::vector<Status>& statuses);
  void set_executor(Executor* executor) { executor_ = executor; }
  void set_will_drain(std::function<bool(NodeIndex)> will_drain) {
    will_drain_ = std::move(will_drain);
  }

  /// What is played next. The words must live until Finish.
  void Expect(const TickEvents& events);
  /// After it was played: everything must have come, and the root must have returned `result`.
  void Finish(Status result);

  const std::optional<Divergence>& divergence() const { return divergence_; }
  /// So far.
  std::uint64_t events() const { return events_; }
  const std::vector<Status>& statuses() const { return expected_statuses_->statuses(); }

  // For the played nodes.

  /// Compares what has happened so far. False if the runs have parted.
  bool Sync();
  /// The events of the record from the next one on. Slots have the numbers of the program.
  const Event* begin() const { return expected_.data() + at_; }
  const Event* end() const { return expected_.data() + expected_.size(); }
  const TreeShape& shape() const { return tree_->shape; }
  /// What a write or delivery brings, of the type of the slot.
  Value ValueOf(const Event& event) const;
  /// True if the record says that a node which was halted has stopped at the beginning of this tick
  /// (OnDraining), and is started again.
  bool HasDrained(NodeIndex node) const;
  /// True if that comes for a node that is halted now, in a later tick.
  bool WillDrain(NodeIndex node) const { return will_drain_(node); }

  void OnTick(const TickEvents& events) override;
  std::optional<Status> Before(NodeIndex node) override;
  std::optional<Status> After(NodeIndex node, Status result) override;

 private:
  bool IsPlayed(const Event& event) const;
  void SkipWhatChangesNothing();
  void Compare(Event event);
  void Diverge(const Event* expected, const Event* actual);
  std::string Describe(const Event& event) const;
  NodeIndex NodeOf(const Event& event) const;
  std::optional<Status> InjectedNext(NodeIndex node) const;

  const RecordedTree* tree_ = nullptr;
  Executor* executor_ = nullptr;
  std::function<bool(NodeIndex)> will_drain_;
  std::vector<Event> expected_;
  std::size_t at_ = 0;
  std::optional<StatusFollower> expected_statuses_;
  std::optional<StatusFollower> actual_statuses_;
  TickEvents played_{};
  std::uint64_t events_ = 0;
  std::optional<Divergence> divergence_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_REPLAY_PROMPTER_H_
