// A value of any registered type, as it lies on the blackboard, in a literal or in a message.
//
// Small types live inside the Value; assigning a value of the same type reuses the storage, so a
// string that does not grow is written without allocation. How a type takes part is in type.h.
#ifndef COPPICE_BT_CORE_DATA_VALUE_H_
#define COPPICE_BT_CORE_DATA_VALUE_H_

#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "bt_core/data/type.h"

namespace coppice {

class Value {
 public:
  Value() = default;
  template <class T, class = std::enable_if_t<!std::is_same_v<std::decay_t<T>, Value>>>
  explicit Value(const T& value) {
    TypeOf<T>().copy_construct(Prepare(TypeOf<T>()), &value);
  }
  Value(const Value& other) { *this = other; }
  Value(Value&& other) noexcept;
  Value& operator=(const Value& other);
  Value& operator=(Value&& other) noexcept;
  ~Value() { Reset(); }

  /// Null for an empty value.
  const Type* type() const { return type_; }
  bool has_value() const { return type_ != nullptr; }

  template <class T>
  bool Is() const {
    return type_ == &TypeOf<T>();
  }

  /// The value itself. Undefined unless Is<T>(); the compiler of trees has checked it for every
  /// port.
  template <class T>
  const T& Get() const {
    return *static_cast<const T*>(FitsInline(sizeof(T), alignof(T)) ? inline_ : heap_);
  }
  template <class T>
  T& Get() {
    return *static_cast<T*>(FitsInline(sizeof(T), alignof(T)) ? inline_ : heap_);
  }

  template <class T>
  void Set(const T& value) {
    if (type_ == &TypeOf<T>()) {
      Get<T>() = value;
    } else {
      TypeOf<T>().copy_construct(Prepare(TypeOf<T>()), &value);
    }
  }

  /// Becomes a copy of the object of that type at `from`.
  void Assign(const Type& type, const void* from);

  /// The value itself, an object of type(). Undefined for an empty value.
  const void* data() const { return is_inline() ? inline_ : heap_; }
  void* data() { return is_inline() ? inline_ : heap_; }

  /// Becomes the value that the text stands for. False leaves *this empty. A type that brings its
  /// own JSON is also read from "json:" and a JSON text.
  bool Parse(const Type& type, std::string_view text);

  /// The text that Parse reads; empty for an empty value.
  std::string Print() const { return type_ ? type_->print(data()) : std::string(); }

  /// The text of a JSON value; "null" for an empty value.
  std::string ToJson() const { return type_ ? type_->to_json(data()) : "null"; }

  /// Becomes the value that the JSON text stands for. False leaves *this empty.
  bool FromJson(const Type& type, std::string_view json);

  /// Of an enum, the number behind its enumerator. Undefined unless the type has enumerators.
  std::int64_t EnumeratorValue() const { return type_->enumerators->value_of(data()); }

  void Reset();

 private:
  static constexpr std::size_t kInlineSize = 32;
  static constexpr bool FitsInline(std::size_t size, std::size_t alignment) {
    return size <= kInlineSize && alignment <= alignof(double);
  }
  bool is_inline() const { return FitsInline(type_->size, type_->alignment); }
  void* Prepare(const Type& type);  // empties, then returns raw storage for the type

  const Type* type_ = nullptr;
  union {
    alignas(double) unsigned char inline_[kInlineSize];
    void* heap_;
  };
};

// The types that every tree can use.
#define COPPICE_DECLARE_VALUE_TRAITS(T, NAME)         \
  template <>                                         \
  struct ValueTraits<T> {                             \
    static constexpr const char* kName = NAME;        \
    static bool Parse(std::string_view text, T& out); \
    static std::string Print(const T& value);         \
  }
COPPICE_DECLARE_VALUE_TRAITS(bool, "bool");
COPPICE_DECLARE_VALUE_TRAITS(int, "int");
COPPICE_DECLARE_VALUE_TRAITS(unsigned, "unsigned");
COPPICE_DECLARE_VALUE_TRAITS(std::int64_t, "int64");
COPPICE_DECLARE_VALUE_TRAITS(std::uint64_t, "uint64");
COPPICE_DECLARE_VALUE_TRAITS(float, "float");
COPPICE_DECLARE_VALUE_TRAITS(double, "double");
COPPICE_DECLARE_VALUE_TRAITS(std::string, "string");
#undef COPPICE_DECLARE_VALUE_TRAITS

}  // namespace coppice

#endif  // COPPICE_BT_CORE_DATA_VALUE_H_
