#include "bt_nodes/visitors/visitor.h"

#include "bt_core/base/json.h"

namespace coppice {
namespace {

template <typename Number>
bool ReadNumber(const JsonValue& object, const char* name, Number& number) {
  const JsonValue* member = object.Find(name);
  return member != nullptr && member->is(JsonValue::Kind::kNumber) &&
         ValueTraits<Number>::Parse(member->text, number);
}

bool ReadText(const JsonValue& object, const char* name, std::string& text) {
  const JsonValue* member = object.Find(name);
  if (member == nullptr || !member->is(JsonValue::Kind::kString)) return false;
  text = member->text;
  return true;
}

}  // namespace

bool ValueTraits<leaves::Visitor>::Parse(std::string_view text, leaves::Visitor& out) {
  const auto json = ParseJson(text);
  std::int64_t heard = 0, asked = 0;
  if (!json || !ReadNumber(*json, "heard", heard) || !ReadNumber(*json, "asked", asked) ||
      !ReadNumber(*json, "touches", out.touches) || !ReadNumber(*json, "request", out.request) ||
      !ReadText(*json, "place", out.place) || !ReadText(*json, "language", out.language)) {
    return false;
  }
  out.heard = TimeFromNanoseconds(heard);
  out.asked = TimeFromNanoseconds(asked);
  return true;
}

std::string ValueTraits<leaves::Visitor>::Print(const leaves::Visitor& value) {
  return "{\"heard\":" + std::to_string(ToNanoseconds(value.heard)) +
         ",\"touches\":" + std::to_string(value.touches) +
         ",\"request\":" + std::to_string(value.request) +
         ",\"asked\":" + std::to_string(ToNanoseconds(value.asked)) +
         ",\"place\":" + JsonString(value.place) + ",\"language\":" + JsonString(value.language) +
         "}";
}

}  // namespace coppice
