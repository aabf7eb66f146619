// How a tree stands at one moment, as the canvas and the panels show it.
#ifndef COPPICE_EDITOR_LIVE_TREE_SNAPSHOT_H_
#define COPPICE_EDITOR_LIVE_TREE_SNAPSHOT_H_

#include <cstdint>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/status.h"

namespace coppice::editor {

/// What is marked at a node, as bits.
enum NodeMark : std::uint8_t {
  kNoMark = 0,
  kBreakpointMark = 1,     ///< the tree stops here
  kBreakpointOffMark = 2,  ///< it would, if the breakpoint were enabled
  kStopMark = 4,           ///< the tree stands here now
  kFaultMark = 8,          ///< somebody outside decides what it returns
};

struct NodeState {
  Status status = Status::kIdle;
  Status before = Status::kIdle;  ///< of an idle node: its last status
  Time since{};  ///< when the status began, on the axis of TreeSnapshot::now; 0: unknown
  std::uint8_t marks = kNoMark;  ///< of NodeMark
};

struct TreeSnapshot {
  bool is_fresh = true;           ///< false: the robot does not answer, this is the last known
  Time now{};                     ///< the moment that is shown
  std::vector<NodeState> states;  ///< by SceneNode::run_node
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_TREE_SNAPSHOT_H_
