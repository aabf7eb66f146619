// Plays the steps of a scenario on a tree, without judging: what `coppice test` compares with what
// was expected, and what an editor shows and records.
//
//   ScenarioPlayer player(*program, rules);
//   StepOutcome outcome = player.Play(step);     // sets values, lets time pass, ticks
//   outcome.status; outcome.events; outcome.problems;
#ifndef COPPICE_BT_CORE_TESTING_SCENARIO_PLAYER_H_
#define COPPICE_BT_CORE_TESTING_SCENARIO_PLAYER_H_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "bt_core/testing/mocked_tree.h"
#include "bt_core/testing/scenario.h"

namespace coppice {

/// What happened in one step.
struct StepOutcome {
  Status status = Status::kIdle;      ///< that the last tick returned; IDLE after a halt
  std::vector<LeafEvent> events;      ///< of leaves, with their inputs
  std::vector<NodeMessage> messages;  ///< of all nodes
  std::vector<Difference> problems;   ///< what could not be done: a value of another type, ...
};

class ScenarioPlayer {
 public:
  /// A fresh tree at time 1 s. The first rule counts among those that fit equally well. The seed is
  /// that of what scripts do by chance.
  ScenarioPlayer(const Program& program, const std::vector<PlacedRule>& rules,
                 std::uint64_t seed = 0);
  ~ScenarioPlayer();
  ScenarioPlayer(const ScenarioPlayer&) = delete;
  ScenarioPlayer& operator=(const ScenarioPlayer&) = delete;

  /// Does what the step says; what it expects is not looked at.
  StepOutcome Play(const ScenarioStep& step);

  /// Goes on with another program; see MockedTree::Reload.
  void Reload(const Program& program, const std::vector<PlacedRule>& rules);

  /// Nodes that only a script can play (NeedsScript of stand_in.h), and none does.
  std::vector<NodeIndex> UnplayedNodes() const;

  MockedTree& tree() { return tree_; }
  const MockedTree& tree() const { return tree_; }
  const SimulatedClock& clock() const { return clock_; }

 private:
  class KeepMessages;

  bool IsPlayed(NodeIndex node) const;
  void Set(const KeyValue& given, StepOutcome& outcome);
  void ChangeScript(const PlacedRule& placed, StepOutcome& outcome);

  SimulatedClock clock_;
  std::unique_ptr<KeepMessages> sink_;
  MockedTree tree_;
};

/// The slot of a key as scenarios write it: "goal", "patrol/goal". kNoSlot, with the nearest right
/// key in `hint`, if there is none.
SlotIndex FindKey(const Program& program, const std::string& key, std::string& hint);

/// How scenarios write the key of a slot; empty if it has none.
std::string KeyPathOf(const Program& program, SlotIndex slot);

/// What a text is where the key has no type: "true" is a boolean, "0.2" a number.
KeyValue::Kind KindOfText(const std::string& text);

/// Whether the tree can be given this value.
Outcome CheckKeyValue(const Program& program, const KeyValue& given);

/// What a text is as a value of that type; without a type what its kind says. Empty if it is no
/// such value.
Value ValueOf(const KeyValue& given, const Type* type);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_SCENARIO_PLAYER_H_
