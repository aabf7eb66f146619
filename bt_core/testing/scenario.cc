#include "bt_core/testing/scenario.h"

#include <algorithm>
#include <map>

#include "bt_core/testing/scenario_player.h"
#include "bt_core/testing/stand_in.h"

namespace coppice {
namespace {

std::vector<PlacedRule> RulesOf(const ScenarioSuite& suite, const Scenario& scenario) {
  std::vector<PlacedRule> rules = scenario.leaves;
  if (!scenario.own_leaves) {
    rules.insert(rules.end(), suite.leaves.begin(), suite.leaves.end());
  }
  return rules;
}

class Player {
 public:
  Player(const Program& program, const ScenarioSuite& suite, const Scenario& scenario)
      : scenario_(scenario), player_(program, RulesOf(suite, scenario), scenario.seed) {
    for (NodeIndex node{0}; node < program.nodes.size(); ++node) {
      nodes_.emplace(program.Path(node), node);
    }
    CheckRules(suite);
    CheckUnknownNodes();
  }

  ScenarioResult Play() {
    if (result_.differences.empty()) {
      for (const ScenarioStep& step : scenario_.steps) PlayStep(step);
    }
    result_.ticks = tree().executor().ticks();
    return std::move(result_);
  }

 private:
  void CheckRules(const ScenarioSuite& suite) {
    const std::vector<std::string> unused = tree().UnusedPatterns();
    for (const std::vector<PlacedRule>* rules : {&scenario_.leaves, &suite.leaves}) {
      for (const PlacedRule& placed : *rules) {
        const std::string& pattern = placed.rule.pattern;
        if (std::find(unused.begin(), unused.end(), pattern) == unused.end()) continue;
        Add(placed.where, "leaves", "a node of the tree that fits \"" + pattern + "\"", "none");
      }
    }
  }

  void CheckUnknownNodes() {
    const std::vector<NodeIndex> unknown = player_.UnplayedNodes();
    if (unknown.empty()) return;
    std::vector<std::string> known;
    for (const auto& [id, entry] : tree().program().registry->entries()) {
      if (!NeedsScript(entry)) known.push_back(id);
    }
    for (const NodeIndex node : unknown) {
      const std::string id = tree().program().Id(node);
      const std::string hint = DidYouMean(id, known);
      Add(scenario_.where, "leaves",
          "a rule for \"" + tree().program().Path(node) + "\", whose type <" + id +
              "> is not known here",
          "none" + (hint.empty() ? "" : ", " + hint));
    }
  }

  void PlayStep(const ScenarioStep& step) {
    ++step_;
    outcome_ = player_.Play(step);
    for (const Difference& problem : outcome_.problems) {
      Add(problem.where, problem.what, problem.expected, problem.got);
    }
    Compare(step.expect);
  }

  void Compare(const Expectations& expect) {
    if (expect.status && expect.status->status != outcome_.status) {
      Add(expect.status->where, "status of the tree", ToString(expect.status->status),
          ToString(outcome_.status));
    }
    if (expect.events) CompareEvents(*expect.events);
    for (const ExpectedStatus& node : expect.nodes) CompareNode(node);
    for (const ExpectedValue& value : expect.blackboard) CompareValue(value);
    for (const ExpectedMessage& message : expect.messages) CompareMessage(message);
  }

  void CompareNode(const ExpectedStatus& expected) {
    const auto [first, last] = nodes_.equal_range(expected.node);
    if (first == last) {
      std::vector<std::string> paths;
      for (const auto& [path, node] : nodes_) paths.push_back(path);
      const std::string hint = DidYouMean(expected.node, paths);
      Add(expected.where, "node \"" + expected.node + "\"", "a node of the tree",
          "none" + (hint.empty() ? "" : ", " + hint));
    } else if (std::distance(first, last) > 1) {
      Add(expected.where, "node \"" + expected.node + "\"", "one node of that path", "several");
    } else if (const Status got = tree().executor().status(first->second); got != expected.status) {
      Add(expected.where, "status of node \"" + expected.node + "\"", ToString(expected.status),
          ToString(got));
    }
  }

  void CompareValue(const ExpectedValue& expected) {
    std::string hint;
    const SlotIndex slot = FindKey(tree().program(), expected.value.key, hint);
    const std::string what = "key \"" + expected.value.key + "\"";
    if (slot == kNoSlot) {
      Add(expected.value.where, what, "a key of the tree",
          "none" + (hint.empty() ? "" : ", " + hint));
      return;
    }
    const Value& got = tree().executor().blackboard()[slot].value;
    if (expected.unset || !got.has_value()) {
      if (expected.unset && !got.has_value()) return;
      Add(expected.value.where, what, expected.unset ? "not written" : expected.value.text,
          got.has_value() ? got.Print() : "not written");
    } else if (!IsText(got, expected.value)) {
      Add(expected.value.where, what, expected.value.text, got.Print());
    }
  }

  // Whether a value is what a text says, in whatever spelling.
  static bool IsText(const Value& value, const KeyValue& expected) {
    if (value.Print() == expected.text) return true;
    const Value parsed = ValueOf(expected, value.type());
    return parsed.has_value() && parsed.Print() == value.Print();
  }

  void CompareMessage(const ExpectedMessage& expected) {
    std::string all;
    for (const NodeMessage& message : outcome_.messages) {
      if (message.text.find(expected.part) != std::string::npos) return;
      all += (all.empty() ? "" : "; ") + tree().program().Path(message.node) + ": " + message.text;
    }
    Add(expected.where, "messages", "one with \"" + expected.part + "\"",
        all.empty() ? "none" : all);
  }

  // Reports the first event that differs, in its surroundings.
  void CompareEvents(const ExpectedEvents& expected) {
    const std::vector<LeafEvent>& got = outcome_.events;
    std::size_t i = 0;
    while (i < got.size() && i < expected.events.size() && Fits(expected.events[i], got[i])) ++i;
    if (i == got.size() && i == expected.events.size()) return;
    const bool missing = i == got.size();
    const bool surplus = i == expected.events.size();
    Add(surplus ? expected.where : expected.events[i].where, "event " + std::to_string(i + 1),
        surplus ? "no more events" : Print(expected.events[i]),
        missing ? "no more events" : Print(got[i], !surplus && !expected.events[i].inputs.empty()));
  }

  bool Fits(const ExpectedEvent& expected, const LeafEvent& got) const {
    const Program& program = tree().program();
    const NodeNames names{program.Name(got.node), program.Path(got.node), program.Id(got.node)};
    if (!Matches(expected.leaf, names)) return false;
    if (expected.halted != got.halted) return false;
    if (expected.status && *expected.status != got.result) return false;
    return std::all_of(expected.inputs.begin(), expected.inputs.end(), [&](const KeyValue& input) {
      return std::find(got.inputs.begin(), got.inputs.end(), std::pair(input.key, input.text)) !=
             got.inputs.end();
    });
  }

  static std::string Print(const ExpectedEvent& event) {
    std::string text = (event.halted ? "halt " : "tick ") + event.leaf;
    if (event.status) text += std::string(" ") + ToString(*event.status);
    for (const KeyValue& input : event.inputs) text += " " + input.key + "=\"" + input.text + "\"";
    return text;
  }

  std::string Print(const LeafEvent& event, bool with_inputs) const {
    const std::string leaf = tree().program().Name(event.node);
    if (event.halted) return "halt " + leaf;
    std::string text = "tick " + leaf + " " + ToString(event.result);
    if (!with_inputs) return text;
    for (const auto& [port, value] : event.inputs) text += " " + port + "=\"" + value + "\"";
    return text;
  }

  void Add(const SourceLocation& where, std::string what, std::string expected, std::string got) {
    result_.differences.push_back(
        {where, step_, std::move(what), std::move(expected), std::move(got)});
  }

  MockedTree& tree() { return player_.tree(); }
  const MockedTree& tree() const { return player_.tree(); }

  const Scenario& scenario_;
  ScenarioPlayer player_;
  StepOutcome outcome_;  // of the last step
  std::multimap<std::string, NodeIndex> nodes_;
  std::size_t step_ = 0;
  ScenarioResult result_;
};

}  // namespace

ScenarioResult RunScenario(const Program& program, const ScenarioSuite& suite,
                           const Scenario& scenario) {
  return Player(program, suite, scenario).Play();
}

}  // namespace coppice
