// Scenarios: tests of whole trees as data.
//
// A scenario says which nodes of a tree are played by scripts, what is written to the blackboard
// and how much time passes before a tick, and what is expected of each tick. `coppice test` runs
// files of them; the editor records and runs them. The format of the files: docs/testing.md.
//
//   Diagnostics diagnostics;
//   auto suite = LoadScenarios("patrol.test.json", diagnostics);
//   auto project = Project::FromFile(suite->tree_file, diagnostics);
//   auto program = CompileSuite(*suite, *std::move(project), nullptr, diagnostics);
//   for (const Scenario& scenario : suite->scenarios) {
//     for (const Difference& difference : RunScenario(*program, *suite, scenario).differences) ...
#ifndef COPPICE_BT_CORE_TESTING_SCENARIO_H_
#define COPPICE_BT_CORE_TESTING_SCENARIO_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/diagnostic.h"
#include "bt_core/engine/program.h"
#include "bt_core/testing/mock_rules.h"

namespace coppice {

class Project;
class Registry;

/// A value for a key, as text. "goal" is a key of the main tree, "patrol/goal" one of the SubTree
/// instance with the path "patrol". A key that a SubTree shares with the tree around it goes by its
/// name there.
struct KeyValue {
  /// What the text is where the key has no type of its own.
  enum class Kind : std::uint8_t { kString, kNumber, kBool };
  SourceLocation where;
  std::string key;
  std::string text;
  Kind kind = Kind::kString;
};

/// A rule as it stands in a file.
struct PlacedRule {
  SourceLocation where;
  MockRule rule;
};

struct ExpectedStatus {
  SourceLocation where;
  std::string node;  ///< path; empty: the whole tree
  Status status = Status::kIdle;
};

struct ExpectedEvent {
  SourceLocation where;
  bool halted = false;  ///< else ticked
  std::string leaf;     ///< a pattern, see mock_rules.h
  std::optional<Status> status;
  std::vector<KeyValue> inputs;  ///< those that matter
};

struct ExpectedEvents {
  SourceLocation where;
  std::vector<ExpectedEvent> events;
};

/// A key that must have this value, or, without a value, must not have been written yet.
struct ExpectedValue {
  KeyValue value;
  bool unset = false;
};

struct ExpectedMessage {
  SourceLocation where;
  std::string part;  ///< some message of the step contains it
};

struct Expectations {
  std::optional<ExpectedStatus> status;  ///< what the last tick of the step returned
  std::vector<ExpectedStatus> nodes;
  std::optional<ExpectedEvents> events;  ///< all of the step, in their order
  std::vector<ExpectedValue> blackboard;
  std::vector<ExpectedMessage> messages;
};

/// First the values are written and the scripts changed, then time passes, then the tree is ticked
/// or halted, then it is looked at.
struct ScenarioStep {
  SourceLocation where;
  std::vector<KeyValue> set;
  std::vector<PlacedRule> leaves;  ///< new scripts for nodes that are played
  Duration advance{0};
  int ticks = 1;
  bool halt = false;  ///< instead of ticks
  Expectations expect;
};

struct Scenario {
  SourceLocation where;
  std::string name;
  std::uint64_t seed = 0;  ///< of what scripts do by chance
  std::vector<PlacedRule> leaves;
  bool own_leaves = false;  ///< the rules of the suite do not count here
  std::vector<ScenarioStep> steps;
};

/// How the tree of a suite is run by chance (random_runs.h).
struct RandomPlay {
  SourceLocation where;                    ///< without a file: nobody has said anything
  std::vector<std::vector<KeyValue>> set;  ///< of each list, which is about one key, one by chance
  std::vector<PlacedRule> leaves;
  Duration lasts{0};  ///< a tree that is done is begun anew, until so much time has passed
};

struct ScenarioSuite {
  std::string file;
  std::string tree_file;           ///< ready to open
  std::string tree_id;             ///< empty: the main tree of the file
  std::string models_file;         ///< ready to open: the robot's node types; empty: none
  std::vector<PlacedRule> leaves;  ///< of all scenarios; theirs come first
  std::optional<RandomPlay> random;
  std::vector<Scenario> scenarios;
};

/// Where a tree did something else than was expected.
struct Difference {
  SourceLocation where;  ///< of the expectation
  std::size_t step = 0;  ///< counts from 1; 0: before the first
  std::string what;      ///< "status of the tree", "key \"goal\"", ...
  std::string expected;
  std::string got;
};

struct ScenarioResult {
  std::vector<Difference> differences;  ///< none: passed
  std::uint64_t ticks = 0;
};

/// Reads a file. Nothing is returned if there is something wrong with it.
std::optional<ScenarioSuite> LoadScenarios(const std::string& path, Diagnostics& diagnostics);

/// The tree of a suite that has been read, with stand-ins (stand_in.h) for what is not in `known`
/// (null: the built-in nodes). Null if there are errors.
std::shared_ptr<const Program> CompileSuite(const ScenarioSuite& suite, Project project,
                                            std::shared_ptr<Registry> known,
                                            Diagnostics& diagnostics);

/// The same from a text; `file` is for messages, and the tree is relative to it.
std::optional<ScenarioSuite> ParseScenarios(const std::string& text, const std::string& file,
                                            Diagnostics& diagnostics);

/// Plays one scenario on simulated time. A scenario that cannot be played to the end (a rule that
/// fits no node, a key that the tree does not have) has differences too.
ScenarioResult RunScenario(const Program& program, const ScenarioSuite& suite,
                           const Scenario& scenario);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_SCENARIO_H_
