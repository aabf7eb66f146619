// What the engine knows about a C++ type that a port, a key or a script uses: how to make, copy,
// read and print a value of it.
//
// A type takes part by one conversion pair, ValueTraits<T>: its name, text -> T, T -> text.
//
//   template <> struct coppice::ValueTraits<Pose2D> {
//     static constexpr const char* kName = "Pose2D";
//     static bool Parse(std::string_view text, Pose2D& out);   // false: not a Pose2D
//     static std::string Print(const Pose2D& value);
//   };
//
// Enums get theirs from bt_core/data/enum.h, structs that are read as JSON from
// bt_core/data/json.h. Two more members are used if they are there:
//
//     static std::string ToJson(const Pose2D& value);                // the text of a JSON value
//     static bool FromJson(std::string_view json, Pose2D& out);
//
// Without them, numbers and truth values are themselves in JSON, and everything else is the string
// that Print gives.
#ifndef COPPICE_BT_CORE_DATA_TYPE_H_
#define COPPICE_BT_CORE_DATA_TYPE_H_

#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeinfo>
#include <utility>

namespace coppice {

template <class T>
struct ValueTraits;

/// The types that scripts compute with; every other type is kOther.
enum class TypeKind : std::uint8_t {
  kBool,
  kInt,
  kUnsigned,
  kInt64,
  kUint64,
  kFloat,
  kDouble,
  kString,
  kEnum,
  kOther
};

/// A name for a number.
struct Enumerator {
  std::string_view name;
  std::int64_t value;
};

/// The values of an enum, in the order of its declaration.
struct EnumeratorList {
  const Enumerator* first;
  std::size_t count;
  std::int64_t (*value_of)(const void* enumeration);

  const Enumerator* begin() const { return first; }
  const Enumerator* end() const { return first + count; }
};

/// There is one Type per C++ type; compare addresses.
struct Type {
  const char* name;
  TypeKind kind;
  std::size_t size;
  std::size_t alignment;
  void (*construct)(void* at);
  void (*copy_construct)(void* at, const void* from);
  void (*copy_assign)(void* to, const void* from);
  void (*destroy)(void* at);
  bool (*parse)(std::string_view text, void* out);
  std::string (*print)(const void* value);
  std::string (*to_json)(const void* value);
  bool (*from_json)(std::string_view json, void* out);
  const EnumeratorList* enumerators;  ///< null if it is no enum
  bool has_json_form;                 ///< it brings its own FromJson
  const std::type_info* info;         ///< of the C++ type: the same for two Types of one C++ type
};

/// JSON of a type that brings no conversion of its own; see json.h.
std::string PrintAsJson(const Type& type, const void* value);
bool ParseFromJson(const Type& type, std::string_view json, void* out);

template <class T>
const Type& TypeOf();

namespace type_details {

template <class T, class = void>
struct HasEnumerators : std::false_type {};
template <class T>
struct HasEnumerators<T, std::void_t<decltype(ValueTraits<T>::kEnumerators)>> : std::true_type {};

template <class T, class = void>
struct HasToJson : std::false_type {};
template <class T>
struct HasToJson<T, std::void_t<decltype(ValueTraits<T>::ToJson(std::declval<const T&>()))>>
    : std::true_type {};

template <class T, class = void>
struct HasFromJson : std::false_type {};
template <class T>
struct HasFromJson<
    T, std::void_t<decltype(ValueTraits<T>::FromJson(std::string_view(), std::declval<T&>()))>>
    : std::true_type {};

template <class T>
constexpr TypeKind KindOf() {
  if (std::is_same_v<T, bool>) return TypeKind::kBool;
  if (std::is_same_v<T, int>) return TypeKind::kInt;
  if (std::is_same_v<T, unsigned>) return TypeKind::kUnsigned;
  if (std::is_same_v<T, std::int64_t>) return TypeKind::kInt64;
  if (std::is_same_v<T, std::uint64_t>) return TypeKind::kUint64;
  if (std::is_same_v<T, float>) return TypeKind::kFloat;
  if (std::is_same_v<T, double>) return TypeKind::kDouble;
  if (std::is_same_v<T, std::string>) return TypeKind::kString;
  return HasEnumerators<T>::value ? TypeKind::kEnum : TypeKind::kOther;
}

template <class T>
struct EnumeratorHolder {
  static constexpr EnumeratorList kList = {
      ValueTraits<T>::kEnumerators, std::size(ValueTraits<T>::kEnumerators),
      [](const void* at) { return static_cast<std::int64_t>(*static_cast<const T*>(at)); }};
};

template <class T>
constexpr const EnumeratorList* Enumerators() {
  if constexpr (HasEnumerators<T>::value) {
    return &EnumeratorHolder<T>::kList;
  } else {
    return nullptr;
  }
}

template <class T>
std::string ToJson(const void* value) {
  if constexpr (HasToJson<T>::value) {
    return ValueTraits<T>::ToJson(*static_cast<const T*>(value));
  } else {
    return PrintAsJson(TypeOf<T>(), value);
  }
}

template <class T>
bool FromJson(std::string_view json, void* out) {
  if constexpr (HasFromJson<T>::value) {
    return ValueTraits<T>::FromJson(json, *static_cast<T*>(out));
  } else {
    return ParseFromJson(TypeOf<T>(), json, out);
  }
}

// A constant, so that asking for its address costs nothing.
template <class T>
struct Holder {
  static constexpr Type kType = {
      ValueTraits<T>::kName,
      KindOf<T>(),
      sizeof(T),
      alignof(T),
      [](void* at) { new (at) T(); },
      [](void* at, const void* from) { new (at) T(*static_cast<const T*>(from)); },
      [](void* to, const void* from) { *static_cast<T*>(to) = *static_cast<const T*>(from); },
      [](void* at) { static_cast<T*>(at)->~T(); },
      [](std::string_view text, void* out) {
        return ValueTraits<T>::Parse(text, *static_cast<T*>(out));
      },
      [](const void* value) { return ValueTraits<T>::Print(*static_cast<const T*>(value)); },
      &ToJson<T>,
      &FromJson<T>,
      Enumerators<T>(),
      HasFromJson<T>::value,
      &typeid(T),
  };
};

}  // namespace type_details

template <class T>
const Type& TypeOf() {
  return type_details::Holder<T>::kType;
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_DATA_TYPE_H_
