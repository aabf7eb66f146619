// Enums as types of ports, with names in XML and scripts. One declaration serves the literal of a
// port, the constants of scripts, the manifest and the editor's list of choices.
//
//   enum class Color { RED = 1, GREEN, BLUE };
//   COPPICE_ENUM(Color, RED, GREEN, BLUE)     // outside of any namespace
//
// Names other than those in C++ are written out:
//
//   template <> struct coppice::ValueTraits<Gear> : coppice::EnumTraits<Gear> {
//     static constexpr const char* kName = "Gear";
//     static constexpr coppice::Enumerator kEnumerators[] = {{"slow", 0}, {"fast", 1}};
//   };
//
// The text of a value is the name of an enumerator or its number; other numbers are refused.
#ifndef COPPICE_BT_CORE_DATA_ENUM_H_
#define COPPICE_BT_CORE_DATA_ENUM_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "bt_core/data/type.h"

namespace coppice {

/// The enumerator of that name or number, or null.
const Enumerator* FindEnumerator(const EnumeratorList& list, std::string_view text);
const Enumerator* FindEnumerator(const EnumeratorList& list, std::int64_t value);

/// "RED, GREEN or BLUE": for messages.
std::string Choices(const EnumeratorList& list);

/// The enumerators of an enum. A reference for as long as the program runs.
template <class E>
const EnumeratorList& EnumeratorsOf() {
  return *TypeOf<E>().enumerators;
}

template <class E>
struct EnumTraits {
  static bool Parse(std::string_view text, E& out) {
    const Enumerator* const found = FindEnumerator(EnumeratorsOf<E>(), text);
    if (found) out = static_cast<E>(found->value);
    return found;
  }
  static std::string Print(const E& value) {
    const auto number = static_cast<std::int64_t>(value);
    const Enumerator* const found = FindEnumerator(EnumeratorsOf<E>(), number);
    return found ? std::string(found->name) : std::to_string(number);
  }
};

}  // namespace coppice

/// Up to 32 enumerators.
#define COPPICE_ENUM(E, ...)                                                                     \
  template <>                                                                                    \
  struct coppice::ValueTraits<E> : coppice::EnumTraits<E> {                                      \
    static constexpr const char* kName = #E;                                                     \
    static constexpr coppice::Enumerator kEnumerators[] = {COPPICE_ENUM_PICK(                    \
        __VA_ARGS__, 32, 31, 30, 29, 28, 27, 26, 25, 24, 23, 22, 21, 20, 19, 18, 17, 16, 15, 14, \
        13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1)(E, __VA_ARGS__)};                             \
  };

// The macro for as many enumerators as there are.
// clang-format off
#define COPPICE_ENUM_PICK(a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, \
                          a17, a18, a19, a20, a21, a22, a23, a24, a25, a26, a27, a28, a29, a30,  \
                          a31, a32, count, ...) COPPICE_ENUM_##count
#define COPPICE_ENUM_1(E, name) {#name, static_cast<std::int64_t>(E::name)}
#define COPPICE_ENUM_2(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_1(E, __VA_ARGS__)
#define COPPICE_ENUM_3(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_2(E, __VA_ARGS__)
#define COPPICE_ENUM_4(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_3(E, __VA_ARGS__)
#define COPPICE_ENUM_5(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_4(E, __VA_ARGS__)
#define COPPICE_ENUM_6(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_5(E, __VA_ARGS__)
#define COPPICE_ENUM_7(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_6(E, __VA_ARGS__)
#define COPPICE_ENUM_8(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_7(E, __VA_ARGS__)
#define COPPICE_ENUM_9(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_8(E, __VA_ARGS__)
#define COPPICE_ENUM_10(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_9(E, __VA_ARGS__)
#define COPPICE_ENUM_11(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_10(E, __VA_ARGS__)
#define COPPICE_ENUM_12(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_11(E, __VA_ARGS__)
#define COPPICE_ENUM_13(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_12(E, __VA_ARGS__)
#define COPPICE_ENUM_14(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_13(E, __VA_ARGS__)
#define COPPICE_ENUM_15(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_14(E, __VA_ARGS__)
#define COPPICE_ENUM_16(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_15(E, __VA_ARGS__)
#define COPPICE_ENUM_17(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_16(E, __VA_ARGS__)
#define COPPICE_ENUM_18(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_17(E, __VA_ARGS__)
#define COPPICE_ENUM_19(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_18(E, __VA_ARGS__)
#define COPPICE_ENUM_20(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_19(E, __VA_ARGS__)
#define COPPICE_ENUM_21(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_20(E, __VA_ARGS__)
#define COPPICE_ENUM_22(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_21(E, __VA_ARGS__)
#define COPPICE_ENUM_23(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_22(E, __VA_ARGS__)
#define COPPICE_ENUM_24(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_23(E, __VA_ARGS__)
#define COPPICE_ENUM_25(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_24(E, __VA_ARGS__)
#define COPPICE_ENUM_26(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_25(E, __VA_ARGS__)
#define COPPICE_ENUM_27(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_26(E, __VA_ARGS__)
#define COPPICE_ENUM_28(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_27(E, __VA_ARGS__)
#define COPPICE_ENUM_29(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_28(E, __VA_ARGS__)
#define COPPICE_ENUM_30(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_29(E, __VA_ARGS__)
#define COPPICE_ENUM_31(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_30(E, __VA_ARGS__)
#define COPPICE_ENUM_32(E, name, ...) COPPICE_ENUM_1(E, name), COPPICE_ENUM_31(E, __VA_ARGS__)
// clang-format on

#endif  // COPPICE_BT_CORE_DATA_ENUM_H_
