#include "bt_core/script/operand.h"

#include <cmath>
#include <limits>
#include <utility>

#include "bt_core/script/relation.h"

namespace coppice::script {
namespace {

using Kind = Operand::Kind;

constexpr double kTwoTo63 = 9223372036854775808.0;

std::string Quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

double AsDouble(const Operand& number) {
  return number.kind == Kind::kInteger ? static_cast<double>(number.integer) : number.number;
}

// `exact` computes in 64 bits and tells whether the result did not fit.
template <class Exact, class Rounded>
Operand Compute(const Operand& a, const Operand& b, Exact exact, Rounded rounded) {
  const Operand x = ToNumber(a);
  const Operand y = ToNumber(b);
  std::int64_t result = 0;
  const bool whole = x.kind == Kind::kInteger && y.kind == Kind::kInteger;
  if (whole && !exact(x.integer, y.integer, &result)) return Operand::Integer(result);
  return Operand::Double(rounded(AsDouble(x), AsDouble(y)));
}

}  // namespace

Operand OperandOf(const Value& value) {
  switch (value.type()->kind) {
    case TypeKind::kBool:
      return Operand::Bool(value.Get<bool>());
    case TypeKind::kInt:
      return Operand::Integer(value.Get<int>());
    case TypeKind::kUnsigned:
      return Operand::Integer(value.Get<unsigned>());
    case TypeKind::kInt64:
      return Operand::Integer(value.Get<std::int64_t>());
    case TypeKind::kUint64: {
      const std::uint64_t number = value.Get<std::uint64_t>();
      return number >> 63 ? Operand::Double(static_cast<double>(number))
                          : Operand::Integer(static_cast<std::int64_t>(number));
    }
    case TypeKind::kFloat:
      return Operand::Double(value.Get<float>());
    case TypeKind::kDouble:
      return Operand::Double(value.Get<double>());
    case TypeKind::kString:
      return Operand::Text(value.Get<std::string>());
    case TypeKind::kEnum:
    case TypeKind::kOther:
      break;
  }
  return Operand::Other(value);
}

bool IsEnumerator(const Operand& operand) {
  return operand.kind == Kind::kOther && operand.other->type()->kind == TypeKind::kEnum;
}

std::string Describe(const Operand& operand) {
  switch (operand.kind) {
    case Kind::kBool:
      return operand.truth ? "true" : "false";
    case Kind::kInteger:
      return std::to_string(operand.integer);
    case Kind::kDouble:
      return ValueTraits<double>::Print(operand.number);
    case Kind::kText:
      return Quoted(operand.text());
    case Kind::kOther:
      break;
  }
  return std::string(operand.other->type()->name) + " " + Quoted(operand.other->Print());
}

bool IsTrue(const Operand& operand) {
  if (operand.kind == Kind::kBool) return operand.truth;
  if (operand.kind == Kind::kText) {
    bool truth = false;
    if (ValueTraits<bool>::Parse(operand.text(), truth)) return truth;
    double number = 0;
    if (ValueTraits<double>::Parse(operand.text(), number)) return number != 0;
    throw Failure{Describe(operand) + " is neither true nor false"};
  }
  const Operand number = ToNumber(operand);
  return number.kind == Kind::kInteger ? number.integer != 0 : number.number != 0;
}

Operand NumberOf(const Operand& operand) {
  if (operand.kind == Kind::kBool) return Operand::Integer(operand.truth ? 1 : 0);
  if (IsEnumerator(operand)) return Operand::Integer(operand.other->EnumeratorValue());
  throw Failure{Describe(operand) + " is not a number"};
}

std::int64_t ToInteger(const Operand& operand) {
  const Operand number = ToNumber(operand);
  if (number.kind == Kind::kInteger) return number.integer;
  const double value = number.number;
  if (value >= -kTwoTo63 && value < kTwoTo63 && std::trunc(value) == value) {
    return static_cast<std::int64_t>(value);
  }
  throw Failure{Describe(operand) + " is not a whole number"};
}

Operand Negate(const Operand& a) {
  const Operand number = ToNumber(a);
  if (number.kind == Kind::kDouble) return Operand::Double(-number.number);
  return Subtract(Operand::Integer(0), number);
}

Operand Complement(const Operand& a) { return Operand::Integer(~ToInteger(a)); }

Operand Absolute(const Operand& a) {
  const Operand number = ToNumber(a);
  if (number.kind == Kind::kDouble) return Operand::Double(std::abs(number.number));
  return number.integer < 0 ? Negate(number) : number;
}

Operand Add(const Operand& a, const Operand& b) {
  return Compute(
      a, b, [](auto x, auto y, auto* sum) { return __builtin_add_overflow(x, y, sum); },
      [](double x, double y) { return x + y; });
}

Operand Subtract(const Operand& a, const Operand& b) {
  return Compute(
      a, b, [](auto x, auto y, auto* rest) { return __builtin_sub_overflow(x, y, rest); },
      [](double x, double y) { return x - y; });
}

Operand Multiply(const Operand& a, const Operand& b) {
  return Compute(
      a, b, [](auto x, auto y, auto* product) { return __builtin_mul_overflow(x, y, product); },
      [](double x, double y) { return x * y; });
}

Operand Divide(const Operand& a, const Operand& b) {
  return Operand::Double(AsDouble(ToNumber(a)) / AsDouble(ToNumber(b)));
}

Operand Remainder(const Operand& a, const Operand& b) {
  if (!IsTrue(ToNumber(b))) throw Failure{Describe(a) + " % 0 has no value"};
  return Compute(
      a, b,
      [](std::int64_t x, std::int64_t y, std::int64_t* rest) {
        *rest = y == -1 ? 0 : x % y;  // the smallest integer % -1 would trap
        return false;
      },
      [](double x, double y) { return std::fmod(x, y); });
}

Operand BitAnd(const Operand& a, const Operand& b) {
  return Operand::Integer(ToInteger(a) & ToInteger(b));
}
Operand BitOr(const Operand& a, const Operand& b) {
  return Operand::Integer(ToInteger(a) | ToInteger(b));
}
Operand BitXor(const Operand& a, const Operand& b) {
  return Operand::Integer(ToInteger(a) ^ ToInteger(b));
}

Operand Min(const Operand& a, const Operand& b) {
  const Operand x = ToNumber(a);
  const Operand y = ToNumber(b);
  return Holds(Relation::kLess, y, x) ? y : x;
}
Operand Max(const Operand& a, const Operand& b) {
  const Operand x = ToNumber(a);
  const Operand y = ToNumber(b);
  return Holds(Relation::kGreater, y, x) ? y : x;
}
Operand Clamp(const Operand& a, const Operand& low, const Operand& high) {
  if (Holds(Relation::kGreater, ToNumber(low), ToNumber(high))) {
    throw Failure{"clamp: the lower limit " + Describe(low) + " is above the upper limit " +
                  Describe(high)};
  }
  return Min(Max(a, low), high);
}

}  // namespace coppice::script
