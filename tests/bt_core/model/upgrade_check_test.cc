#include "bt_core/model/upgrade_check.h"

#include "tests/bt_core/model/edited.h"

namespace coppice {
namespace {

std::string Upgrade(const std::string& text, std::string_view type, Diagnostics& diagnostics) {
  const Document document = Parsed(text);
  return After(document, UpgradeBlackboardCheck(document, kRootElement, type, diagnostics));
}
std::string Upgrade(const std::string& kind, const std::string& attributes) {
  Diagnostics diagnostics;
  const std::string type = "BlackboardCheck" + kind;
  std::string after =
      Upgrade("<" + type + " " + attributes + "><A/></" + type + ">", type, diagnostics);
  EXPECT_EQ(diagnostics.ToString(), "");
  return after;
}

TEST(UpgradeBlackboardCheck, BecomesAConditionThatIsTestedOnEveryTick) {
  EXPECT_EQ(Upgrade("Int", "value_A='{x}' value_B='3' return_on_mismatch='FAILURE'"),
            R"(<ReactiveSequence><ScriptCondition code="x == 3"/><A/></ReactiveSequence>)");
  EXPECT_EQ(Upgrade("Double", "name='n' value_A='{x}' value_B='{y}'"),
            R"(<ReactiveSequence name='n'><ScriptCondition code="x == y"/><A/>)"
            "</ReactiveSequence>");
}

TEST(UpgradeBlackboardCheck, SuccessOnMismatchIsAFallbackOfTheOpposite) {
  EXPECT_EQ(Upgrade("Bool", "value_A='{x}' value_B='1' return_on_mismatch='success'"),
            R"(<ReactiveFallback><ScriptCondition code="x != true"/><A/></ReactiveFallback>)");
}

TEST(UpgradeBlackboardCheck, TextIsQuotedForTheScript) {
  EXPECT_EQ(Upgrade("String", R"(value_A='{x}' value_B='a &lt; "b"')"),
            R"(<ReactiveSequence><ScriptCondition code="x == 'a &lt; &quot;b&quot;'"/><A/>)"
            "</ReactiveSequence>");
}

TEST(UpgradeBlackboardCheck, KeepsTheLayout) {
  Diagnostics diagnostics;
  EXPECT_EQ(Upgrade("<Decorator ID='BlackboardCheckInt'\n  value_A='{x}'\n  value_B='3'>\n"
                    "  <!-- c -->\n  <A/>\n</Decorator>",
                    "BlackboardCheckInt", diagnostics),
            "<ReactiveSequence>\n  <ScriptCondition code=\"x == 3\"/>\n  <!-- c -->\n  <A/>\n"
            "</ReactiveSequence>");
}

TEST(UpgradeBlackboardCheck, WhatAScriptCannotSayIsAWarning) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "value_A"},
      {"value_A='{x}'", "value_B"},
      {"value_A='{x}' value_B='three'", "value_B"},
      {"value_A='{a-b}' value_B='3'", "value_A"},
      {"value_A='{x}' value_B='nan'", "value_B"},
      {"value_A='{x}' value_B='3' return_on_mismatch='RUNNING'", "return_on_mismatch"}};
  for (const auto& [attributes, culprit] : cases) {
    Diagnostics diagnostics;
    const std::string text =
        std::string("<BlackboardCheckInt ") + attributes + "><A/></BlackboardCheckInt>";
    EXPECT_EQ(Upgrade(text, "BlackboardCheckInt", diagnostics), text);
    EXPECT_EQ(diagnostics.ToString(),
              "t.xml:1:1: warning: BlackboardCheckInt cannot be upgraded by itself: " +
                  std::string(culprit) +
                  " is not what a script can hold "
                  "(format 4 has no such node; write a ScriptCondition)\n");
  }
}

TEST(UpgradeBlackboardCheck, KnowsItsTypesAndKeys) {
  EXPECT_TRUE(IsBlackboardCheck("BlackboardCheckString"));
  EXPECT_FALSE(IsBlackboardCheck("BlackboardCheck"));
  EXPECT_FALSE(IsBlackboardCheck("BlackboardCheckPose"));
  EXPECT_TRUE(IsKey("goal_2"));
  for (const char* name : {"", "2", "a b", "a-b", "/a", "true"}) EXPECT_FALSE(IsKey(name)) << name;
}

TEST(UpgradeBlackboardCheck, WithoutAChildItSaysSo) {
  Diagnostics diagnostics;
  Upgrade("<BlackboardCheckInt value_A='{x}' value_B='3'/>", "BlackboardCheckInt", diagnostics);
  EXPECT_NE(diagnostics.ToString().find("by itself: it has 0 children, not 1"), std::string::npos)
      << diagnostics.ToString();
}

}  // namespace
}  // namespace coppice
