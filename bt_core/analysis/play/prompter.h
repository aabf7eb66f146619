// Knows what comes next in a recorded run while it is played again: tells the played nodes
// (played_nodes.h) what they did then, and holds what the engine does now against the record, event
// by event.
//
// A tick is played in step with the record: before a node acts, it lets the prompter look at what
// the engine has done so far (Sync), so next() is what the record says comes now.
#ifndef COPPICE_BT_CORE_ANALYSIS_PLAY_PROMPTER_H_
#define COPPICE_BT_CORE_ANALYSIS_PLAY_PROMPTER_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/analysis/play/played_value.h"
#include "bt_core/analysis/recorded_tree.h"
#include "bt_core/engine/executor.h"

namespace coppice {

/// True for what the engine says of a node that stops late.
bool IsAboutStopping(const Event& event);

/// True for the word that the next result of the node comes from outside.
bool IsInjected(const Event& event);

/// Follows a node that has been halted and may go on stopping: then it is RUNNING when the tree
/// waits for it and does nothing, and halting it again is no news to it.
class StoppingNode {
 public:
  StoppingNode(NodeIndex node, bool is_waited_for) : node_(node), is_waited_for_(is_waited_for) {}

  /// False if the event shows that the node is active.
  bool Follow(const Event& event);
  NodeIndex node() const { return node_; }
  bool is_waited_for() const { return is_waited_for_; }

 private:
  NodeIndex node_;
  bool is_waited_for_;
  bool is_injected_ = false;  // the next result is not the node's own
  bool has_written_ = false;  // and nobody else has done anything since
};

/// Where a run that is played again does something else.
struct Divergence {
  std::uint64_t tick = 0;
  Time time{};
  std::string node;      ///< its path; empty if it is about no node
  std::string expected;  ///< what the record says
  std::string actual;
};

class Prompter final : public TickSink, public NodeHooks {
 public:
  /// From here on, this tree is played, from these statuses on. It must live longer.
  void Begin(const RecordedTree& tree, const std::vector<Status>& statuses);
  void set_executor(Executor* executor) { executor_ = executor; }
  void set_will_drain(std::function<bool(StoppingNode)> will_drain) {
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
  /// The same without resets that change nothing at its beginning.
  const Event* begin_of_change() const;
  const Event* end() const { return expected_.data() + expected_.size(); }
  const TreeShape& shape() const { return tree_->shape; }
  /// What a write or delivery brings, of the type of the slot.
  Value ValueOf(const Event& event) const;
  /// True if a node that is halted now, what follows being `next`, goes on stopping (OnDraining)
  /// and the record shows when it has stopped, in a later tick.
  bool WillDrain(NodeIndex node, const Event* next) const;
  /// True if a tick is played, and no halt.
  bool is_in_tick() const { return played_.result != Status::kIdle; }
  bool IsRunning(NodeIndex node) const {
    return actual_statuses_->status(node) == Status::kRunning;
  }
  /// True if a node runs only because somebody outside said so.
  bool IsPretending(NodeIndex node) const { return pretending_.count(node) > 0; }
  /// The status that somebody outside puts in the place of the node's own next.
  std::optional<Status> InjectedNext(NodeIndex node) const;

  void OnTick(const TickEvents& events) override;
  std::optional<Status> Before(NodeIndex node) override;
  std::optional<Status> After(NodeIndex node, Status result) override;

 private:
  bool IsPlayed(const Event& event) const;
  void Compare(Event event);
  void FollowPretending(const Event& event);
  void Diverge(const Event* expected, const Event* actual);
  std::string Describe(const Event& event) const;
  NodeIndex NodeOf(const Event& event) const;

  const RecordedTree* tree_ = nullptr;
  Executor* executor_ = nullptr;
  std::function<bool(StoppingNode)> will_drain_;
  std::vector<Event> expected_;
  std::size_t at_ = 0;
  std::optional<StatusFollower> expected_statuses_;
  std::optional<StatusFollower> actual_statuses_;
  std::set<NodeIndex> pretending_;
  NodeIndex injected_ = kNoNode;  // whose next result somebody outside has decided
  TickEvents played_{};
  std::uint64_t events_ = 0;
  std::optional<Divergence> divergence_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_PLAY_PROMPTER_H_
