// What the leaves of the user did in a recorded run, as scripts that play it again: every leaf
// returns what it returned last until a step gives it another script.
#ifndef COPPICE_BT_CORE_ANALYSIS_PLAY_LEAF_SCRIPTS_H_
#define COPPICE_BT_CORE_ANALYSIS_PLAY_LEAF_SCRIPTS_H_

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/analysis/recorded_tree.h"
#include "bt_core/engine/events.h"
#include "bt_core/testing/scenario.h"

namespace coppice {

/// A recorded value as scenarios write it.
KeyValue KeyValueOf(std::string key, const std::string& bytes);

class LeafScripts {
 public:
  /// The program of the tree has stand-ins for the leaves of the user; it must live longer.
  explicit LeafScripts(const RecordedTree& tree);

  /// What the leaves did in a tick, and what came from outside, as part of a step.
  void Read(const TickEvents& events, ScenarioStep& step);

  /// The scripts that the leaves have from the start.
  std::vector<PlacedRule> Rules() const;

 private:
  struct Leaf {
    std::string pattern;
    MockScript first;                                          // from the start
    bool known = false;                                        // it was ticked
    MockScript now;                                            // what it does, with one result
    MockScript of_tick;                                        // what it did in this tick
    std::vector<std::pair<std::string, std::string>> written;  // since its last result
  };

  void ReadWrite(const Event& event, ScenarioStep& step);
  static void ReadResult(Leaf& leaf, Status result);
  static void EndTick(Leaf& leaf, ScenarioStep& step);
  void Set(SlotIndex recorded_slot, const std::string& bytes, ScenarioStep& step) const;
  std::string OutputOf(NodeIndex node, SlotIndex recorded_slot) const;

  const RecordedTree& tree_;
  std::map<NodeIndex, Leaf> leaves_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_PLAY_LEAF_SCRIPTS_H_
