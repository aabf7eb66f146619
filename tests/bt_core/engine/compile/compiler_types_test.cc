#include "bt_core/engine/compile/compiler_types.h"

#include <gtest/gtest.h>

#include "bt_core/data/standard_types.h"

namespace coppice {
namespace {

struct SlotTypesTest : testing::Test {
  SlotIndex Slot(const std::string& key, const Type* type = nullptr) {
    layout.slots.push_back({key, kMainScope, type, Value()});
    return static_cast<SlotIndex>(layout.slots.size() - 1);
  }
  static PortDeclaration Port(const Type* type) {
    return {"port", PortDirection::kInput, type, "", true, std::nullopt};
  }
  const Value& Initial(SlotIndex slot) const { return layout.slots[slot].initial; }

  Diagnostics diagnostics;
  const Document document = *Document::FromText("<root/>", "t.xml", diagnostics);
  const DocumentPlace place{&document, 0};
  Problems problems{diagnostics};
  Layout layout;
  SlotTypes types{layout, problems};
};

TEST_F(SlotTypesTest, APortOfAnyTypeChangesNothing) {
  const PortDeclaration any = Port(nullptr);
  const PortDeclaration number = Port(&TypeOf<int>());
  const SlotIndex slot = Slot("k");
  types.Set(slot, "A", any, place);
  EXPECT_EQ(types.Of(slot), nullptr);
  types.Set(slot, "B", number, place);
  types.Set(slot, "A", any, place);
  EXPECT_EQ(types.Of(slot), &TypeOf<int>());
  EXPECT_EQ(diagnostics.ToString(), "");
}

TEST_F(SlotTypesTest, PortsThatDisagreeAreAnError) {
  const PortDeclaration number = Port(&TypeOf<int>());
  const PortDeclaration text = Port(&TypeOf<std::string>());
  const SlotIndex slot = Slot("k");
  types.Set(slot, "A", number, place);
  types.Set(slot, "B", text, place);
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:1:1: error: key \"k\" is int (from A.port), but port \"port\" of B is string\n");
}

TEST_F(SlotTypesTest, ALiteralGetsTheTypeOfItsSlotOrElseThatOfItsText) {
  const SlotIndex text = Slot("text", &TypeOf<std::string>());
  const SlotIndex any = Slot("any");
  types.AddLiteral(text, "00042", "key", place);
  types.AddLiteral(any, "42", "key", place);
  types.Settle();
  EXPECT_EQ(Initial(text).Get<std::string>(), "00042");
  EXPECT_EQ(Initial(any).Get<std::int64_t>(), 42);
}

TEST_F(SlotTypesTest, AWrongLiteralSaysWhatWasExpected) {
  types.AddLiteral(Slot("k", &TypeOf<int>()), "far", R"(key "k" inside)", place);
  types.Settle();
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:1:1: error: \"far\" is not a value for key \"k\" inside (expected int)\n");
}

TEST_F(SlotTypesTest, AWrongLiteralOfAnEnumListsTheChoices) {
  types.AddLiteral(Slot("k", &TypeOf<Status>()), "GOOD", R"(port "else")", place);
  types.Settle();
  EXPECT_EQ(diagnostics.ToString(), R"(t.xml:1:1: error: "GOOD" is not a value for port "else" )"
                                    "(expected IDLE, RUNNING, SUCCESS, FAILURE or SKIPPED)\n");
}

TEST_F(SlotTypesTest, AModelsTypeCountsWherePortsGiveNone) {
  const SlotIndex slot = Slot("k");
  types.Suggest(slot, TypeOf<std::string>(), place);
  types.AddLiteral(slot, "42", "key", place);
  types.Settle();
  EXPECT_TRUE(Initial(slot).Is<std::string>());
}

TEST_F(SlotTypesTest, AModelThatSaysOtherwiseThanThePortsIsWarnedOf) {
  types.Suggest(Slot("k", &TypeOf<int>()), TypeOf<std::string>(), place);
  types.Suggest(Slot("n", &TypeOf<unsigned>()), TypeOf<int>(), place);
  types.Settle();
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:1:1: warning: the model says string, but it is int inside the tree\n");
}

TEST_F(SlotTypesTest, ACopiedLiteralGetsTheTypeOfTheTargetThroughAChain) {
  const SlotIndex literal = Slot("");
  const SlotIndex between = Slot("between");
  const SlotIndex target = Slot("target", &TypeOf<double>());
  types.AddLiteral(literal, "5", "port", place);
  types.AddCopy(literal, between, "SetBlackboard", place);
  types.AddCopy(between, target, "SetBlackboard", place);
  types.Settle();
  EXPECT_EQ(Initial(literal).Get<double>(), 5);
  EXPECT_EQ(types.Of(between), &TypeOf<double>());
}

TEST_F(SlotTypesTest, ACopyToAnotherTypeIsAnError) {
  types.AddCopy(Slot("a", &TypeOf<int>()), Slot("b", &TypeOf<double>()), "SetBlackboard", place);
  types.AddCopy(Slot("c", &TypeOf<int>()), Slot("d"), "SetBlackboard", place);
  types.Settle();
  EXPECT_EQ(diagnostics.ToString(),
            R"(t.xml:1:1: error: SetBlackboard copies key "a", which is int, to key "b", which is )"
            "double\n");
}

}  // namespace
}  // namespace coppice
