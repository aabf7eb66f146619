// A description of a small tree, and ticks of it, for tests of what shows them.
#ifndef COPPICE_TESTS_BT_CORE_CLI_DESCRIBED_TREE_H_
#define COPPICE_TESTS_BT_CORE_CLI_DESCRIBED_TREE_H_

#include <string>

#include "bt_core/data/value_bytes.h"
#include "bt_core/frames/history.h"

namespace coppice {

/// top [Sequence] with the nodes check and dock/Drive::3; a key "battery" without a value.
inline TreeDescription SmallTree() {
  TreeDescription tree;
  tree.main_tree = "Main";
  for (const auto& [path, id] :
       {std::pair("top", "Sequence"), {"check", "Check"}, {"dock/Drive::3", "Drive"}}) {
    DescribedNode node;
    node.path = path;
    node.id = id;
    tree.nodes.push_back(node);
  }
  tree.nodes[0].runs_one_child = true;
  tree.slots.push_back({"Main", "battery", "double", true});
  return tree;
}

inline HistoryState SmallState() {
  HistoryState state;
  state.statuses.assign(3, Status::kIdle);
  state.last.assign(3, Status::kIdle);
  state.values.emplace_back();
  return state;
}

/// Tick 7: check succeeds and says something, battery is 0.5, Drive and top are RUNNING.
class SmallTick {
 public:
  SmallTick() {
    std::string bytes;
    AppendValueBytes(Value(0.5), bytes);
    words_.Add(EventCode::kWrite, 0, 1, bytes);
    words_.Text(NodeIndex{1}, EventText::kMessage, R"(all is "well")");
    words_.Status(NodeIndex{1}, Status::kSuccess);
    words_.Status(NodeIndex{2}, Status::kRunning);
    words_.Status(kRootNode, Status::kRunning);
  }
  TickEvents events() const {
    return {7,
            Time(std::chrono::seconds(2)),
            std::chrono::microseconds(5),
            Status::kRunning,
            true,
            words_.words()};
  }

 private:
  EventWriter words_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_CLI_DESCRIBED_TREE_H_
