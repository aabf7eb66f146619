#include "bt_core/data/standard_types.h"

#include <cmath>
#include <iterator>

#include "bt_core/data/json.h"
#include "bt_core/data/value.h"

namespace coppice {
namespace {

struct Unit {
  std::string_view name;
  std::int64_t nanoseconds;
};
constexpr Unit kUnits[] = {{"h", 3'600'000'000'000}, {"min", 60'000'000'000}, {"s", 1'000'000'000},
                           {"ms", 1'000'000},        {"us", 1'000},           {"ns", 1}};

const Unit* FindUnit(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return nullptr;
  const std::string_view name = text.substr(first, text.find_last_not_of(' ') + 1 - first);
  for (const Unit& unit : kUnits) {
    if (unit.name == name) return &unit;
  }
  return nullptr;
}

// Whole numbers exactly.
bool ReadNumber(std::string_view text, long double& number) {
  std::int64_t whole = 0;
  double real = 0;
  const bool is_whole = ValueTraits<std::int64_t>::Parse(text, whole);
  if (!is_whole && !ValueTraits<double>::Parse(text, real)) return false;
  number = is_whole ? static_cast<long double>(whole) : real;
  return true;
}

template <class T>
bool ParseList(std::string_view text, std::vector<T>& out) {
  out.clear();
  while (!text.empty()) {
    const std::size_t end = text.find(';');
    T element{};
    if (!ValueTraits<T>::Parse(text.substr(0, end), element)) return false;
    out.push_back(element);
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
    if (text.empty()) return false;  // an element is missing
  }
  return true;
}

template <class T>
std::string PrintList(const std::vector<T>& list) {
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0) text += ';';
    text += ValueTraits<T>::Print(list[i]);
  }
  return text;
}

template <class T>
std::string ListToJson(const std::vector<T>& list) {
  std::string json = "[";
  for (const T& element : list) {
    if (json.size() > 1) json += ',';
    json += TypeOf<T>().to_json(&element);
  }
  return json + "]";
}

template <class T>
bool ListFromJson(std::string_view json, std::vector<T>& out) {
  std::vector<std::string> elements;
  if (!SplitJsonArray(json, elements)) return false;
  out.clear();
  for (const std::string& text : elements) {
    T element{};
    if (!TypeOf<T>().from_json(text, &element)) return false;
    out.push_back(element);
  }
  return true;
}

}  // namespace

#define COPPICE_DEFINE_LIST_TRAITS(T)                                                      \
  bool ValueTraits<std::vector<T>>::Parse(std::string_view text, std::vector<T>& out) {    \
    return ParseList(text, out);                                                           \
  }                                                                                        \
  std::string ValueTraits<std::vector<T>>::Print(const std::vector<T>& value) {            \
    return PrintList(value);                                                               \
  }                                                                                        \
  std::string ValueTraits<std::vector<T>>::ToJson(const std::vector<T>& value) {           \
    return ListToJson(value);                                                              \
  }                                                                                        \
  bool ValueTraits<std::vector<T>>::FromJson(std::string_view json, std::vector<T>& out) { \
    return ListFromJson(json, out);                                                        \
  }
COPPICE_DEFINE_LIST_TRAITS(int)
COPPICE_DEFINE_LIST_TRAITS(double)
COPPICE_DEFINE_LIST_TRAITS(bool)
COPPICE_DEFINE_LIST_TRAITS(std::string)
#undef COPPICE_DEFINE_LIST_TRAITS

bool ParseDuration(std::string_view text, std::chrono::nanoseconds unit, std::int64_t& out) {
  const std::size_t number_end = text.find_last_of("0123456789.") + 1;
  const Unit* const given = FindUnit(text.substr(number_end));
  long double number = 0;
  if (!given || !ReadNumber(text.substr(0, number_end), number)) return false;
  const long double count = std::round(number * given->nanoseconds) / unit.count();
  const bool fits = count >= -0x1p63L && count < 0x1p63L;
  if (!fits || std::trunc(count) != count) return false;
  out = static_cast<std::int64_t>(count);
  return true;
}

std::string PrintDuration(std::chrono::nanoseconds duration) {
  for (const Unit& unit : kUnits) {
    if (duration.count() % unit.nanoseconds != 0) continue;
    if (duration.count() == 0 && unit.name != "s") continue;
    return std::to_string(duration.count() / unit.nanoseconds) + std::string(unit.name);
  }
  return {};
}

}  // namespace coppice
