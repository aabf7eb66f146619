// What the timeline knows of the nodes and keys of one tree: a lane for each node, and for each
// slot the places where it was written. Both grow tick by tick.
#ifndef COPPICE_EDITOR_TIMELINE_TRACKS_H_
#define COPPICE_EDITOR_TIMELINE_TRACKS_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "bt_core/frames/follower.h"
#include "editor/timeline/lane.h"

namespace coppice::editor {

/// Where a slot was written.
struct SlotWrite {
  std::uint32_t tick;  ///< of Recording::ticks()
  std::uint32_t word;  ///< of this tick: where the event begins
};

/// A result that somebody outside put in place of the node's own.
struct Injection {
  std::uint32_t tick;
  NodeIndex node;
};

class Tracks {
 public:
  explicit Tracks(std::shared_ptr<const TreeDescription> tree);

  const std::shared_ptr<const TreeDescription>& tree() const { return tree_; }
  const TreeShape& shape() const { return shape_; }

  /// A tick shows what a node returned in it, also if it is idle again at its end; a node that was
  /// not ticked shows the status that it has.
  const Lane& LaneOf(NodeIndex node) const { return lanes_[node]; }
  const std::vector<SlotWrite>& WritesOf(SlotIndex slot) const { return writes_[slot]; }
  const std::vector<Injection>& injections() const { return injections_; }

  /// If the other tree has the same nodes, and the same slots or more, these are its tracks too
  /// from now on, and true is returned.
  bool GoOnAs(std::shared_ptr<const TreeDescription> tree);

  /// The tree stands so before the tick.
  void Begin(std::size_t tick, const HistoryState& state);
  /// Applies the events of a tick to the follower and takes them down. `word`: where they begin in
  /// the tick; not 0 for the further parts of one that stood at a breakpoint.
  void Add(std::size_t tick, std::size_t word, const TickEvents& events, HistoryFollower& follower);

 private:
  void NoteChange(std::size_t tick, const StatusChange& change);
  void Note(std::size_t tick, std::size_t word, const TickEvents& events, const Event& event);

  std::shared_ptr<const TreeDescription> tree_;
  TreeShape shape_;
  std::vector<Lane> lanes_;                     // per node
  std::vector<std::size_t> ended_in_;           // per node: the last tick in which it ran no more
  std::vector<std::vector<SlotWrite>> writes_;  // per slot
  std::vector<Injection> injections_;
  std::vector<NodeIndex> touched_;                      // their lanes show more than their status
  std::vector<NodeIndex> changed_;                      // of the tick that is being added
  std::vector<std::pair<NodeIndex, Status>> returned_;  // in it
  std::vector<NodeIndex> restarted_;                    // ended in it, and run again
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_TIMELINE_TRACKS_H_
