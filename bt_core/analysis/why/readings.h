// What a node could read when it was ticked: the values of its ports and of the keys in its
// scripts, at that moment of the tick.
#ifndef COPPICE_BT_CORE_ANALYSIS_WHY_READINGS_H_
#define COPPICE_BT_CORE_ANALYSIS_WHY_READINGS_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/analysis/recorded_tree.h"
#include "bt_core/analysis/recording.h"
#include "bt_core/analysis/why/walk.h"
#include "bt_core/nodes/guards.h"

namespace coppice {

/// Values of all slots, by the numbers of the record, as in data/value_bytes.h.
using SlotValues = std::vector<std::string>;

/// When a step began: the state before the tick, and everything that had happened by then.
SlotValues ValuesAt(const TickView& view, const Walk& walk, const TreeShape& shape, StepIndex step);

/// A key that a node reads through a port or in a script.
struct Reading {
  std::string name;  ///< of the port; in a script, of the key
  std::string key;
  SlotIndex slot;  ///< of the record
};

/// A script of a node: a guard, a hook, or the code of a Script or ScriptCondition.
struct NodeScript {
  std::string_view attribute;  ///< "_skipIf", "code"
  std::optional<Guard> guard;
  std::string text;
  const Script* script;  ///< of the program
};

/// Input and inout ports that are bound to keys. Empty without program, as the next two are.
std::vector<Reading> PortReadings(const RecordedTree& tree, NodeIndex node);
std::vector<NodeScript> ScriptsOf(const RecordedTree& tree, NodeIndex node);
std::vector<Reading> ScriptReadings(const RecordedTree& tree, const NodeScript& script);

/// What the script answers with these values; nothing if it throws.
std::optional<bool> Test(const RecordedTree& tree, const NodeScript& script,
                         const SlotValues& values);

/// A decision of the guards of a node before it was ticked.
struct GuardDecision {
  NodeScript script;
  bool answer;
  Status result;
};

/// Which guard decides with these values; nothing if they let the node be ticked.
std::optional<GuardDecision> DecideGuards(const RecordedTree& tree, NodeIndex node, bool running,
                                          const SlotValues& values);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_WHY_READINGS_H_
