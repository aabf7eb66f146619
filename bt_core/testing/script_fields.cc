#include "bt_core/testing/script_fields.h"

namespace coppice {

using Kind = JsonValue::Kind;

std::vector<PlacedRule> ScriptFields::ReadRules(const JsonValue& json) {
  std::vector<PlacedRule> rules;
  for (const JsonValue& member : MembersOf(json)) {
    rules.push_back({member.where, {member.key, ReadScript(member)}});
  }
  return rules;
}

MockScript ScriptFields::ReadScript(const JsonValue& json) {
  MockScript script;
  if (!json.is(Kind::kObject)) {
    script.results = ReadResults(json);
    return script;
  }
  for (const JsonValue& member : json.children) {
    if (member.key == "returns") {
      script.results = ReadResults(member);
    } else if (member.key == "restart") {
      script.restart = ReadBool(member);
    } else if (member.key == "after_ms") {
      script.duration = ReadMilliseconds(member);
    } else if (member.key == "chances") {
      script.chances = ReadChances(member);
    } else if (member.key == "outputs") {
      ReadOutputs(member, script);
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
    Error(json, "\"chances\" stands for \"returns\" and \"after_ms\"");
  }
  return script;
}

// {"goal": "1;2;0", "rung": [0, 1, 2]}
void ScriptFields::ReadOutputs(const JsonValue& json, MockScript& script) {
  for (const JsonValue& member : MembersOf(json)) {
    std::vector<std::string> texts;
    for (const KeyValue& value : ReadChoice(member)) texts.push_back(value.text);
    if (member.is(Kind::kArray)) {
      script.outputs_by_chance.emplace_back(member.key, std::move(texts));
    } else {
      script.outputs.emplace_back(member.key, std::move(texts.front()));
    }
  }
}

// {"SUCCESS": 8, "FAILURE": 2, "after_ms": [0, 2000], "holds_ms": 500}
Chances ScriptFields::ReadChances(const JsonValue& json) {
  Chances chances;
  for (const JsonValue& member : MembersOf(json)) {
    if (member.key == "SUCCESS") {
      chances.success = ReadShare(member);
    } else if (member.key == "FAILURE") {
      chances.failure = ReadShare(member);
    } else if (member.key == "SKIPPED") {
      chances.skipped = ReadShare(member);
    } else if (member.key == "after_ms") {
      ReadRange(member, chances.shortest, chances.longest);
    } else if (member.key == "holds_ms") {
      ReadRange(member, chances.shortest_hold, chances.longest_hold);
    } else {
      Unknown(member, {"SUCCESS", "FAILURE", "SKIPPED", "after_ms", "holds_ms"});
    }
  }
  if (chances.success + chances.failure + chances.skipped <= 0) {
    Error(json, "\"chances\" needs a share of SUCCESS, FAILURE or SKIPPED");
  }
  return chances;
}

double ScriptFields::ReadShare(const JsonValue& json) {
  constexpr double kLimit = 1e9;
  return ReadNumber(json, kLimit, "expected a share, not negative");
}

// 500 or [0, 2000]
void ScriptFields::ReadRange(const JsonValue& json, Duration& shortest, Duration& longest) {
  if (!json.is(Kind::kArray)) {
    shortest = longest = ReadMilliseconds(json);
    return;
  }
  if (json.children.size() == 2) {
    shortest = ReadMilliseconds(json.children[0]);
    longest = ReadMilliseconds(json.children[1]);
  }
  if (json.children.size() != 2 || longest < shortest) {
    Error(json, "expected the shortest and the longest time");
  }
}

std::vector<Status> ScriptFields::ReadResults(const JsonValue& json) {
  std::vector<Status> results;
  if (!json.is(Kind::kArray)) return {ReadResult(json)};
  for (const JsonValue& result : json.children) results.push_back(ReadResult(result));
  return results;
}

Status ScriptFields::ReadResult(const JsonValue& json) {
  const Status status = ReadStatus(json);
  if (status == Status::kIdle && json.text == "IDLE") {
    Error(json, "IDLE is not a result that a node may return");
  }
  return status;
}

}  // namespace coppice
