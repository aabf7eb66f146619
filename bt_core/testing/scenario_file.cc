// Reads files of scenarios. Every error says where it is; an unknown member is an error.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "bt_core/testing/json_text.h"
#include "bt_core/testing/scenario.h"

namespace coppice {
namespace {

using Kind = JsonText::Kind;

const char* ToString(Kind kind) {
  static const char* const kNames[] = {"null",   "a boolean", "a number",
                                       "a text", "a list",    "an object"};
  return kNames[static_cast<int>(kind)];
}

std::string Beside(const std::filesystem::path& file, const std::filesystem::path& other) {
  return (file.parent_path() / other).lexically_normal();
}

class SuiteReader {
 public:
  explicit SuiteReader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  ScenarioSuite ReadSuite(const JsonText& json, const std::string& file) {
    ScenarioSuite suite;
    suite.file = file;
    if (!Require(json, Kind::kObject)) return suite;
    for (const JsonText& member : json.children) {
      if (member.key == "tree") {
        suite.tree_file = Beside(file, ReadText(member));
      } else if (member.key == "models") {
        suite.models_file = Beside(file, ReadText(member));
      } else if (member.key == "tree_id") {
        suite.tree_id = ReadText(member);
      } else if (member.key == "leaves") {
        suite.leaves = ReadRules(member);
      } else if (member.key == "scenarios") {
        for (const JsonText& scenario : ListOf(member)) {
          suite.scenarios.push_back(ReadScenario(scenario));
        }
      } else {
        Unknown(member, {"tree", "tree_id", "models", "leaves", "scenarios"});
      }
    }
    if (suite.tree_file.empty()) diagnostics_.Error(json.where, "\"tree\" is missing");
    if (suite.scenarios.empty()) diagnostics_.Error(json.where, "there are no \"scenarios\"");
    return suite;
  }

 private:
  Scenario ReadScenario(const JsonText& json) {
    Scenario scenario;
    scenario.where = json.where;
    if (!Require(json, Kind::kObject)) return scenario;
    for (const JsonText& member : json.children) {
      if (member.key == "name") {
        scenario.name = ReadText(member);
      } else if (member.key == "seed") {
        scenario.seed = ReadSeed(member);
      } else if (member.key == "leaves") {
        scenario.leaves = ReadRules(member);
      } else if (member.key == "steps") {
        for (const JsonText& step : ListOf(member)) scenario.steps.push_back(ReadStep(step));
      } else {
        Unknown(member, {"name", "seed", "leaves", "steps"});
      }
    }
    if (scenario.name.empty()) diagnostics_.Error(json.where, "\"name\" is missing");
    if (scenario.steps.empty()) diagnostics_.Error(json.where, "there are no \"steps\"");
    return scenario;
  }

  ScenarioStep ReadStep(const JsonText& json) {
    ScenarioStep step;
    step.where = json.where;
    if (!Require(json, Kind::kObject)) return step;
    for (const JsonText& member : json.children) {
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
      diagnostics_.Error(json.where, "a step either ticks or halts the tree");
    }
    return step;
  }

  Expectations ReadExpectations(const JsonText& json) {
    Expectations expect;
    if (!Require(json, Kind::kObject)) return expect;
    for (const JsonText& member : json.children) {
      if (member.key == "status") {
        expect.status = ExpectedStatus{member.where, "", ReadStatus(member)};
      } else if (member.key == "nodes") {
        for (const JsonText& node : MembersOf(member)) {
          expect.nodes.push_back({node.where, node.key, ReadStatus(node)});
        }
      } else if (member.key == "events") {
        expect.events = ReadEvents(member);
      } else if (member.key == "blackboard") {
        for (const JsonText& value : MembersOf(member)) {
          expect.blackboard.push_back({ReadValue(value), value.is(Kind::kNull)});
        }
      } else if (member.key == "messages") {
        for (const JsonText& part : ListOf(member)) {
          expect.messages.push_back({part.where, ReadText(part)});
        }
      } else {
        Unknown(member, {"status", "nodes", "events", "blackboard", "messages"});
      }
    }
    return expect;
  }

  ExpectedEvents ReadEvents(const JsonText& json) {
    ExpectedEvents events{json.where, {}};
    for (const JsonText& event : ListOf(json)) events.events.push_back(ReadEvent(event));
    return events;
  }

  // ["tick", "name", "STATUS", {inputs}] or ["halt", "name"]
  ExpectedEvent ReadEvent(const JsonText& json) {
    ExpectedEvent event;
    event.where = json.where;
    const std::vector<JsonText>& parts = ListOf(json);
    const std::string kind = parts.empty() ? "" : parts[0].text;
    const bool halt = kind == "halt" && parts.size() == 2;
    const bool tick = kind == "tick" && parts.size() >= 2 && parts.size() <= 4;
    if (!halt && !tick) {
      diagnostics_.Error(json.where,
                         "expected [\"tick\", \"leaf\", \"STATUS\"] or [\"halt\", \"leaf\"]");
      return event;
    }
    event.halted = halt;
    event.leaf = ReadText(parts[1]);
    if (parts.size() > 2) event.status = ReadStatus(parts[2]);
    if (parts.size() > 3) event.inputs = ReadValues(parts[3]);
    return event;
  }

  std::vector<PlacedRule> ReadRules(const JsonText& json) {
    std::vector<PlacedRule> rules;
    for (const JsonText& member : MembersOf(json)) {
      rules.push_back({member.where, {member.key, ReadScript(member)}});
    }
    return rules;
  }

  MockScript ReadScript(const JsonText& json) {
    MockScript script;
    if (!json.is(Kind::kObject)) {
      script.results = ReadResults(json);
      return script;
    }
    for (const JsonText& member : json.children) {
      if (member.key == "returns") {
        script.results = ReadResults(member);
      } else if (member.key == "restart") {
        script.restart = ReadBool(member);
      } else if (member.key == "after_ms") {
        script.duration = ReadMilliseconds(member);
      } else if (member.key == "chances") {
        script.chances = ReadChances(member);
      } else if (member.key == "outputs") {
        for (const KeyValue& value : ReadValues(member)) {
          script.outputs.emplace_back(value.key, value.text);
        }
      } else if (member.key == "feedback") {
        for (const KeyValue& value : ReadValues(member)) {
          script.feedback.emplace_back(value.key, value.text);
        }
      } else if (member.key == "says") {
        script.says = ReadText(member);
      } else if (member.key == "throws") {
        script.throws = ReadText(member);
      } else {
        Unknown(member, {"returns", "restart", "after_ms", "chances", "outputs", "feedback", "says",
                         "throws"});
      }
    }
    if (script.chances && (json.Find("returns") || json.Find("after_ms"))) {
      diagnostics_.Error(json.where, "\"chances\" stands for \"returns\" and \"after_ms\"");
    }
    return script;
  }

  // {"SUCCESS": 8, "FAILURE": 2, "after_ms": [0, 2000]}
  Chances ReadChances(const JsonText& json) {
    Chances chances;
    for (const JsonText& member : MembersOf(json)) {
      if (member.key == "SUCCESS") {
        chances.success = ReadShare(member);
      } else if (member.key == "FAILURE") {
        chances.failure = ReadShare(member);
      } else if (member.key == "SKIPPED") {
        chances.skipped = ReadShare(member);
      } else if (member.key == "after_ms") {
        ReadRange(member, chances);
      } else {
        Unknown(member, {"SUCCESS", "FAILURE", "SKIPPED", "after_ms"});
      }
    }
    if (chances.success + chances.failure + chances.skipped <= 0) {
      diagnostics_.Error(json.where, "\"chances\" needs a share of SUCCESS, FAILURE or SKIPPED");
    }
    return chances;
  }

  double ReadShare(const JsonText& json) {
    constexpr double kLimit = 1e9;
    const double value = Require(json, Kind::kNumber) ? std::strtod(json.text.c_str(), nullptr) : 0;
    if (value >= 0 && value <= kLimit) return value;
    diagnostics_.Error(json.where, "expected a share, not negative");
    return 0;
  }

  // 500 or [0, 2000]
  void ReadRange(const JsonText& json, Chances& chances) {
    if (!json.is(Kind::kArray)) {
      chances.shortest = chances.longest = ReadMilliseconds(json);
      return;
    }
    if (json.children.size() == 2) {
      chances.shortest = ReadMilliseconds(json.children[0]);
      chances.longest = ReadMilliseconds(json.children[1]);
    }
    if (json.children.size() != 2 || chances.longest < chances.shortest) {
      diagnostics_.Error(json.where, "expected the shortest and the longest time");
    }
  }

  std::uint64_t ReadSeed(const JsonText& json) {
    const bool digits = Require(json, Kind::kNumber) && json.text.size() < 20 &&
                        json.text.find_first_not_of("0123456789") == std::string::npos;
    if (digits) return std::stoull(json.text);
    diagnostics_.Error(json.where, "expected a whole number, not negative");
    return 0;
  }

  std::vector<Status> ReadResults(const JsonText& json) {
    std::vector<Status> results;
    if (!json.is(Kind::kArray)) return {ReadResult(json)};
    for (const JsonText& result : json.children) results.push_back(ReadResult(result));
    return results;
  }

  Status ReadResult(const JsonText& json) {
    const Status status = ReadStatus(json);
    if (status == Status::kIdle && json.text == "IDLE") {
      diagnostics_.Error(json.where, "IDLE is not a result that a node may return");
    }
    return status;
  }

  Status ReadStatus(const JsonText& json) {
    std::vector<std::string> names;
    for (const Status status :
         {Status::kIdle, Status::kRunning, Status::kSuccess, Status::kFailure, Status::kSkipped}) {
      if (json.is(Kind::kString) && json.text == coppice::ToString(status)) return status;
      names.emplace_back(coppice::ToString(status));
    }
    diagnostics_.Error(json.where, "expected a status: RUNNING, SUCCESS, FAILURE, SKIPPED or IDLE",
                       DidYouMean(json.text, names));
    return Status::kIdle;
  }

  std::vector<KeyValue> ReadValues(const JsonText& json) {
    std::vector<KeyValue> values;
    for (const JsonText& member : MembersOf(json)) values.push_back(ReadValue(member));
    return values;
  }

  KeyValue ReadValue(const JsonText& json) {
    KeyValue value{json.where, json.key, json.text, KeyValue::Kind::kString};
    if (json.is(Kind::kNumber)) value.kind = KeyValue::Kind::kNumber;
    if (json.is(Kind::kBool)) value.kind = KeyValue::Kind::kBool;
    if (json.is(Kind::kArray) || json.is(Kind::kObject)) {
      diagnostics_.Error(json.where, "expected a text, a number or a boolean",
                         "values of other types are given as text, as in the XML");
    }
    return value;
  }

  Duration ReadMilliseconds(const JsonText& json) {
    constexpr double kLimit = 1e12;  // some thirty years
    const double value = Require(json, Kind::kNumber) ? std::strtod(json.text.c_str(), nullptr) : 0;
    if (!(value >= 0 && value <= kLimit)) {
      diagnostics_.Error(json.where, "expected a time in milliseconds, not negative");
      return Duration(0);
    }
    return Duration(std::llround(value * 1e6));
  }

  int ReadCount(const JsonText& json) {
    constexpr double kLimit = 1e6;
    const double value = Require(json, Kind::kNumber) ? std::strtod(json.text.c_str(), nullptr) : 0;
    if (!(value >= 0 && value <= kLimit && value == std::floor(value))) {
      diagnostics_.Error(json.where, "expected a whole number from 0 to 1000000");
      return 0;
    }
    return static_cast<int>(value);
  }

  bool ReadBool(const JsonText& json) { return Require(json, Kind::kBool) && json.text == "true"; }

  std::string ReadText(const JsonText& json) {
    return Require(json, Kind::kString) ? json.text : std::string();
  }

  const std::vector<JsonText>& ListOf(const JsonText& json) {
    return Require(json, Kind::kArray) ? json.children : none_;
  }
  const std::vector<JsonText>& MembersOf(const JsonText& json) {
    return Require(json, Kind::kObject) ? json.children : none_;
  }

  bool Require(const JsonText& json, Kind kind) {
    if (json.is(kind)) return true;
    const std::string name = json.key.empty() ? "this" : "\"" + json.key + "\"";
    diagnostics_.Error(json.where,
                       name + " must be " + ToString(kind) + ", not " + ToString(json.kind));
    return false;
  }

  void Unknown(const JsonText& member, const std::vector<std::string>& known) {
    std::string list;
    for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
    diagnostics_.Error(member.where, "unknown member \"" + member.key + "\", expected " + list,
                       DidYouMean(member.key, known));
  }

  Diagnostics& diagnostics_;
  const std::vector<JsonText> none_;
};

}  // namespace

std::optional<ScenarioSuite> ParseScenarios(const std::string& text, const std::string& file,
                                            Diagnostics& diagnostics) {
  Diagnostics problems;
  const std::optional<JsonText> json = ParseJsonText(text, file, problems);
  std::optional<ScenarioSuite> suite;
  if (json) suite = SuiteReader(problems).ReadSuite(*json, file);
  for (const Diagnostic& problem : problems.all()) {
    diagnostics.Error(problem.where, problem.message, problem.hint);
  }
  if (problems.has_errors()) suite.reset();
  return suite;
}

std::optional<ScenarioSuite> LoadScenarios(const std::string& path, Diagnostics& diagnostics) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) {
    diagnostics.Error({path, 0, 0}, "cannot be read");
    return std::nullopt;
  }
  return ParseScenarios(text, path, diagnostics);
}

}  // namespace coppice
