#include "bt_nodes/people/people_view.h"

#include <cmath>
#include <cstdio>

#include "bt_core/base/json.h"

namespace coppice::leaves {
namespace {

template <typename Number>
bool ReadNumber(const JsonValue& object, const char* name, Number& number) {
  const JsonValue* member = object.Find(name);
  return member != nullptr && member->is(JsonValue::Kind::kNumber) &&
         ValueTraits<Number>::Parse(member->text, number);
}

bool ReadPerson(const JsonValue& json, SeenPerson& person) {
  int mask = 0;
  std::int64_t id = 0;
  const bool is_whole =
      ReadNumber(json, "id", id) && ReadNumber(json, "x", person.x) &&
      ReadNumber(json, "y", person.y) && ReadNumber(json, "speed", person.speed) &&
      ReadNumber(json, "known_for", person.known_for) &&
      ReadNumber(json, "unseen_for", person.unseen_for) && ReadNumber(json, "mask", mask);
  if (!is_whole || id < 0 || id > UINT32_MAX || mask < 0 || mask > 2) return false;
  person.id = static_cast<std::uint32_t>(id);
  person.mask = static_cast<Mask>(mask);
  return true;
}

}  // namespace

double SeenPerson::distance() const { return std::hypot(x, y); }
double SeenPerson::angle() const { return std::atan2(y, x); }

}  // namespace coppice::leaves

namespace coppice {

bool ValueTraits<leaves::PeopleView>::Parse(std::string_view text, leaves::PeopleView& out) {
  const auto json = ParseJson(text);
  if (!json) return false;
  std::int64_t stamp = 0;
  const JsonValue* people = json->Find("people");
  if (!leaves::ReadNumber(*json, "stamp", stamp) || people == nullptr ||
      !people->is(JsonValue::Kind::kArray)) {
    return false;
  }
  out.stamp = TimeFromNanoseconds(stamp);
  out.people.clear();
  for (const JsonValue& row : people->children) {
    if (!leaves::ReadPerson(row, out.people.emplace_back())) return false;
  }
  return true;
}

std::string ValueTraits<leaves::PeopleView>::Print(const leaves::PeopleView& value) {
  std::string text = "{\"stamp\":" + std::to_string(ToNanoseconds(value.stamp)) + ",\"people\":[";
  for (const leaves::SeenPerson& person : value.people) {
    char row[256];
    std::snprintf(row, sizeof(row),
                  "%s{\"id\":%u,\"x\":%.3f,\"y\":%.3f,\"speed\":%.3f,\"known_for\":%.3f,"
                  "\"unseen_for\":%.3f,\"mask\":%d}",
                  text.back() == '[' ? "" : ",", person.id, person.x, person.y, person.speed,
                  person.known_for, person.unseen_for, static_cast<int>(person.mask));
    text += row;
  }
  return text + "]}";
}

}  // namespace coppice
