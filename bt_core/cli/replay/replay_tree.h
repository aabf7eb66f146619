// A recorded tree at one moment, as lines for a terminal.
#ifndef COPPICE_BT_CORE_CLI_REPLAY_REPLAY_TREE_H_
#define COPPICE_BT_CORE_CLI_REPLAY_REPLAY_TREE_H_

#include <string>
#include <vector>

#include "bt_core/analysis/recording.h"

namespace coppice {

/// How the tree stands behind an entry of the run.
struct TreePicture {
  std::uint64_t tick;
  Time time;
  Status result;
  std::vector<Status> statuses;
  std::vector<Status> last;         ///< what each node returned in this tick; IDLE: not ticked
  std::vector<std::string> values;  ///< as in data/value_bytes.h
};

TreePicture PictureOf(const Recording& run, std::size_t entry);

/// One line per node: what it returned in this tick, its status if that is another, its name.
std::string NodeLine(const TreeDescription& tree, const TreePicture& picture, NodeIndex node,
                     bool colored);

/// "tick 57 at 5.600000 s: RUNNING", all nodes, and all keys that have a value.
std::string PrintPicture(const TreeDescription& tree, const TreePicture& picture, Time start);
std::string PictureToJson(const TreeDescription& tree, const TreePicture& picture, Time start);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_REPLAY_REPLAY_TREE_H_
