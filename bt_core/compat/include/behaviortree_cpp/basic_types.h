// Statuses, ports and conversions between texts and values.
//
// A type takes part in ports by a specialisation of convertFromString:
//
//   namespace BT {
//   template <> inline Pose2D convertFromString(StringView text) { ... }   // throws if it is none
//   }
#pragma once

#include <chrono>
#include <functional>
#include <iostream>
#include <string>
#include <string_view>
#include <typeindex>
#include <typeinfo>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "behaviortree_cpp/contrib/expected.hpp"
#include "behaviortree_cpp/exceptions.h"
#include "behaviortree_cpp/utils/safe_any.hpp"
#include "bt_core/data/standard_types.h"

namespace BT {

enum class NodeType { UNDEFINED = 0, ACTION, CONDITION, CONTROL, DECORATOR, SUBTREE };

/// The numbers are those of coppice::Status.
enum class NodeStatus { IDLE = 0, RUNNING = 1, SUCCESS = 2, FAILURE = 3, SKIPPED = 4 };

inline bool isStatusActive(const NodeStatus& status) {
  return status != NodeStatus::IDLE && status != NodeStatus::SKIPPED;
}
inline bool isStatusCompleted(const NodeStatus& status) {
  return status == NodeStatus::SUCCESS || status == NodeStatus::FAILURE;
}

enum class PortDirection { INPUT, OUTPUT, INOUT };

using StringView = std::string_view;
using KeyValueVector = std::vector<std::pair<std::string, std::string>>;
using TimePoint = std::chrono::high_resolution_clock::time_point;
using Duration = std::chrono::high_resolution_clock::duration;

bool StartWith(StringView text, StringView prefix);
bool StartWith(StringView text, char prefix);
std::vector<StringView> splitString(const StringView& text, char delimiter);

/// The value, or why there is none.
template <class T>
using Expected = nonstd::expected<T, std::string>;
using Result = Expected<std::monostate>;
#ifdef USE_BTCPP3_OLD_NAMES
template <class T>
using Optional = nonstd::expected<T, std::string>;
#endif

/// When a key was written last, and how often.
struct Timestamp {
  uint64_t seq = 0;
  std::chrono::nanoseconds time = std::chrono::nanoseconds(0);
};

/// The type of a port that takes every value.
struct AnyTypeAllowed {};

template <class Predicate>
using enable_if = typename std::enable_if<Predicate::value>::type*;
template <class Predicate>
using enable_if_not = typename std::enable_if<!Predicate::value>::type*;

// ---- From text.

/// Of a type that JsonExporter knows. Throws RuntimeError.
Any convertFromJSON(StringView json, std::type_index type);
template <class T>
T convertFromJSON(StringView json) {
  return convertFromJSON(json, typeid(T)).cast<T>();
}

namespace internal {
[[noreturn]] void ThrowNoConversion(const std::type_info& type);
}  // namespace internal

/// To be specialised for the types of users. As it is, it reads "json:" and JSON, and throws
/// LogicError at everything else.
template <class T>
inline T convertFromString(StringView text) {
  if (StartWith(text, "json:")) return convertFromJSON<T>(text.substr(5));
  internal::ThrowNoConversion(typeid(T));
}

#define COPPICE_COMPAT_DECLARE(...) \
  template <>                       \
  __VA_ARGS__ convertFromString<__VA_ARGS__>(StringView text)
COPPICE_COMPAT_DECLARE(std::string);
COPPICE_COMPAT_DECLARE(const char*);
COPPICE_COMPAT_DECLARE(int8_t);
COPPICE_COMPAT_DECLARE(int16_t);
COPPICE_COMPAT_DECLARE(int32_t);
COPPICE_COMPAT_DECLARE(int64_t);
COPPICE_COMPAT_DECLARE(uint8_t);
COPPICE_COMPAT_DECLARE(uint16_t);
COPPICE_COMPAT_DECLARE(uint32_t);
COPPICE_COMPAT_DECLARE(uint64_t);
COPPICE_COMPAT_DECLARE(float);
COPPICE_COMPAT_DECLARE(double);
COPPICE_COMPAT_DECLARE(bool);
COPPICE_COMPAT_DECLARE(std::vector<int>);
COPPICE_COMPAT_DECLARE(std::vector<double>);
COPPICE_COMPAT_DECLARE(std::vector<bool>);
COPPICE_COMPAT_DECLARE(std::vector<std::string>);
COPPICE_COMPAT_DECLARE(NodeStatus);
COPPICE_COMPAT_DECLARE(NodeType);
COPPICE_COMPAT_DECLARE(PortDirection);
#undef COPPICE_COMPAT_DECLARE

/// False if the text does not begin with a number, or is not one as a whole where that is asked.
bool parseDouble(StringView text, double& out, bool require_full_consumption);

// ---- To text.

template <class T>
constexpr bool IsConvertibleToString() {
  return std::is_convertible_v<T, std::string> || std::is_convertible_v<T, std::string_view>;
}

/// Of a type that JsonExporter knows.
Expected<std::string> toJsonString(const Any& value);

template <class T>
std::string toStr(const T& value) {
  if constexpr (IsConvertibleToString<T>()) {
    return static_cast<std::string>(value);
  } else if constexpr (std::is_arithmetic_v<T>) {
    return std::to_string(value);
  } else {
    const Expected<std::string> json = toJsonString(Any(value));
    if (!json) throw LogicError("there is no BT::toStr<T>() for ", demangle(typeid(T)));
    return *json;
  }
}
template <>
std::string toStr<bool>(const bool& value);
template <>
std::string toStr<std::string>(const std::string& value);
template <>
std::string toStr<NodeStatus>(const NodeStatus& status);
template <>
std::string toStr<NodeType>(const NodeType& type);
template <>
std::string toStr<PortDirection>(const PortDirection& direction);
/// With the escapes of a terminal.
std::string toStr(NodeStatus status, bool colored);

std::ostream& operator<<(std::ostream& out, const NodeStatus& status);
std::ostream& operator<<(std::ostream& out, const NodeType& type);
std::ostream& operator<<(std::ostream& out, const PortDirection& direction);

// ---- Enums.

namespace internal {

using EnumNames = std::unordered_map<std::string, int>;

/// By the names that scripts know (there may be none), as a number, or as convertFromString does.
template <class T>
T EnumFromText(StringView text, [[maybe_unused]] const EnumNames* names) {
  if constexpr (!std::is_same_v<T, NodeStatus>) {
    if (names) {
      const auto found = names->find(std::string(text));
      if (found != names->end()) return static_cast<T>(found->second);
    }
    int number = 0;
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    if (parsed.ec == std::errc() && parsed.ptr == end) return static_cast<T>(number);
  }
  return convertFromString<T>(text);
}

using EnumReader = Any (*)(StringView text, const EnumNames* names);

/// Null for a type that is no enum.
template <class T>
constexpr EnumReader EnumReaderOf() {
  if constexpr (std::is_enum_v<T>) {
    return
        [](StringView text, const EnumNames* names) { return Any(EnumFromText<T>(text, names)); };
  } else {
    return nullptr;
  }
}

}  // namespace internal

// ---- Types for the engine.

namespace internal {

template <class T, class = void>
struct HasTraits : std::false_type {};
template <class T>
struct HasTraits<T, std::void_t<decltype(sizeof(coppice::ValueTraits<T>))>> : std::true_type {};

constexpr std::size_t kLongestName = 64;
struct TypeName {
  char text[kLongestName] = {};
};
template <class T>
constexpr TypeName NameOfType() {
  std::string_view pretty = __PRETTY_FUNCTION__;  // "... [with T = Pose2D]"
  const std::size_t start = pretty.find("T = ") + 4;
  TypeName name;
  for (std::size_t k = 0; k + 1 < kLongestName && start + k + 1 < pretty.size(); ++k) {
    name.text[k] = pretty[start + k];
  }
  return name;
}

std::string JsonOf(const Any& value);

template <class T>
std::int64_t EnumValue(const void* value) {
  if constexpr (std::is_enum_v<T>) {
    return static_cast<std::int64_t>(*static_cast<const T*>(value));
  } else {
    return 0;
  }
}

// A type as the functions of this header have it: for those that have no coppice::ValueTraits.
template <class T>
struct TypeHolder {
  static void Construct([[maybe_unused]] void* at) {
    if constexpr (std::is_default_constructible_v<T>) {
      new (at) T();
    } else {
      throw LogicError("a value of type ", demangle(typeid(T)), " cannot be made from nothing");
    }
  }
  static void CopyAssign(void* to, const void* from) {
    if constexpr (std::is_copy_assignable_v<T>) {
      *static_cast<T*>(to) = *static_cast<const T*>(from);
    } else {
      static_cast<T*>(to)->~T();
      new (to) T(*static_cast<const T*>(from));
    }
  }
  static bool Parse(std::string_view text, void* out) {
    try {
      const T value = convertFromString<T>(text);
      CopyAssign(out, &value);
      return true;
    } catch (const std::exception&) {
      return false;
    }
  }
  static std::string Print(const void* value) {
    if constexpr (std::is_enum_v<T>) {
      return std::to_string(EnumValue<T>(value));
    } else {
      try {
        return toStr<T>(*static_cast<const T*>(value));
      } catch (const std::exception&) {
        return {};
      }
    }
  }
  static std::string Json(const void* value) { return JsonOf(Any(*static_cast<const T*>(value))); }
  static bool FromJson(std::string_view json, void* out) {
    return Parse("json:" + std::string(json), out);
  }

  static constexpr TypeName kName = NameOfType<T>();
  static constexpr coppice::EnumeratorList kNumbers = {nullptr, 0, &EnumValue<T>};
  static constexpr coppice::Type kType = {
      kName.text,
      std::is_enum_v<T> ? coppice::TypeKind::kEnum : coppice::TypeKind::kOther,
      sizeof(T),
      alignof(T),
      &Construct,
      [](void* at, const void* from) { new (at) T(*static_cast<const T*>(from)); },
      &CopyAssign,
      [](void* at) { static_cast<T*>(at)->~T(); },
      &Parse,
      &Print,
      &Json,
      &FromJson,
      std::is_enum_v<T> ? &kNumbers : nullptr,
      true,
      &typeid(T),
  };
};

template <class T>
const coppice::Type& TypeFor() {
  if constexpr (HasTraits<T>::value) {
    return coppice::TypeOf<T>();
  } else {
    return TypeHolder<T>::kType;
  }
}

}  // namespace internal

// ---- Ports.

using StringConverter = std::function<Any(StringView)>;
using StringConvertersMap = std::unordered_map<const std::type_info*, StringConverter>;

/// Empty for a type that only the engine can read: an enum, whose names scripts know.
template <class T>
inline StringConverter GetAnyFromStringFunctor() {
  if constexpr (std::is_void_v<T> || std::is_same_v<T, AnyTypeAllowed> || std::is_enum_v<T> ||
                std::is_same_v<T, Any> || std::is_same_v<T, std::nullptr_t>) {
    return {};
  } else if constexpr (std::is_constructible_v<StringView, T>) {
    return [](StringView text) { return Any(std::string(text)); };
  } else {
    return [](StringView text) { return Any(convertFromString<T>(text)); };
  }
}

class TypeInfo {
 public:
  template <class T>
  static TypeInfo Create() {
    return TypeInfo{typeid(T), GetAnyFromStringFunctor<T>()};
  }
  TypeInfo() : TypeInfo(typeid(AnyTypeAllowed), {}) {}
  TypeInfo(std::type_index type, StringConverter converter)
      : type_(type), converter_(std::move(converter)) {}

  const std::type_index& type() const { return type_; }
  const std::string& typeName() const;
  /// Empty if there is no conversion, or the text is none of this type.
  Any parseString(const char* text) const { return parseString(std::string(text)); }
  Any parseString(const std::string& text) const;
  template <class T>
  Any parseString(const T&) const {
    return {};
  }
  /// False if the port takes every value.
  bool isStronglyTyped() const {
    return type_ != typeid(AnyTypeAllowed) && type_ != typeid(Any) && type_ != typeid(void);
  }
  const StringConverter& converter() const { return converter_; }
  /// Of an enum, which has no converter.
  internal::EnumReader enum_reader() const { return enum_reader_; }
  void set_enum_reader(internal::EnumReader reader) { enum_reader_ = reader; }

 private:
  std::type_index type_;
  StringConverter converter_;
  internal::EnumReader enum_reader_ = nullptr;
  mutable std::string name_;
};

class PortInfo : public TypeInfo {
 public:
  PortInfo(PortDirection direction = PortDirection::INOUT) : direction_(direction) {}
  PortInfo(PortDirection direction, std::type_index type, StringConverter converter)
      : TypeInfo(type, std::move(converter)), direction_(direction) {}

  PortDirection direction() const { return direction_; }
  void setDescription(StringView description) { description_ = description; }
  template <class T>
  void setDefaultValue(const T& value) {
    default_value_ = Any(value);
    try {
      default_text_ = toStr(value);
    } catch (const LogicError&) {  // it has no text
    }
  }
  const std::string& description() const { return description_; }
  const Any& defaultValue() const { return default_value_; }
  const std::string& defaultValueString() const { return default_text_; }

 private:
  PortDirection direction_;
  std::string description_;
  Any default_value_;
  std::string default_text_;
};

using PortsList = std::unordered_map<std::string, PortInfo>;

/// A letter first, and none of the characters that XML or a file system takes for its own.
bool IsAllowedPortName(StringView name);
/// name, ID, and the attributes of pre- and post-conditions.
bool IsReservedAttribute(StringView name);
/// The first character that no name may have, or 0.
char findForbiddenChar(StringView name);

namespace internal {
void CheckPortName(StringView name);
void CheckOutputDefault(StringView text);
}  // namespace internal

template <class T = AnyTypeAllowed>
std::pair<std::string, PortInfo> CreatePort(PortDirection direction, StringView name,
                                            StringView description = {}) {
  internal::CheckPortName(name);
  PortInfo info(direction, typeid(T), GetAnyFromStringFunctor<T>());
  info.set_enum_reader(internal::EnumReaderOf<T>());
  info.setDescription(description);
  return {std::string(name), std::move(info)};
}

template <class T = AnyTypeAllowed>
std::pair<std::string, PortInfo> InputPort(StringView name, StringView description = {}) {
  return CreatePort<T>(PortDirection::INPUT, name, description);
}
template <class T = AnyTypeAllowed>
std::pair<std::string, PortInfo> OutputPort(StringView name, StringView description = {}) {
  return CreatePort<T>(PortDirection::OUTPUT, name, description);
}
template <class T = AnyTypeAllowed>
std::pair<std::string, PortInfo> BidirectionalPort(StringView name, StringView description = {}) {
  return CreatePort<T>(PortDirection::INOUT, name, description);
}

namespace details {
template <class T, class DefaultT>
std::pair<std::string, PortInfo> PortWithDefault(PortDirection direction, StringView name,
                                                 const DefaultT& value, StringView description) {
  static_assert(IsConvertibleToString<DefaultT>() || std::is_convertible_v<T, DefaultT> ||
                    std::is_constructible_v<T, DefaultT>,
                "a default is a value of the port's type, or a text");
  auto port = CreatePort<T>(direction, name, description);
  if constexpr (std::is_constructible_v<T, DefaultT>) {
    port.second.setDefaultValue(T(value));
  } else if constexpr (IsConvertibleToString<DefaultT>()) {
    port.second.setDefaultValue(std::string(value));
  } else {
    port.second.setDefaultValue(value);
  }
  return port;
}
}  // namespace details

/// With a default: a value, the text of one, or a key "{key}".
template <class T = AnyTypeAllowed, class DefaultT = T>
std::pair<std::string, PortInfo> InputPort(StringView name, const DefaultT& value,
                                           StringView description) {
  return details::PortWithDefault<T, DefaultT>(PortDirection::INPUT, name, value, description);
}
template <class T = AnyTypeAllowed, class DefaultT = T>
std::pair<std::string, PortInfo> BidirectionalPort(StringView name, const DefaultT& value,
                                                   StringView description) {
  return details::PortWithDefault<T, DefaultT>(PortDirection::INOUT, name, value, description);
}
/// The default of an output is a key "{key}"; anything else throws LogicError.
template <class T = AnyTypeAllowed>
std::pair<std::string, PortInfo> OutputPort(StringView name, StringView key,
                                            StringView description) {
  internal::CheckOutputDefault(key);
  auto port = CreatePort<T>(PortDirection::OUTPUT, name, description);
  port.second.setDefaultValue(std::string(key));
  return port;
}

template <class T, class = void>
struct has_static_method_providedPorts : std::false_type {};
template <class T>
struct has_static_method_providedPorts<
    T, std::enable_if_t<std::is_same_v<decltype(T::providedPorts()), PortsList>>> : std::true_type {
};

template <class T, class = void>
struct has_static_method_metadata : std::false_type {};
template <class T>
struct has_static_method_metadata<
    T, std::enable_if_t<std::is_same_v<decltype(T::metadata()), KeyValueVector>>> : std::true_type {
};

/// Of a node class without providedPorts(): none.
template <class T>
PortsList getProvidedPorts() {
  if constexpr (has_static_method_providedPorts<T>::value) {
    return T::providedPorts();
  } else {
    return {};
  }
}

}  // namespace BT
