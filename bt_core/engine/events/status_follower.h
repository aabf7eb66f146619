// Knows the status of every node from the events alone, as live views, records and replay do.
//
//   StatusFollower follower(ShapeOf(program), executor.statuses());
//   follower.Apply(event);                 // each event, in order
//   follower.status(7);                    // between ticks: what Executor::statuses() says
#ifndef COPPICE_BT_CORE_ENGINE_EVENTS_STATUS_FOLLOWER_H_
#define COPPICE_BT_CORE_ENGINE_EVENTS_STATUS_FOLLOWER_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bt_core/base/status.h"
#include "bt_core/engine/events/event_words.h"

namespace coppice {

class Program;

struct NodeShape {
  NodeIndex parent;     ///< itself for the root
  NodeIndex end;        ///< one past the last descendant
  bool runs_one_child;  ///< children behind the running one are idle (RunsOneChild)
};
using TreeShape = std::vector<NodeShape>;

TreeShape ShapeOf(const Program& program);

struct StatusChange {
  NodeIndex node;
  Status from;
  Status to;
};

class StatusFollower {
 public:
  /// `last`: the last statuses as far as they are known; else they follow from the statuses.
  StatusFollower(TreeShape shape, std::vector<Status> statuses, std::vector<Status> last = {});

  /// Events of other kinds, and nodes that there are not, change nothing.
  void Apply(const Event& event) {
    Apply(event, [](const StatusChange&) {});
  }

  /// The same; `on_change` is called with every StatusChange that follows from the event, the node
  /// of the event last.
  template <class OnChange>
  void Apply(const Event& event, OnChange on_change);

  /// Instead of Apply, for the statuses at `at` in the words of a whole tick; returns where they
  /// end (ForEachRun). What follows from them for other nodes is left to Settle, which has to be
  /// called before a status is asked for. Much cheaper, but they must be those of an executor.
  const std::uint32_t* Note(const std::uint32_t* at, const std::uint32_t* end);
  void Settle();

  Status status(NodeIndex node) const { return statuses_[node]; }
  const std::vector<Status>& statuses() const { return statuses_; }
  /// The last status of a node that was not IDLE; kIdle if it never was anything else.
  Status last(NodeIndex node) const { return last_[node]; }
  const std::vector<Status>& lasts() const { return last_; }
  const TreeShape& shape() const { return shape_; }

 private:
  template <class OnChange>
  void Set(NodeIndex node, Status status, OnChange& on_change);
  template <class OnChange>
  void Reset(NodeIndex node, OnChange& on_change);

  TreeShape shape_;
  std::vector<Status> statuses_;
  std::vector<Status> last_;
  std::vector<NodeIndex> ticked_child_;  // per node: the child that was ticked last; one for nobody
  std::vector<NodeIndex> asked_by_;      // per node: its parent; nobody for the root
};

template <class OnChange>
void StatusFollower::Set(NodeIndex node, Status status, OnChange& on_change) {
  const Status before = statuses_[node];
  if (before == status) return;
  statuses_[node] = status;
  if (status != Status::kIdle) last_[node] = status;
  on_change(StatusChange{node, before, status});
}

// Below an idle node all are idle.
template <class OnChange>
void StatusFollower::Reset(NodeIndex node, OnChange& on_change) {
  for (NodeIndex i = node; i < shape_[node].end;) {
    const bool was_running = statuses_[i] == Status::kRunning;
    Set(i, Status::kIdle, on_change);
    i = was_running ? i + 1 : shape_[i].end;
  }
}

template <class OnChange>
void StatusFollower::Apply(const Event& event, OnChange on_change) {
  const NodeIndex node = event.node();
  if (!event.is_status() || node >= shape_.size()) return;
  const Status status = event.status();
  if (status == Status::kIdle) return Reset(node, on_change);
  const NodeShape& shape = shape_[node];
  ticked_child_[asked_by_[node]] = node;
  NodeIndex idle_from = shape.end;  // the children from here on are idle now
  if (status != Status::kRunning) {
    idle_from = node + 1;
  } else if (shape.runs_one_child && ticked_child_[node] > node) {
    idle_from = shape_[ticked_child_[node]].end;
  }
  for (NodeIndex i = idle_from; i < shape.end; i = shape_[i].end) Reset(i, on_change);
  Set(node, status, on_change);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_EVENTS_STATUS_FOLLOWER_H_
