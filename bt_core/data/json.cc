#include "bt_core/data/json.h"

#include <algorithm>

#include "bt_core/base/json.h"
#include "bt_core/data/value.h"

namespace coppice {

using Kind = JsonValue::Kind;

std::string PrintAsJson(const Type& type, const void* value) {
  const std::string text = type.print(value);
  const bool is_plain = type.kind <= TypeKind::kDouble && ParseJson(text);
  return is_plain ? text : JsonString(text);  // a double may be nan or inf, which JSON has not
}

bool ParseFromJson(const Type& type, std::string_view text, void* out) {
  const std::optional<JsonValue> json = ParseJson(text);
  if (!json) return false;
  if (json->is(Kind::kString)) return type.parse(json->text, out);
  const bool is_plain = json->is(Kind::kNumber) || json->is(Kind::kBool);
  return is_plain && type.kind != TypeKind::kString && type.parse(json->text, out);
}

void JsonWriter::Add(std::string_view name, const std::string& json) {
  text_ += text_.empty() ? "{" : ",";
  text_ += JsonString(name) + ":" + json;
}

JsonReader::JsonReader(std::string_view json) {
  const std::optional<JsonValue> object = ParseJson(json);
  good_ = object && object->is(Kind::kObject);
  if (!good_) return;
  for (const JsonValue& member : object->children) {
    if (member.key != "__type") fields_.emplace_back(member.key, PrintJson(member));
  }
}

const std::string* JsonReader::Take(std::string_view name) {
  const auto found = std::find_if(fields_.begin(), fields_.end(),
                                  [name](const auto& field) { return field.first == name; });
  if (found == fields_.end()) return nullptr;
  ++taken_;
  return &found->second;
}

bool SplitJsonArray(std::string_view json, std::vector<std::string>& elements) {
  const std::optional<JsonValue> array = ParseJson(json);
  if (!array || !array->is(Kind::kArray)) return false;
  for (const JsonValue& element : array->children) elements.push_back(PrintJson(element));
  return true;
}

}  // namespace coppice
