// More types that every port can have: lists, durations, statuses.
//
//   std::vector<double>   "1;2.5;3"     elements separated by semicolons; "" is the empty list
//   std::chrono::seconds  "90s"         a number with ns, us, ms, s, min or h; "1.5s" only for
//                                       types that have fractions of a second
//   Status                "SUCCESS"
#ifndef COPPICE_BT_CORE_DATA_STANDARD_TYPES_H_
#define COPPICE_BT_CORE_DATA_STANDARD_TYPES_H_

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/status.h"
#include "bt_core/data/enum.h"
#include "bt_core/data/type.h"

namespace coppice {

#define COPPICE_DECLARE_LIST_TRAITS(T, NAME)                          \
  template <>                                                         \
  struct ValueTraits<std::vector<T>> {                                \
    static constexpr const char* kName = NAME;                        \
    static bool Parse(std::string_view text, std::vector<T>& out);    \
    static std::string Print(const std::vector<T>& value);            \
    static std::string ToJson(const std::vector<T>& value);           \
    static bool FromJson(std::string_view json, std::vector<T>& out); \
  }
COPPICE_DECLARE_LIST_TRAITS(int, "list of int");
COPPICE_DECLARE_LIST_TRAITS(double, "list of double");
COPPICE_DECLARE_LIST_TRAITS(bool, "list of bool");
COPPICE_DECLARE_LIST_TRAITS(std::string, "list of string");
#undef COPPICE_DECLARE_LIST_TRAITS

/// False if the text is no duration or has a finer part than `unit`.
bool ParseDuration(std::string_view text, std::chrono::nanoseconds unit, std::int64_t& out);

/// With the largest unit that needs no fraction.
std::string PrintDuration(std::chrono::nanoseconds duration);

template <class D>
struct DurationTraits {
  static bool Parse(std::string_view text, D& out) {
    std::int64_t count = 0;
    if (!ParseDuration(text, D(1), count)) return false;
    out = D(count);
    return true;
  }
  static std::string Print(const D& value) { return PrintDuration(value); }
};
template <>
struct ValueTraits<std::chrono::nanoseconds> : DurationTraits<std::chrono::nanoseconds> {
  static constexpr const char* kName = "duration";
};
template <>
struct ValueTraits<std::chrono::milliseconds> : DurationTraits<std::chrono::milliseconds> {
  static constexpr const char* kName = "duration in ms";
};
template <>
struct ValueTraits<std::chrono::seconds> : DurationTraits<std::chrono::seconds> {
  static constexpr const char* kName = "duration in s";
};

template <>
struct ValueTraits<Status> : EnumTraits<Status> {
  static constexpr const char* kName = "Status";
  static constexpr Enumerator kEnumerators[] = {
      {"IDLE", 0}, {"RUNNING", 1}, {"SUCCESS", 2}, {"FAILURE", 3}, {"SKIPPED", 4}};
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_DATA_STANDARD_TYPES_H_
