// A value of any type that can be converted safely: numbers into each other if nothing is lost,
// texts into numbers, everything into what it is.
//
// It wraps coppice::Value, which is what lies on the blackboard.
#pragma once

#include <charconv>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeindex>
#include <utility>

#include "behaviortree_cpp/contrib/expected.hpp"
#include "behaviortree_cpp/utils/demangle_util.h"
#include "behaviortree_cpp/utils/polymorphic_cast_registry.hpp"
#include "behaviortree_cpp/utils/strcat.hpp"
#include "bt_core/data/value.h"

namespace BT {

template <class T>
struct is_shared_ptr : std::false_type {};
template <class T>
struct is_shared_ptr<std::shared_ptr<T>> : std::true_type {};

class Any;

namespace internal {

// What a T is kept as: the engine computes with five kinds of numbers and one kind of text.
template <class T, class = void>
struct Kept {
  using Type = T;
};
template <class T>
struct Kept<T, std::enable_if_t<std::is_integral_v<T> && !std::is_same_v<T, bool>>> {
  using Small = std::conditional_t<(sizeof(T) < sizeof(int)), int, T>;
  using Signed = std::conditional_t<sizeof(Small) == 8, std::int64_t, int>;
  using Unsigned = std::conditional_t<sizeof(Small) == 8, std::uint64_t, unsigned>;
  using Type = std::conditional_t<std::is_signed_v<Small>, Signed, Unsigned>;
};
template <>
struct Kept<long double> {
  using Type = double;
};
template <class T>
struct Kept<T, std::enable_if_t<std::is_convertible_v<T, std::string_view>>> {
  using Type = std::string;
};
template <class T>
using KeptAs = typename Kept<std::decay_t<T>>::Type;

/// The engine's description of a C++ type; basic_types.h.
template <class T>
const coppice::Type& TypeFor();

/// A number of one of three kinds.
struct Number {
  enum class Kind : std::uint8_t { kNone, kSigned, kUnsigned, kReal };
  Kind kind = Kind::kNone;
  std::int64_t as_signed = 0;
  std::uint64_t as_unsigned = 0;
  double as_real = 0;
};

/// Kind::kNone if it is no number, truth value or enumerator.
Number NumberOf(const coppice::Value& value);
bool IsText(const coppice::Value& value);

template <class From, class To>
bool Holds(From from, To& to) {
  if constexpr (std::is_same_v<To, bool>) {
    to = from != From(0);
    return from == From(0) || from == From(1);
  } else if constexpr (std::is_floating_point_v<To>) {
    to = static_cast<To>(from);
    if constexpr (std::is_integral_v<From>) return static_cast<From>(to) == from;
    return true;
  } else if constexpr (std::is_floating_point_v<From>) {
    const From highest = static_cast<From>(std::numeric_limits<To>::max());
    const bool rounds_up = std::numeric_limits<To>::digits > std::numeric_limits<From>::digits;
    if (!(from >= static_cast<From>(std::numeric_limits<To>::lowest()))) return false;
    if (rounds_up ? from >= highest : from > highest) return false;
    to = static_cast<To>(from);
    return static_cast<From>(to) == from;
  } else {
    to = static_cast<To>(from);
    return static_cast<From>(to) == from && (to < To(0)) == (from < From(0));
  }
}

/// False if the number does not fit or would lose something.
template <class T>
bool Fits(const Number& number, T& out) {
  switch (number.kind) {
    case Number::Kind::kSigned:
      return Holds(number.as_signed, out);
    case Number::Kind::kUnsigned:
      return Holds(number.as_unsigned, out);
    case Number::Kind::kReal:
      return Holds(number.as_real, out);
    case Number::Kind::kNone:
      break;
  }
  return false;
}

/// The object in a value if it is a T, also one whose coppice::Type another library has made; else
/// null.
template <class T>
const T* As(const coppice::Value& value) {
  if (value.type() == &TypeFor<T>()) return static_cast<const T*>(value.data());
  if (!value.has_value() || *value.type()->info != typeid(T)) return nullptr;
  return static_cast<const T*>(value.data());
}
template <class T>
T* As(coppice::Value& value) {
  return const_cast<T*>(As<T>(std::as_const(value)));
}

std::string TextOf(const coppice::Value& value);
std::string CannotConvert(const coppice::Value& value, const std::type_info& to);
std::string LosesPrecision(const coppice::Value& value, const std::type_info& to);

/// The value as a T, or why it is none.
template <class T>
nonstd::expected<T, std::string> Convert(const coppice::Value& value) {
  if (const auto* same = As<KeptAs<T>>(value)) {
    if constexpr (std::is_same_v<KeptAs<T>, T>) return *same;
  }
  if constexpr (std::is_same_v<T, std::string>) {
    if (NumberOf(value).kind != Number::Kind::kNone) return TextOf(value);
  } else if constexpr (std::is_enum_v<T>) {
    std::int64_t number = 0;
    if (Fits(NumberOf(value), number)) return static_cast<T>(number);
    if (const auto* text = As<std::string>(value)) {
      const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), number);
      if (error == std::errc()) return static_cast<T>(number);
    }
  } else if constexpr (std::is_arithmetic_v<T>) {
    const Number number = NumberOf(value);
    T out{};
    if (Fits(number, out)) return out;
    if (number.kind != Number::Kind::kNone) {
      return nonstd::make_unexpected(LosesPrecision(value, typeid(T)));
    }
    if constexpr (!std::is_same_v<T, bool>) {
      const auto* text = As<std::string>(value);
      if (text && std::from_chars(text->data(), text->data() + text->size(), out).ec == std::errc())
        return out;
    }
  }
  return nonstd::make_unexpected(CannotConvert(value, typeid(T)));
}

/// Another kind of number, if nothing is lost. An enumerator is no number here.
template <class T>
[[gnu::noinline]] bool ReadNumber(const coppice::Value& value, T& out) {
  return value.has_value() && !value.type()->enumerators && Fits(NumberOf(value), out);
}

/// What needs no text and no error; false: Convert() says more.
template <class T>
bool ReadAsIs(const coppice::Value& value, T& out) {
  if constexpr (std::is_same_v<KeptAs<T>, T>) {
    if (value.type() == &TypeFor<T>()) {
      out = value.template Get<T>();
      return true;
    }
  }
  if constexpr (std::is_arithmetic_v<T>) {
    return ReadNumber(value, out);
  } else {
    return false;
  }
}

}  // namespace internal

class Any {
 public:
  Any() = default;
  Any(const Any&) = default;
  Any(Any&&) noexcept = default;
  Any& operator=(const Any&) = default;
  Any& operator=(Any&&) noexcept = default;
  ~Any() = default;

  template <class T, class = std::enable_if_t<!std::is_same_v<std::decay_t<T>, Any> &&
                                              !std::is_same_v<std::decay_t<T>, std::type_index>>>
  explicit Any(const T& value) {
    Set(value);
  }
  /// Empty; what it will hold is not kept.
  Any(const std::type_index&) {}

  bool empty() const noexcept { return !value_.has_value(); }
  bool isNumber() const { return internal::NumberOf(value_).kind != internal::Number::Kind::kNone; }
  bool isIntegral() const {
    return isNumber() && internal::NumberOf(value_).kind != internal::Number::Kind::kReal;
  }
  bool isString() const { return internal::IsText(value_); }
  template <class T>
  bool isType() const {
    return type() == std::type_index(typeid(T));
  }

  /// Of the value; typeid(nullptr) if there is none.
  std::type_index type() const noexcept {
    return empty() ? std::type_index(typeid(nullptr)) : std::type_index(*value_.type()->info);
  }
  /// int64_t, uint64_t or double for a number.
  const std::type_info& castedType() const noexcept;

  /// Throws std::runtime_error if there is no such conversion or it would lose something.
  template <class T>
  T cast() const {
    auto converted = tryCast<T>();
    if (!converted) throw std::runtime_error(converted.error());
    return *std::move(converted);
  }
  template <class T>
  nonstd::expected<T, std::string> tryCast() const {
    if (empty()) throw std::runtime_error("Any::cast failed because it is empty");
    return internal::Convert<T>(value_);
  }
  template <class T>
  nonstd::expected<T, std::string> tryCastWithRegistry(
      const PolymorphicCastRegistry& registry) const;

  /// The value itself, to be changed in place; null if it is another type. Numbers become the
  /// castedType() if that is asked for.
  template <class T>
  T* castPtr() {
    if constexpr (std::is_same_v<T, std::int64_t> || std::is_same_v<T, std::uint64_t> ||
                  std::is_same_v<T, double>) {
      if (castedType() == typeid(T) && !internal::As<T>(value_)) Set(cast<T>());
    }
    return empty() ? nullptr : internal::As<T>(value_);
  }

  /// Overwrites `destination`, which keeps the kind of value that it has. Throws
  /// std::runtime_error if it cannot.
  void copyInto(Any& destination) const;

  /// What lies on the blackboard.
  const coppice::Value& value() const { return value_; }
  coppice::Value& value() { return value_; }

 private:
  template <class T>
  void Set(const T& value) {
    using Stored = internal::KeptAs<T>;
    if constexpr (std::is_same_v<Stored, T>) {
      value_.Assign(internal::TypeFor<T>(), &value);
    } else {
      const Stored stored(value);
      value_.Assign(internal::TypeFor<Stored>(), &stored);
    }
  }

  coppice::Value value_;
};

template <class T>
nonstd::expected<T, std::string> Any::tryCastWithRegistry(
    const PolymorphicCastRegistry& registry) const {
  static_assert(is_shared_ptr<T>::value, "only pointers are cast between classes");
  T out;
  if (!empty() && registry.Cast(value_.data(), type(), &out, typeid(T))) return out;
  return nonstd::make_unexpected(internal::CannotConvert(value_, typeid(T)));
}

}  // namespace BT
