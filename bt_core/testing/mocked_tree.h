// A tree in which scripts play some of the nodes, and which writes down what every leaf did.
//
//   SimulatedClock clock;
//   MockedTree tree(program, {{"<DriveTo>", {{Status::kRunning, Status::kSuccess}}}}, clock);
//   tree.executor().Tick();
//   tree.TakeEvents();      // ticks and halts of the leaves, in their order
//
// Any node can be played: a leaf, a SubTree, a control node with everything below it. Ports of the
// user's types are bound as ever, so a script can write outputs and a test can see the inputs. What
// no rule fits runs as it is; leaves of types that the registry does not know must have been given
// a fallback.
#ifndef COPPICE_BT_CORE_TESTING_MOCKED_TREE_H_
#define COPPICE_BT_CORE_TESTING_MOCKED_TREE_H_

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/engine/executor.h"
#include "bt_core/testing/mock_rules.h"

namespace coppice {

/// A tick or a halt of a leaf or of a node that a script plays.
struct LeafEvent {
  NodeIndex node;
  bool halted;    ///< else ticked
  Status result;  ///< of a tick
  /// Of a tick: input ports that have a value, as text; of a type that the registry does not know
  /// all attributes. Only with MockOptions::inputs.
  std::vector<std::pair<std::string, std::string>> inputs;
};

struct MockOptions {
  bool inputs = false;     ///< keep the inputs of every tick
  std::uint64_t seed = 0;  ///< of what scripts do by chance
};

class MockedTree {
 public:
  /// The clock must outlive the tree.
  MockedTree(const Program& program, std::vector<MockRule> rules, Clock& clock,
             MockOptions options = {});
  ~MockedTree();
  MockedTree(const MockedTree&) = delete;
  MockedTree& operator=(const MockedTree&) = delete;

  Executor& executor() { return *executor_; }
  const Executor& executor() const { return *executor_; }
  const Program& program() const { return executor_->program(); }

  /// What happened since the last call.
  std::vector<LeafEvent> TakeEvents() { return std::exchange(events_, {}); }

  /// From now on the nodes that are played by a script and fit the pattern follow this one, from
  /// its start. Returns how many nodes that are; a node that is not played cannot be taken over.
  int ChangeScript(const std::string& pattern, const MockScript& script);

  /// Goes on with another program, as Executor::Reload, and with these rules; changes of scripts
  /// hold on. A node that lives on goes on in its script. Between ticks.
  void Reload(const Program& program, std::vector<MockRule> rules);

  /// The script of a node that is played, or null.
  const MockScript* ScriptOf(NodeIndex node) const;

  /// Patterns of rules that fit no node of the tree.
  std::vector<std::string> UnusedPatterns() const;

  /// Nodes whose type the registry does not know and which no rule fits.
  std::vector<NodeIndex> UnknownLeaves() const;

 private:
  struct Part;
  class PlayedNode;
  class WatchedLeaf;
  class MockPort;
  class MockedProgram;
  using Inputs = std::vector<std::pair<std::string, std::string>>;

  using Parts = std::vector<std::unique_ptr<Part>>;

  Parts MakeParts(MockedProgram& program);
  std::unique_ptr<Part> MakePart(MockedProgram& program, NodeIndex node, const MockScript* script);
  Part& PartAt(NodeIndex node);
  Inputs InputsOf(const Part& part) const;
  Inputs InputsOfPorts(const Part& part) const;
  Inputs InputsOfAttributes(NodeIndex node) const;

  MockOptions options_;
  std::vector<MockRule> rules_;
  std::vector<MockRule> changes_;  // of scripts, in their order
  Parts parts_;                    // by ascending node
  std::vector<Parts> old_parts_;   // nodes that live on remember where they were
  std::vector<LeafEvent> events_;
  std::shared_ptr<MockedProgram> program_;
  std::unique_ptr<Executor> executor_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_MOCKED_TREE_H_
