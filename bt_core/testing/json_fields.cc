#include "bt_core/testing/json_fields.h"

#include <cmath>
#include <cstdlib>

namespace coppice {
namespace {

using Kind = JsonValue::Kind;

const char* NameOf(Kind kind) {
  static const char* const kNames[] = {"null",   "a boolean", "a number",
                                       "a text", "a list",    "an object"};
  return kNames[static_cast<int>(kind)];
}

}  // namespace

bool JsonFields::Require(const JsonValue& json, Kind kind) {
  if (json.is(kind)) return true;
  const std::string name = json.key.empty() ? "this" : "\"" + json.key + "\"";
  Error(json, name + " must be " + NameOf(kind) + ", not " + NameOf(json.kind));
  return false;
}

void JsonFields::Unknown(const JsonValue& member, const std::vector<std::string>& known) {
  std::string list;
  for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
  Error(member, "unknown member \"" + member.key + "\", expected " + list,
        DidYouMean(member.key, known));
}

const std::vector<JsonValue>& JsonFields::ListOf(const JsonValue& json) {
  return Require(json, Kind::kArray) ? json.children : none_;
}

const std::vector<JsonValue>& JsonFields::MembersOf(const JsonValue& json) {
  return Require(json, Kind::kObject) ? json.children : none_;
}

bool JsonFields::ReadBool(const JsonValue& json) {
  return Require(json, Kind::kBool) && json.text == "true";
}

std::string JsonFields::ReadText(const JsonValue& json) {
  return Require(json, Kind::kString) ? json.text : std::string();
}

double JsonFields::ReadNumber(const JsonValue& json, double most, const char* expected) {
  const double value = Require(json, Kind::kNumber) ? std::strtod(json.text.c_str(), nullptr) : 0;
  if (value >= 0 && value <= most) return value;
  Error(json, expected);
  return 0;
}

int JsonFields::ReadCount(const JsonValue& json) {
  constexpr const char* kExpected = "expected a whole number from 0 to 1000000";
  const double value = ReadNumber(json, 1e6, kExpected);
  if (value != std::floor(value)) Error(json, kExpected);
  return static_cast<int>(value);
}

std::uint64_t JsonFields::ReadSeed(const JsonValue& json) {
  const bool digits = Require(json, Kind::kNumber) && json.text.size() < 20 &&
                      json.text.find_first_not_of("0123456789") == std::string::npos;
  if (digits) return std::stoull(json.text);
  Error(json, "expected a whole number, not negative");
  return 0;
}

Duration JsonFields::ReadMilliseconds(const JsonValue& json) {
  constexpr double kLimit = 1e12;  // some thirty years
  const double value = ReadNumber(json, kLimit, "expected a time in milliseconds, not negative");
  return Duration(std::llround(value * 1e6));
}

Status JsonFields::ReadStatus(const JsonValue& json) {
  std::vector<std::string> names;
  for (const Status status :
       {Status::kIdle, Status::kRunning, Status::kSuccess, Status::kFailure, Status::kSkipped}) {
    if (json.is(Kind::kString) && json.text == ToString(status)) return status;
    names.emplace_back(ToString(status));
  }
  Error(json, "expected a status: RUNNING, SUCCESS, FAILURE, SKIPPED or IDLE",
        DidYouMean(json.text, names));
  return Status::kIdle;
}

KeyValue JsonFields::ReadValue(const JsonValue& json) {
  KeyValue value{json.where, json.key, json.text, KeyValue::Kind::kString};
  if (json.is(Kind::kNumber)) value.kind = KeyValue::Kind::kNumber;
  if (json.is(Kind::kBool)) value.kind = KeyValue::Kind::kBool;
  if (json.is(Kind::kArray) || json.is(Kind::kObject)) {
    Error(json, "expected a text, a number or a boolean",
          "values of other types are given as text, as in the XML");
  }
  return value;
}

std::vector<KeyValue> JsonFields::ReadValues(const JsonValue& json) {
  std::vector<KeyValue> values;
  for (const JsonValue& member : MembersOf(json)) values.push_back(ReadValue(member));
  return values;
}

std::vector<KeyValue> JsonFields::ReadChoice(const JsonValue& json) {
  if (!json.is(Kind::kArray)) return {ReadValue(json)};
  std::vector<KeyValue> values;
  for (const JsonValue& element : json.children) {
    values.push_back(ReadValue(element));
    values.back().key = json.key;
  }
  if (values.empty()) Error(json, "expected at least one value");
  return values;
}

}  // namespace coppice
