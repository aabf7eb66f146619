// Reads files of scenarios. Every error says where it is; an unknown member is an error.
#include <filesystem>

#include "bt_core/base/read_file.h"
#include "bt_core/testing/script_fields.h"

namespace coppice {
namespace {

using Kind = JsonValue::Kind;

std::string Beside(const std::filesystem::path& file, const std::filesystem::path& other) {
  return (file.parent_path() / other).lexically_normal();
}

class SuiteReader : public ScriptFields {
 public:
  using ScriptFields::ScriptFields;

  ScenarioSuite ReadSuite(const JsonValue& json, const std::string& file) {
    ScenarioSuite suite;
    suite.file = file;
    if (!Require(json, Kind::kObject)) return suite;
    for (const JsonValue& member : json.children) {
      if (member.key == "tree") {
        suite.tree_file = Beside(file, ReadText(member));
      } else if (member.key == "models") {
        suite.models_file = Beside(file, ReadText(member));
      } else if (member.key == "tree_id") {
        suite.tree_id = ReadText(member);
      } else if (member.key == "leaves") {
        suite.leaves = ReadRules(member);
      } else if (member.key == "random") {
        suite.random = ReadRandom(member);
      } else if (member.key == "scenarios") {
        for (const JsonValue& scenario : ListOf(member)) {
          suite.scenarios.push_back(ReadScenario(scenario));
        }
      } else {
        Unknown(member, {"tree", "tree_id", "models", "leaves", "random", "scenarios"});
      }
    }
    if (suite.tree_file.empty()) Error(json, "\"tree\" is missing");
    if (suite.scenarios.empty()) Error(json, "there are no \"scenarios\"");
    return suite;
  }

 private:
  RandomPlay ReadRandom(const JsonValue& json) {
    RandomPlay random;
    random.where = json.where;
    for (const JsonValue& member : MembersOf(json)) {
      if (member.key == "set") {
        for (const JsonValue& key : MembersOf(member)) random.set.push_back(ReadChoice(key));
      } else if (member.key == "leaves") {
        random.leaves = ReadRules(member);
      } else if (member.key == "lasts_ms") {
        random.lasts = ReadMilliseconds(member);
      } else {
        Unknown(member, {"set", "leaves", "lasts_ms"});
      }
    }
    return random;
  }

  Scenario ReadScenario(const JsonValue& json) {
    Scenario scenario;
    scenario.where = json.where;
    if (!Require(json, Kind::kObject)) return scenario;
    for (const JsonValue& member : json.children) {
      if (member.key == "name") {
        scenario.name = ReadText(member);
      } else if (member.key == "seed") {
        scenario.seed = ReadSeed(member);
      } else if (member.key == "leaves") {
        scenario.leaves = ReadRules(member);
      } else if (member.key == "own_leaves") {
        scenario.own_leaves = ReadBool(member);
      } else if (member.key == "steps") {
        for (const JsonValue& step : ListOf(member)) scenario.steps.push_back(ReadStep(step));
      } else {
        Unknown(member, {"name", "seed", "leaves", "own_leaves", "steps"});
      }
    }
    if (scenario.name.empty()) Error(json, "\"name\" is missing");
    if (scenario.steps.empty()) Error(json, "there are no \"steps\"");
    return scenario;
  }

  ScenarioStep ReadStep(const JsonValue& json) {
    ScenarioStep step;
    step.where = json.where;
    if (!Require(json, Kind::kObject)) return step;
    for (const JsonValue& member : json.children) {
      if (member.key == "set") {
        step.set = ReadValues(member);
      } else if (member.key == "leaves") {
        step.leaves = ReadRules(member);
      } else if (member.key == "advance_ms") {
        step.advance = ReadMilliseconds(member);
      } else if (member.key == "ticks") {
        step.ticks = ReadCount(member);
      } else if (member.key == "halt") {
        step.halt = ReadBool(member);
      } else if (member.key == "expect") {
        step.expect = ReadExpectations(member);
      } else {
        Unknown(member, {"set", "leaves", "advance_ms", "ticks", "halt", "expect"});
      }
    }
    if (step.halt && json.Find("ticks")) {
      Error(json, "a step either ticks or halts the tree");
    }
    return step;
  }

  Expectations ReadExpectations(const JsonValue& json) {
    Expectations expect;
    if (!Require(json, Kind::kObject)) return expect;
    for (const JsonValue& member : json.children) {
      if (member.key == "status") {
        expect.status = ExpectedStatus{member.where, "", ReadStatus(member)};
      } else if (member.key == "nodes") {
        for (const JsonValue& node : MembersOf(member)) {
          expect.nodes.push_back({node.where, node.key, ReadStatus(node)});
        }
      } else if (member.key == "events") {
        expect.events = ReadEvents(member);
      } else if (member.key == "blackboard") {
        for (const JsonValue& value : MembersOf(member)) {
          expect.blackboard.push_back({ReadValue(value), value.is(Kind::kNull)});
        }
      } else if (member.key == "messages") {
        for (const JsonValue& part : ListOf(member)) {
          expect.messages.push_back({part.where, ReadText(part)});
        }
      } else {
        Unknown(member, {"status", "nodes", "events", "blackboard", "messages"});
      }
    }
    return expect;
  }

  ExpectedEvents ReadEvents(const JsonValue& json) {
    ExpectedEvents events{json.where, {}};
    for (const JsonValue& event : ListOf(json)) events.events.push_back(ReadEvent(event));
    return events;
  }

  // ["tick", "name", "STATUS", {inputs}] or ["halt", "name"]
  ExpectedEvent ReadEvent(const JsonValue& json) {
    ExpectedEvent event;
    event.where = json.where;
    const std::vector<JsonValue>& parts = ListOf(json);
    const std::string kind = parts.empty() ? "" : parts[0].text;
    const bool halt = kind == "halt" && parts.size() == 2;
    const bool tick = kind == "tick" && parts.size() >= 2 && parts.size() <= 4;
    if (!halt && !tick) {
      Error(json, "expected [\"tick\", \"leaf\", \"STATUS\"] or [\"halt\", \"leaf\"]");
      return event;
    }
    event.halted = halt;
    event.leaf = ReadText(parts[1]);
    if (parts.size() > 2) event.status = ReadStatus(parts[2]);
    if (parts.size() > 3) event.inputs = ReadValues(parts[3]);
    return event;
  }
};

}  // namespace

std::optional<ScenarioSuite> ParseScenarios(const std::string& text, const std::string& file,
                                            Diagnostics& diagnostics) {
  Diagnostics problems;
  const std::optional<JsonValue> json = ParseJson(text, file, problems);
  std::optional<ScenarioSuite> suite;
  if (json) suite = SuiteReader(problems).ReadSuite(*json, file);
  for (const Diagnostic& problem : problems.all()) {
    diagnostics.Error(problem.where, problem.message, problem.hint);
  }
  if (problems.has_errors()) suite.reset();
  return suite;
}

std::optional<ScenarioSuite> LoadScenarios(const std::string& path, Diagnostics& diagnostics) {
  const std::optional<std::string> text = ReadFile(path, diagnostics, kLongestJson);
  return text ? ParseScenarios(*text, path, diagnostics) : std::nullopt;
}

}  // namespace coppice
