// A value of any registered type, as it lies on the blackboard, in a literal or in a message.
//
// A type takes part by one conversion pair, ValueTraits<T>: its name, text -> T, T -> text. Small
// types live inside the Value; assigning a value of the same type reuses the storage, so a string
// that does not grow is written without allocation.
//
//   template <> struct coppice::ValueTraits<Pose2D> {
//     static constexpr const char* kName = "Pose2D";
//     static bool Parse(std::string_view text, Pose2D& out);   // false: not a Pose2D
//     static std::string Print(const Pose2D& value);
//   };
#ifndef COPPICE_BT_CORE_DATA_VALUE_H_
#define COPPICE_BT_CORE_DATA_VALUE_H_

#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace coppice {

template <class T>
struct ValueTraits;  // specialised below and by the user

/// The types that scripts compute with; every other type is kOther.
enum class TypeKind : std::uint8_t {
  kBool,
  kInt,
  kUnsigned,
  kInt64,
  kUint64,
  kDouble,
  kString,
  kOther
};

template <class T>
constexpr TypeKind KindOf() {
  if (std::is_same_v<T, bool>) return TypeKind::kBool;
  if (std::is_same_v<T, int>) return TypeKind::kInt;
  if (std::is_same_v<T, unsigned>) return TypeKind::kUnsigned;
  if (std::is_same_v<T, std::int64_t>) return TypeKind::kInt64;
  if (std::is_same_v<T, std::uint64_t>) return TypeKind::kUint64;
  if (std::is_same_v<T, double>) return TypeKind::kDouble;
  if (std::is_same_v<T, std::string>) return TypeKind::kString;
  return TypeKind::kOther;
}

/// What the engine knows about a C++ type. There is one Type per C++ type; compare addresses.
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
};

template <class T>
const Type& TypeOf() {
  static const Type type = {
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
  };
  return type;
}

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

  /// Becomes the value that the text stands for. False leaves *this empty.
  bool Parse(const Type& type, std::string_view text);

  /// The text that Parse reads; empty for an empty value.
  std::string Print() const { return type_ ? type_->print(data()) : std::string(); }

  void Reset();

 private:
  static constexpr std::size_t kInlineSize = 32;
  static constexpr bool FitsInline(std::size_t size, std::size_t alignment) {
    return size <= kInlineSize && alignment <= alignof(double);
  }
  bool is_inline() const { return FitsInline(type_->size, type_->alignment); }
  const void* data() const { return is_inline() ? inline_ : heap_; }
  void* data() { return is_inline() ? inline_ : heap_; }
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
COPPICE_DECLARE_VALUE_TRAITS(double, "double");
COPPICE_DECLARE_VALUE_TRAITS(std::string, "string");
#undef COPPICE_DECLARE_VALUE_TRAITS

}  // namespace coppice

#endif  // COPPICE_BT_CORE_DATA_VALUE_H_
