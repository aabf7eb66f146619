#include "bt_core/script/store.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/data/standard_types.h"

namespace coppice::script {
namespace {

std::string Show(const Slot& slot) {
  return slot.value.has_value() ? std::string(slot.value.type()->name) + " " + slot.value.Print()
                                : "empty";
}

// What a slot becomes, or "refused"; in that case it must be as before.
template <class T>
std::string Typed(const Operand& operand) {
  Slot slot;
  try {
    Store(operand, &TypeOf<T>(), slot, Time{});
    EXPECT_EQ(slot.writes, 1U);
  } catch (const Failure&) {
    EXPECT_EQ(slot.writes, 0U);
    EXPECT_FALSE(slot.value.has_value());
    return "refused";
  }
  return Show(slot);
}
template <class T>
std::string Untyped(const T& before, const Operand& operand) {
  Slot slot;
  slot.value.Set(before);
  const std::string shown = Show(slot);
  try {
    Store(operand, nullptr, slot, Time{});
  } catch (const Failure&) {
    EXPECT_EQ(Show(slot), shown);
    return "refused";
  }
  return Show(slot);
}

Operand I(std::int64_t value) { return Operand::Integer(value); }
Operand D(double value) { return Operand::Double(value); }
Operand T(std::string_view text) { return Operand::Text(text); }

TEST(Store, ANumberBecomesItsTextInASlotOfTexts) {
  EXPECT_EQ(Typed<std::string>(I(3)), "string 3");
  EXPECT_EQ(Typed<std::string>(D(2.5)), "string 2.5");
  EXPECT_EQ(Typed<std::string>(Operand::Bool(true)), "string true");
}

TEST(Store, ATypedSlotKeepsItsTypeAndTheValue) {
  EXPECT_EQ(Typed<int>(I(5)), "int 5");
  EXPECT_EQ(Typed<int>(D(5)), "int 5");
  EXPECT_EQ(Typed<int>(D(5.5)), "refused");
  EXPECT_EQ(Typed<int>(I(2147483648)), "refused");
  EXPECT_EQ(Typed<unsigned>(I(-1)), "refused");
  EXPECT_EQ(Typed<std::uint64_t>(I(-1)), "refused");
  EXPECT_EQ(Typed<std::uint64_t>(I(7)), "uint64 7");
  EXPECT_EQ(Typed<std::int64_t>(D(9223372036854775808.0)), "refused");
  EXPECT_EQ(Typed<double>(I(5)), "double 5");
  EXPECT_EQ(Typed<float>(D(0.1)), "float 0.1");
  EXPECT_EQ(Typed<bool>(I(1)), "bool true");
  EXPECT_EQ(Typed<bool>(I(2)), "refused");
  EXPECT_EQ(Typed<std::string>(T("a")), "string a");
}

TEST(Store, ATextIsReadAsTheSlotsType) {
  EXPECT_EQ(Typed<int>(T("5")), "int 5");
  EXPECT_EQ(Typed<int>(T("5x")), "refused");
  EXPECT_EQ(Typed<Status>(T("SUCCESS")), "Status SUCCESS");
  EXPECT_EQ(Typed<std::vector<int>>(T("1;2")), "list of int 1;2");
}

TEST(Store, AnEnumTakesItsEnumeratorsOnly) {
  EXPECT_EQ(Typed<Status>(I(2)), "Status SUCCESS");
  EXPECT_EQ(Typed<Status>(I(9)), "refused");
  const Value failure(Status::kFailure);
  EXPECT_EQ(Typed<Status>(Operand::Other(failure)), "Status FAILURE");
  EXPECT_EQ(Typed<int>(Operand::Other(failure)), "int 3");
  EXPECT_EQ(Typed<std::string>(Operand::Other(failure)), "string FAILURE");
}

TEST(Store, OtherTypesTakeTheirOwnOnly) {
  const Value list(std::vector<int>{1});
  EXPECT_EQ(Typed<std::vector<int>>(Operand::Other(list)), "list of int 1");
  EXPECT_EQ(Typed<std::vector<double>>(Operand::Other(list)), "refused");
  EXPECT_EQ(Typed<int>(Operand::Other(list)), "refused");
  EXPECT_EQ(Typed<std::vector<int>>(I(1)), "refused");
}

TEST(Store, TheFirstValueGivesAnUntypedSlotItsType) {
  const Value list(std::vector<int>{1});
  for (const auto& [operand, expected] :
       std::vector<std::pair<Operand, std::string>>{{Operand::Bool(true), "bool true"},
                                                    {I(5), "int64 5"},
                                                    {D(5), "double 5"},
                                                    {T("a"), "string a"},
                                                    {Operand::Other(list), "list of int 1"}}) {
    Slot slot;
    Store(operand, nullptr, slot, Time{});
    EXPECT_EQ(Show(slot), expected);
  }
}

TEST(Store, LaterValuesBecomeThatType) {
  EXPECT_EQ(Untyped(std::int64_t{1}, D(5)), "int64 5");
  EXPECT_EQ(Untyped(1.5, I(5)), "double 5");
  EXPECT_EQ(Untyped(true, I(0)), "bool false");
  EXPECT_EQ(Untyped(1, T("7")), "int 7");
  EXPECT_EQ(Untyped(1, T("x")), "refused");
  EXPECT_EQ(Untyped(std::string("a"), I(5)), "refused");
  EXPECT_EQ(Untyped(std::vector<int>{1}, I(5)), "refused");
}

TEST(Store, ANumberThatIsNotKeptWidensTheSlot) {
  EXPECT_EQ(Untyped(std::int64_t{1}, D(2.5)), "double 2.5");
  EXPECT_EQ(Untyped(true, I(7)), "int64 7");
  EXPECT_EQ(Untyped(true, D(0.5)), "double 0.5");
  EXPECT_EQ(Untyped(1U, I(-1)), "int64 -1");
}

}  // namespace
}  // namespace coppice::script
