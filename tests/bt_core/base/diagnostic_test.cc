#include "bt_core/base/diagnostic.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

TEST(Diagnostic, PrintsPlaceSeverityMessageAndHint) {
  const Diagnostic diagnostic{
      Severity::kError, {"patrol.xml", 12, 9}, "unknown node", R"(did you mean "X"?)"};
  EXPECT_EQ(ToString(diagnostic), R"(patrol.xml:12:9: error: unknown node (did you mean "X"?))");
}

TEST(Diagnostic, LeavesOutWhatIsUnknown) {
  EXPECT_EQ(ToString({Severity::kWarning, {"a.xml", 0, 0}, "odd", ""}), "a.xml: warning: odd");
  EXPECT_EQ(ToString({Severity::kError, {}, "bad", ""}), "error: bad");
}

TEST(Diagnostic, IsOneLineThatNoTerminalObeys) {
  EXPECT_EQ(ToString({Severity::kError, {}, "node \"a\nb\x1B[2J\x7F\"", "h\ri"}),
            R"(error: node "a\nb\x1B[2J\u007F" (h\x0Di))");
}

TEST(Diagnostics, WarningsAreNotErrors) {
  Diagnostics diagnostics;
  diagnostics.Warning({"a.xml", 1, 1}, "odd");
  EXPECT_FALSE(diagnostics.has_errors());
  diagnostics.Error({"a.xml", 2, 1}, "bad");
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(Diagnostics, KeepTheOrderOfFindingOnePerLine) {
  Diagnostics diagnostics;
  diagnostics.Error({"a.xml", 5, 1}, "first");
  diagnostics.Warning({"a.xml", 1, 1}, "second");
  EXPECT_EQ(diagnostics.ToString(), "a.xml:5:1: error: first\na.xml:1:1: warning: second\n");
}

TEST(NearestName, FindsTheMisspeltOneWithoutCase) {
  EXPECT_EQ(NearestName("sequense", {"Fallback", "Sequence", "Sleep"}), "Sequence");
  EXPECT_EQ(NearestName("INVERTER", {"Inverter"}), "Inverter");
}

TEST(NearestName, TakesASwapForOneMistake) {
  EXPECT_EQ(NearestName("gaol", {"goal"}), "goal");
  EXPECT_EQ(NearestName("dcok", {"dock"}), "dock");
}

TEST(NearestName, TakesTheNearestOfSeveral) {
  EXPECT_EQ(NearestName("goal_pos", {"goal", "goal_pose", "goal_post_x"}), "goal_pose");
}

TEST(NearestName, LooksForNoneAmongMoreThanPeopleWrite) {
  EXPECT_EQ(NearestName("gaol", std::vector<std::string>(2000, "goal")), "goal");
  EXPECT_EQ(NearestName("gaol", std::vector<std::string>(2001, "goal")), "");
  EXPECT_EQ(NearestName(std::string(1001, 'a') + "b", {std::string(1001, 'a')}), "");
}

TEST(NearestName, IsEmptyWhenNothingIsNear) {
  EXPECT_EQ(NearestName("DriveTo", {"Sequence", "Fallback"}), "");
  EXPECT_EQ(NearestName("x", {}), "");
}

TEST(NearestName, AllowsAThirdOfTheLengthAndAtLeastOne) {
  EXPECT_EQ(NearestName("ab", {"ax"}), "ax");
  EXPECT_EQ(NearestName("ab", {"xy"}), "");
  EXPECT_EQ(NearestName("abcdef", {"abcdxy"}), "abcdxy");
  EXPECT_EQ(NearestName("abcdef", {"abcxyz"}), "");
}

TEST(DidYouMean, IsAQuestionOrNothing) {
  EXPECT_EQ(DidYouMean("Invertor", {"Inverter"}), R"(did you mean "Inverter"?)");
  EXPECT_EQ(NameMeant(DidYouMean("Invertor", {"Inverter"})), "Inverter");
  EXPECT_EQ(NameMeant("how often"), "");
  EXPECT_EQ(DidYouMean("Zzz", {"Inverter"}), "");
}

TEST(Diagnostics, KeepsSoManyOfAKindAndSaysThatThereAreMore) {
  Diagnostics diagnostics;
  for (int i = 0; i < 3 * Diagnostics::kMostOfAKind; ++i) diagnostics.Warning({"a.xml", 1, 1}, "w");
  EXPECT_EQ(diagnostics.all().size(), Diagnostics::kMostOfAKind + 1U);
  EXPECT_EQ(diagnostics.all().back().message, "and more warnings, not told");
  diagnostics.Error({"a.xml", 2, 1}, "an error after all of them");
  EXPECT_TRUE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.all().back().message, "an error after all of them");
}

TEST(Diagnostics, TakesOverAnotherList) {
  Diagnostics all;
  all.Warning({"a.xml", 1, 1}, "one");
  Diagnostics other;
  other.Warning({"b.xml", 1, 1}, "two");
  all.Append(other);
  EXPECT_FALSE(all.has_errors());
  other.Error({"b.xml", 2, 1}, "three");
  all.Append(other);
  EXPECT_TRUE(all.has_errors());
  EXPECT_EQ(all.ToString(),
            "a.xml:1:1: warning: one\nb.xml:1:1: warning: two\n"
            "b.xml:1:1: warning: two\nb.xml:2:1: error: three\n");
}

}  // namespace
}  // namespace coppice
