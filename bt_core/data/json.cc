#include "bt_core/data/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bt_core/data/value.h"

namespace coppice {
namespace {

using Json = nlohmann::json;

// Deeper texts are refused: printing them again would take too much of the stack.
constexpr int kMaxDepth = 100;

// Discarded if the text is no JSON.
Json Read(std::string_view text) {
  bool too_deep = false;
  const auto look = [&too_deep](int depth, Json::parse_event_t, Json&) {
    too_deep = too_deep || depth > kMaxDepth;
    return !too_deep;
  };
  Json json = Json::parse(text.begin(), text.end(), look, /*allow_exceptions=*/false);
  return too_deep ? Json(Json::value_t::discarded) : json;
}

std::string Write(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string PrintAsJson(const Type& type, const void* value) {
  const std::string text = type.print(value);
  const bool is_plain = type.kind <= TypeKind::kDouble && !Read(text).is_discarded();
  return is_plain ? text : Write(text);  // a double may be nan or inf, which JSON has not
}

bool ParseFromJson(const Type& type, std::string_view text, void* out) {
  const Json json = Read(text);
  if (json.is_string()) return type.parse(json.get_ref<const std::string&>(), out);
  const bool is_plain = json.is_number() || json.is_boolean();
  return is_plain && type.kind != TypeKind::kString && type.parse(text, out);
}

void JsonWriter::Add(std::string_view name, const std::string& json) {
  text_ += text_.empty() ? "{" : ",";
  text_ += Write(std::string(name)) + ":" + json;
}

JsonReader::JsonReader(std::string_view json) {
  const Json object = Read(json);
  good_ = object.is_object();
  if (!good_) return;
  for (const auto& [name, value] : object.items()) {
    if (name != "__type") fields_.emplace_back(name, Write(value));
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
  const Json array = Read(json);
  if (!array.is_array()) return false;
  for (const Json& element : array) elements.push_back(Write(element));
  return true;
}

}  // namespace coppice
