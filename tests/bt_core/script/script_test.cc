#include "bt_core/script/script.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/data/standard_types.h"
#include "tests/bt_core/script/fixture.h"

namespace coppice {
namespace {

TEST(Script, TestsTheLastStatement) {
  ScriptBench bench;
  EXPECT_TRUE(bench.Test("x := 3; y := 5; x < y"));
  EXPECT_FALSE(bench.Test("x := 3; y := 5; x > y"));
  EXPECT_TRUE(bench.Test("x := 7"));
  EXPECT_FALSE(bench.Test("x := 0"));
}

TEST(Script, TestsConditionsOnKeysAgainstConstants) {
  struct Case {
    const char* text;
    bool holds;
  };
  const Case cases[] = {{"d > 20", true},
                        {"d > 50", false},
                        {"d >= 50", true},
                        {"d < 50.5", true},
                        {"d <= 49", false},
                        {"d == 50", true},
                        {"d != 50", false},
                        {"20 < d", true},
                        {"50 >= d", true},
                        {"50 > d", false},
                        {"i == 7", true},
                        {"i < 7.5", true},
                        {"i == 7.5", false},
                        {"b", true},
                        {"!b", false},
                        {"!(d > 20)", false},
                        {"d > 20 && !b", false},
                        {"d > 20 || !b", true},
                        {"i < 3 || d < 3 || b", true},
                        {"!(i < 3 || d < 3)", true},
                        {"b == true", true},
                        {"s == 'on'", true},
                        {"s != 'on'", false}};
  ScriptBench bench;
  bench.Set("d", 50.0);
  bench.Set("i", std::int64_t{7});
  bench.Set("b", true);
  bench.Set("s", std::string("on"));
  for (const Case& c : cases) EXPECT_EQ(bench.Test(c.text), c.holds) << c.text;
}

TEST(Script, ComparesIntegersAndDoublesWithoutRounding) {
  ScriptBench bench;
  bench.Set("large", std::int64_t{9007199254740993});  // 2^53 + 1
  bench.Set("rounded", 9007199254740992.0);
  EXPECT_FALSE(bench.Test("large == rounded"));
  EXPECT_TRUE(bench.Test("large > rounded"));
  EXPECT_FALSE(bench.Test("rounded == 9007199254740993"));
  EXPECT_FALSE(bench.Test("0.00000005 == 0"));
  EXPECT_TRUE(bench.Test("9223372036854775807 < 9223372036854775808.0"));
}

TEST(Script, NothingComparesWithNaN) {
  ScriptBench bench;
  bench.Set("nan", std::numeric_limits<double>::quiet_NaN());
  for (const char* text :
       {"nan < 1", "nan <= 1", "nan > 1", "nan >= 1", "nan == 1", "nan == nan"}) {
    EXPECT_FALSE(bench.Test(text)) << text;
    EXPECT_TRUE(bench.Test("!(" + std::string(text) + ")")) << text;
  }
  EXPECT_TRUE(bench.Test("nan != 1"));
}

TEST(Script, DoesNotEvaluateWhatDoesNotMatter) {
  ScriptBench bench;
  EXPECT_FALSE(bench.Test("false && missing"));
  EXPECT_TRUE(bench.Test("true || missing"));
  EXPECT_FALSE(bench.Test("2 < 1 < missing"));
  EXPECT_TRUE(bench.Test("true ? 1 : missing"));
  EXPECT_TRUE(bench.Test("x := 1; (x == 1 || (x := 2)) && x == 1"));
  EXPECT_THROW(bench.Test("true && missing"), ScriptError);
}

TEST(Script, ATextMayReadAsTrueOrFalse) {
  ScriptBench bench;
  bench.Set("given", std::string("true"));
  EXPECT_TRUE(bench.Test("given"));
  EXPECT_FALSE(bench.Test("!given"));
  bench.Set("given", std::string("0"));
  EXPECT_FALSE(bench.Test("given"));
  bench.Set("given", std::string("maybe"));
  EXPECT_THROW(bench.Test("given"), ScriptError);
  EXPECT_NO_THROW(bench.Run("given"));
}

TEST(Script, AssignsFromTheRight) {
  ScriptBench bench;
  bench.Run("a := b := 4");
  EXPECT_EQ(bench.Show("a"), "int64 4");
  EXPECT_EQ(bench.Show("b"), "int64 4");
  bench.Run("a += b *= 2");
  EXPECT_EQ(bench.Show("a"), "int64 12");
}

TEST(Script, AKeyMustExistForAPlainAssignment) {
  ScriptBench bench;
  bench.Declare<double>("typed");
  EXPECT_THROW(bench.Run("fresh = 1"), ScriptError);
  EXPECT_THROW(bench.Run("fresh += 1"), ScriptError);
  bench.Run("fresh := 1; fresh = 2");
  EXPECT_EQ(bench.Show("fresh"), "int64 2");
  bench.Run("typed = 1");
  EXPECT_EQ(bench.Show("typed"), "double 1");
}

TEST(Script, CountsEveryWrite) {
  ScriptBench bench;
  bench.Run("x := 1; x = 1; x += 1");
  EXPECT_EQ(bench.SlotOf("x").writes, 3U);
  bench.Test("x := 1");
  EXPECT_EQ(bench.SlotOf("x").writes, 4U);
  bench.Test("x == 1");
  EXPECT_EQ(bench.SlotOf("x").writes, 4U);
}

TEST(Script, WhatWasAssignedBeforeAnErrorStays) {
  ScriptBench bench;
  EXPECT_THROW(bench.Run("x := 1; y := missing; x := 2"), ScriptError);
  EXPECT_EQ(bench.Show("x"), "int64 1");
  EXPECT_EQ(bench.Show("y"), "empty");
}

TEST(Script, ATextThatIsBeingReadDoesNotChange) {
  ScriptBench bench;
  const std::string text(100, 'a');
  bench.Set("s", text);
  bench.Run("t := s .. (s := 'short') .. s");
  EXPECT_EQ(bench.Show("t"), "string " + text + "shortshort");
  bench.Set("s", text);
  bench.Run("s += s := 'short'");
  EXPECT_EQ(bench.Show("s"), "string " + text + "short");
  bench.Run("s := s; s := s .. s");
  EXPECT_EQ(bench.Show("s"), "string " + text + "short" + text + "short");
}

TEST(Script, AnErrorNamesScriptPlaceAndKey) {
  ScriptBench bench;
  try {
    bench.Test("1 < 2 && battery > 20");
    FAIL() << "no value";
  } catch (const ScriptError& error) {
    EXPECT_STREQ(error.what(),
                 "script \"1 < 2 && battery > 20\", at character 10, key \"battery\": it has no "
                 "value yet");
  }
}

TEST(Script, ListsWhatItReadsAndWrites) {
  ScriptBench bench;
  const Script script = bench.Compile("a := b + b; c += 1; d && @e");
  EXPECT_EQ(script.reads(), (std::vector{SlotIndex{1}, SlotIndex{2}, SlotIndex{3}, SlotIndex{4}}));
  EXPECT_EQ(script.writes(), (std::vector{SlotIndex{0}, SlotIndex{2}}));
}

TEST(Script, ConstantsAreNumbers) {
  ScriptBench bench;
  bench.constants() = {{"RED", 1}, {"BLUE", 3}};
  bench.Run("color := BLUE");
  EXPECT_EQ(bench.Show("color"), "int64 3");
  EXPECT_TRUE(bench.Test("color == BLUE && color != RED"));
  const std::vector<ScriptProblem> problems = bench.ProblemsOf("color == RED; RED := 5");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].offset, 14U);
}

TEST(Script, ANameIsAConstantOrAKeyButNotBoth) {
  ScriptBench bench;
  bench.constants() = {{"RED", 1}};
  bench.Declare<int>("RED");
  const std::vector<ScriptProblem> problems = bench.ProblemsOf("color := RED");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].message, "\"RED\" is both a constant and a key");
  EXPECT_EQ(problems[0].offset, 9U);
}

TEST(Script, ConstantsAreRealNumbersIfTheyAreToBe) {
  ScriptBench bench;
  bench.constants() = {{"ANSWER", 42}};
  bench.constants().are_real = true;
  bench.Run("answer := ANSWER");
  EXPECT_EQ(bench.Show("answer"), "double 42");
}

TEST(Script, TheEnumeratorsOfAnEnumBecomeConstants) {
  ScriptConstants constants = {{"RUNNING", 1}};
  EXPECT_EQ(AddEnumerators(EnumeratorsOf<Status>(), constants), std::nullopt);
  EXPECT_EQ(constants.size(), 5U);
  EXPECT_EQ(constants.at("FAILURE"), 3);
  constants["SKIPPED"] = 77;
  EXPECT_EQ(AddEnumerators(EnumeratorsOf<Status>(), constants), "SKIPPED");
}

TEST(Script, AKeyOfAnEnumComparesWithNamesAndNumbers) {
  ScriptBench bench;
  AddEnumerators(EnumeratorsOf<Status>(), bench.constants());
  bench.Declare<Status>("last");
  bench.Run("last := FAILURE");
  EXPECT_EQ(bench.Show("last"), "Status FAILURE");
  EXPECT_TRUE(bench.Test("last == FAILURE && last == 'FAILURE' && last == 3 && last != SUCCESS"));
  EXPECT_TRUE(bench.Test("last > RUNNING && last .. '!' == 'FAILURE!'"));
  bench.Run("last := 'SUCCESS'; copy := last");
  EXPECT_EQ(bench.Show("last"), "Status SUCCESS");
  EXPECT_EQ(bench.Show("copy"), "Status SUCCESS");
  EXPECT_TRUE(bench.Test("copy == last && copy == SUCCESS"));
  EXPECT_EQ(bench.ProblemsOf("last := 9").size(), 1U);
  EXPECT_EQ(bench.ProblemsOf("last == 'FAILED'").at(0).hint,
            "it is IDLE, RUNNING, SUCCESS, FAILURE or SKIPPED");
  EXPECT_THROW(bench.Run("nine := 9; last := nine"), ScriptError);
  EXPECT_EQ(bench.Show("last"), "Status SUCCESS");
}

TEST(Script, AllProblemsAreToldInTheOrderOfTheText) {
  ScriptBench bench;
  std::vector<ScriptProblem> problems = {{77, "of somebody else", ""}};
  const auto script =
      Script::Compile("1 = 2; x y; 'a' * 2; 5foo", bench.names(), bench.constants(), problems);
  EXPECT_FALSE(script);
  ASSERT_EQ(problems.size(), 4U) << "types are looked at when the grammar is right";
  EXPECT_EQ(problems[1].offset, 2U);
  EXPECT_EQ(problems[2].offset, 9U);
  EXPECT_EQ(problems[3].offset, 21U);
}

TEST(Script, NoTextExhaustsTheStack) {
  ScriptBench bench;
  for (const char* piece : {"(", "!", "-", "a:=", "a?", "1+(", "min(1,", "1?1:", "a&&(b||(", "'"}) {
    std::string text;
    while (text.size() < 1'000'000) text += piece;
    EXPECT_EQ(bench.ProblemsOf(text).size(), 1U) << piece << " for ever";
    const std::string shorter = text.substr(0, Script::kMaxSize / 8 * 8);
    EXPECT_GE(bench.ProblemsOf(shorter).size(), 1U) << piece;
  }
  std::string sum = "1";
  while (sum.size() < Script::kMaxSize - 2) sum += "+a";
  EXPECT_EQ(bench.ProblemsOf(sum).size(), 1U);
  std::string statements;
  while (statements.size() < Script::kMaxSize - 8) statements += "a:=1;";
  EXPECT_TRUE(bench.ProblemsOf(statements).empty());
}

TEST(Script, ACopyRunsTheSameCode) {
  ScriptBench bench;
  std::vector<Script> scripts;
  for (int i = 0; i < 10; ++i) scripts.push_back(bench.Compile("s := 'a short text'"));
  scripts[0].Run(bench.blackboard());
  EXPECT_EQ(bench.Show("s"), "string a short text");
}

}  // namespace
}  // namespace coppice
