#include "bt_core/testing/scenario_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "bt_core/base/json.h"
#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"

namespace coppice {
namespace {

using Kind = JsonValue::Kind;

JsonValue Make(Kind kind, std::string text = {}) {
  JsonValue json;
  json.kind = kind;
  json.text = std::move(text);
  return json;
}
JsonValue Text(std::string text) { return Make(Kind::kString, std::move(text)); }
JsonValue Object() { return Make(Kind::kObject); }
JsonValue Array() { return Make(Kind::kArray); }
JsonValue StatusText(Status status) { return Text(ToString(status)); }

void Add(JsonValue& object, std::string key, JsonValue value) {
  value.key = std::move(key);
  object.children.push_back(std::move(value));
}

JsonValue Milliseconds(Duration duration) {
  const auto count = duration.count();
  std::string text = std::to_string(count / 1'000'000);
  if (std::string rest = std::to_string(count % 1'000'000); rest != "0") {
    rest.insert(0, 6 - rest.size(), '0');
    rest.erase(rest.find_last_not_of('0') + 1);
    text += "." + rest;
  }
  return Make(Kind::kNumber, text);
}

JsonValue ValueText(const KeyValue& value) {
  static constexpr Kind kKinds[] = {Kind::kString, Kind::kNumber, Kind::kBool};
  return Make(kKinds[static_cast<int>(value.kind)], value.text);
}

JsonValue Values(const std::vector<KeyValue>& values) {
  JsonValue object = Object();
  for (const KeyValue& value : values) Add(object, value.key, ValueText(value));
  return object;
}

JsonValue Results(const std::vector<Status>& results) {
  if (results.size() == 1) return StatusText(results[0]);
  JsonValue list = Array();
  for (const Status result : results) list.children.push_back(StatusText(result));
  return list;
}

JsonValue Share(double share) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.9g", share);
  return Make(Kind::kNumber, text);
}

JsonValue ChancesText(const Chances& chances) {
  JsonValue object = Object();
  Add(object, "SUCCESS", Share(chances.success));
  if (chances.failure > 0) Add(object, "FAILURE", Share(chances.failure));
  if (chances.skipped > 0) Add(object, "SKIPPED", Share(chances.skipped));
  if (chances.longest > Duration(0)) {
    JsonValue range = Array();
    range.children = {Milliseconds(chances.shortest), Milliseconds(chances.longest)};
    Add(object, "after_ms", std::move(range));
  }
  if (chances.longest_hold > Duration(0)) {
    JsonValue range = Array();
    range.children = {Milliseconds(chances.shortest_hold), Milliseconds(chances.longest_hold)};
    Add(object, "holds_ms", std::move(range));
  }
  return object;
}

JsonValue Ports(const std::vector<std::pair<std::string, std::string>>& values) {
  JsonValue object = Object();
  for (const auto& [port, text] : values) Add(object, port, Text(text));
  return object;
}

JsonValue Outputs(const MockScript& script) {
  JsonValue object = Ports(script.outputs);
  for (const auto& [port, texts] : script.outputs_by_chance) {
    JsonValue list = Array();
    for (const std::string& text : texts) list.children.push_back(Text(text));
    Add(object, port, std::move(list));
  }
  return object;
}

JsonValue ScriptText(const MockScript& script) {
  JsonValue object = Object();
  if (script.chances) Add(object, "chances", ChancesText(*script.chances));
  if (script.duration > Duration(0)) Add(object, "after_ms", Milliseconds(script.duration));
  if (!script.results.empty()) Add(object, "returns", Results(script.results));
  if (script.restart) Add(object, "restart", Make(Kind::kBool, "true"));
  JsonValue outputs = Outputs(script);
  if (!outputs.children.empty()) Add(object, "outputs", std::move(outputs));
  if (!script.feedback.empty()) Add(object, "feedback", Ports(script.feedback));
  if (!script.says.empty()) Add(object, "says", Text(script.says));
  if (!script.throws.empty()) Add(object, "throws", Text(script.throws));
  const bool only_results = object.children.size() == 1 && !script.results.empty();
  return only_results ? Results(script.results) : object;
}

JsonValue Rules(const std::vector<PlacedRule>& rules) {
  JsonValue object = Object();
  for (const PlacedRule& placed : rules) {
    Add(object, placed.rule.pattern, ScriptText(placed.rule.script));
  }
  return object;
}

JsonValue RandomText(const RandomPlay& random) {
  JsonValue object = Object();
  JsonValue set = Object();
  for (const std::vector<KeyValue>& choice : random.set) {
    JsonValue list = Array();
    for (const KeyValue& value : choice) list.children.push_back(ValueText(value));
    Add(set, choice.front().key, std::move(list));
  }
  if (!set.children.empty()) Add(object, "set", std::move(set));
  if (!random.leaves.empty()) Add(object, "leaves", Rules(random.leaves));
  if (random.lasts > Duration(0)) Add(object, "lasts_ms", Milliseconds(random.lasts));
  return object;
}

JsonValue EventText(const ExpectedEvent& event) {
  JsonValue list = Array();
  list.children.push_back(Text(event.halted ? "halt" : "tick"));
  list.children.push_back(Text(event.leaf));
  if (event.status) list.children.push_back(StatusText(*event.status));
  if (!event.inputs.empty()) list.children.push_back(Values(event.inputs));
  return list;
}

JsonValue ExpectationsText(const Expectations& expect) {
  JsonValue object = Object();
  if (expect.status) Add(object, "status", StatusText(expect.status->status));
  if (!expect.nodes.empty()) {
    JsonValue nodes = Object();
    for (const ExpectedStatus& node : expect.nodes) Add(nodes, node.node, StatusText(node.status));
    Add(object, "nodes", std::move(nodes));
  }
  if (expect.events) {
    JsonValue events = Array();
    for (const ExpectedEvent& event : expect.events->events) {
      events.children.push_back(EventText(event));
    }
    Add(object, "events", std::move(events));
  }
  if (!expect.blackboard.empty()) {
    JsonValue board = Object();
    for (const ExpectedValue& value : expect.blackboard) {
      Add(board, value.value.key, value.unset ? Make(Kind::kNull, "null") : ValueText(value.value));
    }
    Add(object, "blackboard", std::move(board));
  }
  if (!expect.messages.empty()) {
    JsonValue messages = Array();
    for (const ExpectedMessage& message : expect.messages) {
      messages.children.push_back(Text(message.part));
    }
    Add(object, "messages", std::move(messages));
  }
  return object;
}

JsonValue StepText(const ScenarioStep& step) {
  JsonValue object = Object();
  if (!step.set.empty()) Add(object, "set", Values(step.set));
  if (!step.leaves.empty()) Add(object, "leaves", Rules(step.leaves));
  if (step.advance > Duration(0)) Add(object, "advance_ms", Milliseconds(step.advance));
  if (step.halt) Add(object, "halt", Make(Kind::kBool, "true"));
  if (!step.halt && step.ticks != 1) {
    Add(object, "ticks", Make(Kind::kNumber, std::to_string(step.ticks)));
  }
  JsonValue expect = ExpectationsText(step.expect);
  if (!expect.children.empty()) Add(object, "expect", std::move(expect));
  return object;
}

JsonValue ScenarioText(const Scenario& scenario) {
  JsonValue object = Object();
  Add(object, "name", Text(scenario.name));
  if (scenario.seed != 0) Add(object, "seed", Make(Kind::kNumber, std::to_string(scenario.seed)));
  if (!scenario.leaves.empty()) Add(object, "leaves", Rules(scenario.leaves));
  if (scenario.own_leaves) Add(object, "own_leaves", Make(Kind::kBool, "true"));
  JsonValue steps = Array();
  for (const ScenarioStep& step : scenario.steps) steps.children.push_back(StepText(step));
  Add(object, "steps", std::move(steps));
  return object;
}

std::string RelativeTo(const std::string& file, const std::string& tree) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (folder.empty()) return tree;
  const std::filesystem::path relative = std::filesystem::path(tree).lexically_relative(folder);
  return relative.empty() ? tree : relative.string();
}

bool IsSameTree(const ScenarioSuite& a, const ScenarioSuite& b) {
  std::error_code ignored;  // of a file that there is not; then the paths are compared
  return a.tree_id == b.tree_id && (std::filesystem::path(a.tree_file).lexically_normal() ==
                                        std::filesystem::path(b.tree_file).lexically_normal() ||
                                    std::filesystem::equivalent(a.tree_file, b.tree_file, ignored));
}

// In the text of a file that names none yet.
void NameModels(const ScenarioSuite& suite, std::string& text) {
  if (suite.models_file.empty()) return;
  Diagnostics ignored;  // it was read before
  const std::optional<JsonValue> json = ParseJson(text, suite.file, ignored);
  const std::string path = PrintJson(Text(RelativeTo(suite.file, suite.models_file)));
  text.insert(json->Find("scenarios")->end, ",\n  \"models\": " + path);
}

// Comments and blanks between the last scenario and the bracket stay where they are.
std::size_t EndOfLast(const JsonValue& scenarios) { return scenarios.children.back().end; }

}  // namespace

std::string PrintScenarios(const ScenarioSuite& suite) {
  JsonValue object = Object();
  Add(object, "tree", Text(RelativeTo(suite.file, suite.tree_file)));
  if (!suite.tree_id.empty()) Add(object, "tree_id", Text(suite.tree_id));
  if (!suite.models_file.empty()) {
    Add(object, "models", Text(RelativeTo(suite.file, suite.models_file)));
  }
  if (!suite.leaves.empty()) Add(object, "leaves", Rules(suite.leaves));
  if (suite.random) Add(object, "random", RandomText(*suite.random));
  JsonValue scenarios = Array();
  for (const Scenario& scenario : suite.scenarios) {
    scenarios.children.push_back(ScenarioText(scenario));
  }
  Add(object, "scenarios", std::move(scenarios));
  return PrintJson(object) + "\n";
}

std::optional<std::string> AddScenario(const std::string& text, const std::string& file,
                                       const Scenario& scenario, Diagnostics& diagnostics) {
  const std::optional<ScenarioSuite> suite = ParseScenarios(text, file, diagnostics);
  if (!suite) return std::nullopt;
  for (const Scenario& other : suite->scenarios) {
    if (other.name != scenario.name) continue;
    diagnostics.Error(other.where, "there is a scenario \"" + scenario.name + "\" already");
    return std::nullopt;
  }
  const std::optional<JsonValue> json = ParseJson(text, file, diagnostics);
  Scenario added = scenario;
  added.own_leaves = added.own_leaves || !suite->leaves.empty();
  std::string changed = text;
  changed.insert(EndOfLast(*json->Find("scenarios")),
                 ",\n    " + PrintJson(ScenarioText(added), 4));
  return changed;
}

bool WriteScenario(const Scenario& scenario, const std::string& file, const std::string& tree_file,
                   const std::string& tree_id, Diagnostics& diagnostics,
                   const std::string& models_file) {
  ScenarioSuite suite;
  suite.file = file;
  suite.tree_file = tree_file;
  suite.tree_id = tree_id;
  suite.models_file = models_file;
  suite.scenarios = {scenario};
  std::error_code error;  // told by who writes it
  if (!std::filesystem::exists(file, error)) {
    return WriteFile(file, PrintScenarios(suite), diagnostics);
  }
  const std::optional<std::string> old = ReadFile(file, diagnostics, kLongestJson);
  if (!old) return false;
  std::optional<std::string> changed = AddScenario(*old, file, scenario, diagnostics);
  if (!changed) return false;
  const auto present = ParseScenarios(*old, file, diagnostics);
  if (present->models_file.empty()) NameModels(suite, *changed);
  if (IsSameTree(*present, suite)) return WriteFile(file, *changed, diagnostics);
  diagnostics.Error({file, 1, 1}, "these scenarios are about another tree");
  return false;
}

}  // namespace coppice
