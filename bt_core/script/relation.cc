#include "bt_core/script/relation.h"

#include <cmath>
#include <string>

namespace coppice::script {
namespace {

using Kind = Operand::Kind;

// The last two are equality without order.
enum class Order : std::uint8_t { kLess, kEqual, kGreater, kUnordered, kSame, kDifferent };

template <class T>
Order OrderOf(const T& a, const T& b) {
  if (a < b) return Order::kLess;
  if (a > b) return Order::kGreater;
  return a == b ? Order::kEqual : Order::kUnordered;
}

Order Reversed(Order order) {
  if (order == Order::kLess) return Order::kGreater;
  return order == Order::kGreater ? Order::kLess : order;
}

// Without rounding the integer to a double.
Order OrderOf(std::int64_t a, double b) {
  constexpr double kTwoTo63 = 9223372036854775808.0;
  if (std::isnan(b)) return Order::kUnordered;
  if (b >= kTwoTo63) return Order::kLess;
  if (b < -kTwoTo63) return Order::kGreater;
  const double whole = std::trunc(b);
  const Order order = OrderOf(a, static_cast<std::int64_t>(whole));
  return order == Order::kEqual ? OrderOf(whole, b) : order;
}

Order OrderOfNumbers(const Operand& a, const Operand& b) {
  const Operand x = ToNumber(a);
  const Operand y = ToNumber(b);
  if (x.kind == Kind::kInteger) {
    return y.kind == Kind::kInteger ? OrderOf(x.integer, y.integer) : OrderOf(x.integer, y.number);
  }
  return y.kind == Kind::kInteger ? Reversed(OrderOf(y.integer, x.number))
                                  : OrderOf(x.number, y.number);
}

Order OrderOfTextAndNumber(std::string_view text, const Operand& number) {
  bool truth = false;
  if (number.kind == Kind::kBool && ValueTraits<bool>::Parse(text, truth)) {
    return OrderOfNumbers(Operand::Bool(truth), number);
  }
  std::int64_t integer = 0;
  if (ValueTraits<std::int64_t>::Parse(text, integer)) {
    return OrderOfNumbers(Operand::Integer(integer), number);
  }
  double value = 0;
  if (ValueTraits<double>::Parse(text, value)) {
    return OrderOfNumbers(Operand::Double(value), number);
  }
  return Order::kDifferent;
}

Order OrderOfOtherAndText(const Value& other, std::string_view text) {
  Value read;
  if (!read.Parse(*other.type(), text)) return Order::kDifferent;
  if (other.type()->enumerators) return OrderOf(other.EnumeratorValue(), read.EnumeratorValue());
  return read.Print() == other.Print() ? Order::kSame : Order::kDifferent;
}

Order OrderOfOthers(const Operand& a, const Operand& b) {
  if (b.kind == Kind::kText) return OrderOfOtherAndText(*a.other, b.text());
  if (a.kind == Kind::kText) return Reversed(OrderOfOtherAndText(*b.other, a.text()));
  if (a.kind != b.kind || a.other->type() != b.other->type()) {
    throw Failure{Describe(a) + " and " + Describe(b) + " cannot be compared"};
  }
  return a.other->Print() == b.other->Print() ? Order::kSame : Order::kDifferent;
}

bool IsNumber(const Operand& operand) {
  return operand.kind < Kind::kText || IsEnumerator(operand);
}

Order OrderOf(const Operand& a, const Operand& b) {
  if (IsNumber(a) && IsNumber(b)) return OrderOfNumbers(a, b);
  if (a.kind == Kind::kOther || b.kind == Kind::kOther) return OrderOfOthers(a, b);
  if (a.kind != Kind::kText) return Reversed(OrderOfTextAndNumber(b.text(), a));
  if (b.kind != Kind::kText) return OrderOfTextAndNumber(a.text(), b);
  return OrderOf(a.text(), b.text());
}

}  // namespace

const char* ToString(Relation relation) {
  constexpr const char* kNames[] = {"==", "!=", "<", "<=", ">", ">="};
  return kNames[static_cast<int>(relation)];
}

bool Holds(Relation relation, const Operand& a, const Operand& b) {
  const Order order = OrderOf(a, b);
  const bool equal = order == Order::kEqual || order == Order::kSame;
  if (relation == Relation::kEqual) return equal;
  if (relation == Relation::kNotEqual) return !equal;
  if (order >= Order::kSame) {
    throw Failure{std::string("\"") + ToString(relation) + "\" has no meaning between " +
                  Describe(a) + " and " + Describe(b)};
  }
  const bool strict = relation == Relation::kLess || relation == Relation::kGreater;
  const bool less = relation == Relation::kLess || relation == Relation::kLessOrEqual;
  return order == (less ? Order::kLess : Order::kGreater) || (!strict && equal);
}

}  // namespace coppice::script
