// What an operator of a script works on: a truth value, a number, a text, or a value of another
// type, by reference.
//
// Whole numbers stay whole under + - * % as long as they fit in 64 bits and become doubles when
// they do not; `/` is always a division of doubles. Numbers compare as the numbers that they are,
// without rounding.
#ifndef COPPICE_BT_CORE_SCRIPT_OPERAND_H_
#define COPPICE_BT_CORE_SCRIPT_OPERAND_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "bt_core/data/value.h"

namespace coppice::script {

/// Trivial on purpose: an array of them costs nothing to make.
struct Operand {
  enum class Kind : std::uint8_t { kBool, kInteger, kDouble, kText, kOther };

  static Operand Bool(bool value) {
    Operand operand;
    operand.kind = Kind::kBool;
    operand.truth = value;
    return operand;
  }
  static Operand Integer(std::int64_t value) {
    Operand operand;
    operand.kind = Kind::kInteger;
    operand.integer = value;
    return operand;
  }
  static Operand Double(double value) {
    Operand operand;
    operand.kind = Kind::kDouble;
    operand.number = value;
    return operand;
  }
  /// The text must live as long as the operand.
  static Operand Text(std::string_view text) {
    Operand operand;
    operand.kind = Kind::kText;
    operand.size = static_cast<std::uint32_t>(text.size());
    operand.characters = text.data();
    return operand;
  }
  /// The value must live as long as the operand.
  static Operand Other(const Value& value) {
    Operand operand;
    operand.kind = Kind::kOther;
    operand.other = &value;
    return operand;
  }

  std::string_view text() const { return {characters, size}; }

  Kind kind;
  std::uint32_t size;  ///< of a text
  union {
    bool truth;
    std::int64_t integer;
    double number;
    const char* characters;
    const Value* other;
  };
};

/// An operator does not take its operands; the message says what is wrong, but not where.
struct Failure {
  std::string message;
};

/// What a slot holds. The slot must not be empty.
Operand OperandOf(const Value& value);

bool IsEnumerator(const Operand& operand);

/// "true", "2.5", "'text'", "Pose2D 1;2;3": for messages.
std::string Describe(const Operand& operand);

/// Also of a text that reads as a truth value or a number. Throws Failure.
bool IsTrue(const Operand& operand);

/// A truth value, a number or an enumerator as a number of kind kInteger or kDouble. Throws
/// Failure.
Operand NumberOf(const Operand& operand);
inline Operand ToNumber(const Operand& operand) {
  const bool is_number =
      operand.kind == Operand::Kind::kInteger || operand.kind == Operand::Kind::kDouble;
  return is_number ? operand : NumberOf(operand);
}

/// A number without fraction. Throws Failure.
std::int64_t ToInteger(const Operand& operand);

Operand Negate(const Operand& a);
Operand Complement(const Operand& a);
Operand Absolute(const Operand& a);
Operand Add(const Operand& a, const Operand& b);  // of numbers
Operand Subtract(const Operand& a, const Operand& b);
Operand Multiply(const Operand& a, const Operand& b);
Operand Divide(const Operand& a, const Operand& b);
Operand Remainder(const Operand& a, const Operand& b);  // with the sign of a
Operand BitAnd(const Operand& a, const Operand& b);
Operand BitOr(const Operand& a, const Operand& b);
Operand BitXor(const Operand& a, const Operand& b);
Operand Min(const Operand& a, const Operand& b);
Operand Max(const Operand& a, const Operand& b);
Operand Clamp(const Operand& a, const Operand& low, const Operand& high);

}  // namespace coppice::script

#endif  // COPPICE_BT_CORE_SCRIPT_OPERAND_H_
