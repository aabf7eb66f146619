#include "bt_core/testing/scenario.h"

#include <algorithm>
#include <map>

#include "bt_core/testing/mocked_tree.h"

namespace coppice {
namespace {

class KeepMessages : public TickSink {
 public:
  void OnTick(const TickEvents& events) override {
    for (NodeMessage& message : MessagesOf(events.words)) messages.push_back(std::move(message));
  }
  std::vector<NodeMessage> messages;
};

std::vector<MockRule> RulesOf(const ScenarioSuite& suite, const Scenario& scenario) {
  std::vector<MockRule> rules;
  for (const PlacedRule& placed : scenario.leaves) rules.push_back(placed.rule);
  for (const PlacedRule& placed : suite.leaves) rules.push_back(placed.rule);
  return rules;
}

Value UntypedValue(const KeyValue& given) {
  Value value;
  if (given.kind == KeyValue::Kind::kBool) {
    value.Set(given.text == "true");
  } else if (given.kind == KeyValue::Kind::kNumber) {
    if (!value.Parse(TypeOf<std::int64_t>(), given.text)) value.Parse(TypeOf<double>(), given.text);
  } else {
    value.Set(given.text);
  }
  return value;
}

// Empty if the text is no value of that type.
Value ValueOf(const KeyValue& given, const Type* type) {
  if (!type) return UntypedValue(given);
  Value value;
  value.Parse(*type, given.text);
  return value;
}

class Player {
 public:
  Player(const Program& program, const ScenarioSuite& suite, const Scenario& scenario)
      : scenario_(scenario),
        clock_(std::chrono::seconds(1)),
        tree_(program, RulesOf(suite, scenario), clock_, {true}) {
    tree_.executor().AddSink(&sink_);
    for (NodeIndex node = 0; node < program.nodes.size(); ++node) {
      nodes_.emplace(program.Path(node), node);
    }
    CheckRules(suite);
    CheckUnknownLeaves();
  }
  ~Player() { tree_.executor().RemoveSink(&sink_); }
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  ScenarioResult Play() {
    if (result_.differences.empty()) {
      for (const ScenarioStep& step : scenario_.steps) PlayStep(step);
    }
    result_.ticks = tree_.executor().ticks();
    return std::move(result_);
  }

 private:
  void CheckRules(const ScenarioSuite& suite) {
    const std::vector<std::string> unused = tree_.UnusedPatterns();
    for (const std::vector<PlacedRule>* rules : {&scenario_.leaves, &suite.leaves}) {
      for (const PlacedRule& placed : *rules) {
        const std::string& pattern = placed.rule.pattern;
        if (std::find(unused.begin(), unused.end(), pattern) == unused.end()) continue;
        Add(placed.where, "leaves", "a node of the tree that fits \"" + pattern + "\"", "none");
      }
    }
  }

  void CheckUnknownLeaves() {
    for (const NodeIndex node : tree_.UnknownLeaves()) {
      Add(scenario_.where, "leaves",
          "a rule for \"" + tree_.program().Path(node) + "\", whose type <" +
              tree_.program().Id(node) + "> is not known here",
          "none");
    }
  }

  void PlayStep(const ScenarioStep& step) {
    ++step_;
    for (const KeyValue& value : step.set) Set(value);
    for (const PlacedRule& placed : step.leaves) ChangeScript(placed);
    clock_.Advance(step.advance);
    sink_.messages.clear();
    tree_.TakeEvents();
    Status status = Status::kIdle;
    if (step.halt) {
      tree_.executor().Halt();
    } else {
      for (int i = 0; i < step.ticks; ++i) status = tree_.executor().Tick();
    }
    Compare(step.expect, status);
  }

  void Set(const KeyValue& given) {
    const SlotIndex slot = Find(given);
    if (slot == kNoSlot) return;
    const Type* type = tree_.program().layout.slots[slot].type;
    Value value = ValueOf(given, type);
    if (value.has_value()) {
      tree_.executor().inbox()->Post(slot, 0, std::move(value));
    } else {
      Add(given.where, "key \"" + given.key + "\"", std::string("a value of type ") + type->name,
          given.text);
    }
  }

  void ChangeScript(const PlacedRule& placed) {
    if (tree_.ChangeScript(placed.rule.pattern, placed.rule.script) > 0) return;
    Add(placed.where, "leaves",
        "a node with a script from the start that fits \"" + placed.rule.pattern + "\"", "none");
  }

  // The slot of "path of the instance/key".
  SlotIndex Find(const KeyValue& given) {
    const Layout& layout = tree_.program().layout;
    const std::size_t slash = given.key.rfind('/');
    const bool inner = slash != std::string::npos;
    const std::string path = inner ? given.key.substr(0, slash) : "";
    const std::string key = inner ? given.key.substr(slash + 1) : given.key;
    const std::vector<TreeInstance>& trees = tree_.program().trees;
    for (ScopeIndex scope = 0; scope < trees.size(); ++scope) {
      if (trees[scope].path != path) continue;
      const SlotIndex slot = layout.Find(scope, key);
      if (slot != kNoSlot) return slot;
    }
    std::vector<std::string> keys;
    for (const SlotDefinition& slot : layout.slots) {
      const std::string& instance = trees[slot.scope].path;
      if (!slot.key.empty())
        keys.push_back(instance.empty() ? slot.key : instance + "/" + slot.key);
    }
    const std::string hint = DidYouMean(given.key, keys);
    Add(given.where, "key \"" + given.key + "\"", "a key of the tree",
        "none" + (hint.empty() ? "" : ", " + hint));
    return kNoSlot;
  }

  void Compare(const Expectations& expect, Status status) {
    if (expect.status && expect.status->status != status) {
      Add(expect.status->where, "status of the tree", ToString(expect.status->status),
          ToString(status));
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
    } else if (const Status got = tree_.executor().status(first->second); got != expected.status) {
      Add(expected.where, "status of node \"" + expected.node + "\"", ToString(expected.status),
          ToString(got));
    }
  }

  void CompareValue(const ExpectedValue& expected) {
    const SlotIndex slot = Find(expected.value);
    if (slot == kNoSlot) return;
    const Value& got = tree_.executor().blackboard()[slot].value;
    const std::string what = "key \"" + expected.value.key + "\"";
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
    for (const NodeMessage& message : sink_.messages) {
      if (message.text.find(expected.part) != std::string::npos) return;
      all += (all.empty() ? "" : "; ") + tree_.program().Path(message.node) + ": " + message.text;
    }
    Add(expected.where, "messages", "one with \"" + expected.part + "\"",
        all.empty() ? "none" : all);
  }

  // Reports the first event that differs, in its surroundings.
  void CompareEvents(const ExpectedEvents& expected) {
    const std::vector<LeafEvent> got = tree_.TakeEvents();
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
    const Program& program = tree_.program();
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
    const std::string leaf = tree_.program().Name(event.node);
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

  const Scenario& scenario_;
  SimulatedClock clock_;
  KeepMessages sink_;
  MockedTree tree_;
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
