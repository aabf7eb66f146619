#include "bt_core/script/relation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "bt_core/data/standard_types.h"

namespace coppice::script {
namespace {

// "<", "=", ">", "different" (only == and != have an answer), "unordered" (nothing but != holds) or
// "refused". Checks that all relations agree, in both directions.
std::string Order(const Operand& a, const Operand& b) {
  try {
    const bool equal = Holds(Relation::kEqual, a, b);
    EXPECT_EQ(Holds(Relation::kNotEqual, a, b), !equal);
    EXPECT_EQ(Holds(Relation::kEqual, b, a), equal);
    try {
      const bool less = Holds(Relation::kLess, a, b);
      const bool greater = Holds(Relation::kGreater, a, b);
      EXPECT_EQ(Holds(Relation::kLessOrEqual, a, b), less || equal);
      EXPECT_EQ(Holds(Relation::kGreaterOrEqual, a, b), greater || equal);
      EXPECT_EQ(Holds(Relation::kGreater, b, a), less);
      EXPECT_EQ(Holds(Relation::kLess, b, a), greater);
      EXPECT_LE(less + greater + equal, 1);
      return less ? "<" : greater ? ">" : equal ? "=" : "unordered";
    } catch (const Failure&) {
      return equal ? "same" : "different";
    }
  } catch (const Failure&) {
    return "refused";
  }
}

Operand I(std::int64_t value) { return Operand::Integer(value); }
Operand D(double value) { return Operand::Double(value); }
Operand T(std::string_view text) { return Operand::Text(text); }

TEST(Relation, NumbersCompareExactly) {
  EXPECT_EQ(Order(I(1), I(2)), "<");
  EXPECT_EQ(Order(I(2), D(2)), "=");
  EXPECT_EQ(Order(I(2), D(1.5)), ">");
  EXPECT_EQ(Order(I(-2), D(-1.5)), "<");
  EXPECT_EQ(Order(I(9007199254740993), D(9007199254740992.0)), ">");
  EXPECT_EQ(Order(I(std::numeric_limits<std::int64_t>::max()), D(9223372036854775808.0)), "<");
  EXPECT_EQ(Order(I(std::numeric_limits<std::int64_t>::min()), D(-9223372036854775808.0)), "=");
  EXPECT_EQ(Order(I(0), D(-0.0)), "=");
  EXPECT_EQ(Order(I(0), D(1e300)), "<");
  EXPECT_EQ(Order(D(0.1), D(0.1 + 1e-9)), "<");
  EXPECT_EQ(Order(Operand::Bool(true), I(1)), "=");
}

TEST(Relation, NaNHasNoOrder) {
  EXPECT_EQ(Order(D(std::nan("")), D(1)), "unordered");
  EXPECT_EQ(Order(I(1), D(std::nan(""))), "unordered");
}

TEST(Relation, TextsCompareByTheirBytes) {
  EXPECT_EQ(Order(T("a"), T("b")), "<");
  EXPECT_EQ(Order(T("10"), T("9")), "<");
  EXPECT_EQ(Order(T(""), T("")), "=");
}

TEST(Relation, ATextNextToANumberIsReadAsOne) {
  EXPECT_EQ(Order(T("5"), I(5)), "=");
  EXPECT_EQ(Order(T(" 5.5 "), I(5)), ">");
  EXPECT_EQ(Order(T("9007199254740993"), I(9007199254740993)), "=");
  EXPECT_EQ(Order(T("5x"), I(5)), "different");
  EXPECT_EQ(Order(T(""), I(0)), "different");
  EXPECT_EQ(Order(T("true"), Operand::Bool(true)), "=");
  EXPECT_EQ(Order(T("true"), I(1)), "different");
}

TEST(Relation, EnumeratorsCompareByNumberAndName) {
  const Value failure(Status::kFailure);
  const Value success(Status::kSuccess);
  EXPECT_EQ(Order(Operand::Other(failure), I(3)), "=");
  EXPECT_EQ(Order(Operand::Other(failure), Operand::Other(success)), ">");
  EXPECT_EQ(Order(Operand::Other(failure), T("FAILURE")), "=");
  EXPECT_EQ(Order(Operand::Other(failure), T("SUCCESS")), ">");
  EXPECT_EQ(Order(Operand::Other(failure), T("nonsense")), "different");
}

TEST(Relation, OtherTypesAreEqualIfTheyPrintTheSame) {
  const Value first(std::vector<int>{1, 2});
  const Value second(std::vector<int>{1, 3});
  EXPECT_EQ(Order(Operand::Other(first), Operand::Other(first)), "same");
  EXPECT_EQ(Order(Operand::Other(first), Operand::Other(second)), "different");
  EXPECT_EQ(Order(Operand::Other(first), T("1; 2")), "same");
  EXPECT_EQ(Order(Operand::Other(first), I(1)), "refused");
  const Value doubles(std::vector<double>{1, 2});
  EXPECT_EQ(Order(Operand::Other(first), Operand::Other(doubles)), "refused");
}

TEST(Relation, HasASymbol) {
  EXPECT_STREQ(ToString(Relation::kEqual), "==");
  EXPECT_STREQ(ToString(Relation::kGreaterOrEqual), ">=");
}

}  // namespace
}  // namespace coppice::script
