// The state of a tree between two ticks as a value: what the built-in nodes remember and what is on
// the blackboard. Nodes of the user keep what they remember for themselves.
//
//   const TreeState before = executor.Save();
//   executor.Tick();
//   executor.Restore(before);
#ifndef COPPICE_BT_CORE_ENGINE_TREE_STATE_H_
#define COPPICE_BT_CORE_ENGINE_TREE_STATE_H_

#include <cstdint>
#include <vector>

#include "bt_core/base/status.h"
#include "bt_core/data/blackboard.h"

namespace coppice {

struct TreeState {
  std::vector<Status> statuses;
  std::vector<std::uint64_t> memory;
  Blackboard blackboard;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_TREE_STATE_H_
