#include "bt_core/script/operand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "bt_core/data/standard_types.h"

namespace coppice::script {
namespace {

constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();

Operand I(std::int64_t value) { return Operand::Integer(value); }
Operand D(double value) { return Operand::Double(value); }

// Integers as "5", doubles as "5.0".
std::string Show(const Operand& operand) {
  const bool whole = operand.kind == Operand::Kind::kDouble && std::isfinite(operand.number) &&
                     std::trunc(operand.number) == operand.number;
  return Describe(operand) + (whole ? ".0" : "");
}

TEST(Operand, IntegersStayIntegersAsLongAsTheyFit) {
  EXPECT_EQ(Show(Add(I(2), I(3))), "5");
  EXPECT_EQ(Show(Subtract(I(2), I(3))), "-1");
  EXPECT_EQ(Show(Multiply(I(-2), I(3))), "-6");
  EXPECT_EQ(Show(Add(I(9007199254740993), I(0))), "9007199254740993") << "not by way of a double";
  EXPECT_EQ(Show(Add(I(kMost), I(1))), "9.223372036854776e+18.0");
  EXPECT_EQ(Show(Subtract(I(kLeast), I(1))), "-9.223372036854776e+18.0");
  EXPECT_EQ(Show(Multiply(I(kMost), I(2))), "1.8446744073709552e+19.0");
  EXPECT_EQ(Show(Negate(I(kLeast))), "9.223372036854776e+18.0");
  EXPECT_EQ(Show(Absolute(I(kLeast))), "9.223372036854776e+18.0");
}

TEST(Operand, ADoubleMakesADouble) {
  EXPECT_EQ(Show(Add(I(2), D(3))), "5.0");
  EXPECT_EQ(Show(Multiply(D(0.5), I(3))), "1.5");
  EXPECT_EQ(Show(Negate(D(2))), "-2.0");
  EXPECT_EQ(Show(Absolute(D(-2.5))), "2.5");
}

TEST(Operand, DivisionIsOneOfDoubles) {
  EXPECT_EQ(Show(Divide(I(7), I(2))), "3.5");
  EXPECT_EQ(Show(Divide(I(6), I(2))), "3.0");
  EXPECT_EQ(Show(Divide(I(1), I(0))), "inf");
}

TEST(Operand, TheRemainderHasTheSignOfTheDividend) {
  EXPECT_EQ(Show(Remainder(I(7), I(3))), "1");
  EXPECT_EQ(Show(Remainder(I(-7), I(3))), "-1");
  EXPECT_EQ(Show(Remainder(D(5.5), I(2))), "1.5");
  EXPECT_EQ(Show(Remainder(I(kLeast), I(-1))), "0");
  EXPECT_THROW(Remainder(I(1), I(0)), Failure);
  EXPECT_THROW(Remainder(D(1), D(0)), Failure);
}

TEST(Operand, BitsAreThoseOf64BitIntegers) {
  EXPECT_EQ(Show(BitAnd(I(12), I(10))), "8");
  EXPECT_EQ(Show(BitOr(I(12), D(10))), "14");
  EXPECT_EQ(Show(BitXor(I(12), I(10))), "6");
  EXPECT_EQ(Show(Complement(I(0))), "-1");
  EXPECT_THROW(BitAnd(I(1), D(0.5)), Failure);
  EXPECT_THROW(BitOr(D(1e19), I(1)), Failure);
  EXPECT_THROW(Complement(D(std::nan(""))), Failure);
}

TEST(Operand, FunctionsKeepTheirOperandAsItIs) {
  EXPECT_EQ(Show(Min(I(2), D(1.5))), "1.5");
  EXPECT_EQ(Show(Min(I(1), D(1.5))), "1");
  EXPECT_EQ(Show(Max(I(2), D(1.5))), "2");
  EXPECT_EQ(Show(Clamp(D(7.5), I(0), I(5))), "5");
  EXPECT_EQ(Show(Clamp(I(-1), I(0), I(5))), "0");
  EXPECT_EQ(Show(Clamp(I(3), I(0), I(5))), "3");
  EXPECT_THROW(Clamp(I(3), I(5), I(0)), Failure);
}

TEST(Operand, TruthValuesCountAsNumbers) {
  EXPECT_EQ(Show(Add(Operand::Bool(true), I(1))), "2");
  EXPECT_EQ(Show(Negate(Operand::Bool(true))), "-1");
  EXPECT_THROW(Add(Operand::Text("1"), I(1)), Failure);
}

TEST(Operand, IsTrueLikeInC) {
  EXPECT_TRUE(IsTrue(I(-3)));
  EXPECT_FALSE(IsTrue(I(0)));
  EXPECT_TRUE(IsTrue(D(0.1)));
  EXPECT_FALSE(IsTrue(D(-0.0)));
  for (const char* yes : {"true", "TRUE", "1", "2.5"}) EXPECT_TRUE(IsTrue(Operand::Text(yes)));
  for (const char* no : {"false", "0", "0.0"}) EXPECT_FALSE(IsTrue(Operand::Text(no)));
  for (const char* neither : {"", "maybe"}) EXPECT_THROW(IsTrue(Operand::Text(neither)), Failure);
}

TEST(OperandOf, KnowsAllNumbers) {
  EXPECT_EQ(Show(OperandOf(Value(true))), "true");
  EXPECT_EQ(Show(OperandOf(Value(-1))), "-1");
  EXPECT_EQ(Show(OperandOf(Value(4294967295U))), "4294967295");
  EXPECT_EQ(Show(OperandOf(Value(kMost))), "9223372036854775807");
  EXPECT_EQ(Show(OperandOf(Value(std::uint64_t{7}))), "7");
  EXPECT_EQ(Show(OperandOf(Value(~std::uint64_t{0}))), "1.8446744073709552e+19.0");
  EXPECT_EQ(Show(OperandOf(Value(0.5F))), "0.5");
  const Value text(std::string("a"));
  EXPECT_EQ(Show(OperandOf(text)), "'a'");
}

TEST(OperandOf, EnumeratorsAreNumbersToo) {
  const Value status(Status::kFailure);
  EXPECT_EQ(Show(OperandOf(status)), "Status 'FAILURE'");
  EXPECT_EQ(Show(Add(OperandOf(status), I(1))), "4");
  const Value list(std::vector<int>{1});
  EXPECT_THROW(IsTrue(OperandOf(list)), Failure);
}

}  // namespace
}  // namespace coppice::script
