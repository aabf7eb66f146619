#include "editor/canvas/layout/value_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

using ::testing::ElementsAre;

const PortModel kCode = {"code", PortDirection::kInput, "script", "", {}};

std::vector<std::string> Script(const char* text, bool whole = false) {
  PortLine port;
  port.name = "code";
  port.value = text;
  port.model = &kCode;
  EXPECT_EQ(ValueLineCount(port, whole), ValueLines(port, whole).size());
  return ValueLines(port, whole);
}

std::vector<std::string> Literal(const char* text, bool whole) {
  PortLine port;
  port.name = "text";
  port.value = text;
  return ValueLines(port, whole);
}

TEST(ValueLines, AShortScriptIsOneLine) {
  EXPECT_THAT(Script("a := 1; b := 2"), ElementsAre("a := 1; b := 2"));
  EXPECT_THAT(Script(""), ElementsAre(""));
}

TEST(ValueLines, AStatementOfALongScriptBeginsALine) {
  EXPECT_THAT(Script("speed := 1.5; goal := 'kitchen; left'; tries += 1"),
              ElementsAre("speed := 1.5;", "goal := 'kitchen; left';", "tries += 1"));
}

TEST(ValueLines, ALongStatementGoesOnBelowAtABlank) {
  EXPECT_THAT(Script("battery_is_low := voltage < 22.5 && !is_docked && minutes > 10"),
              ElementsAre("battery_is_low := voltage < 22.5", "  && !is_docked && minutes > 10"));
}

TEST(ValueLines, WhatHasNoBlankIsBrokenAtACharacter) {
  const std::vector<std::string> lines = Script(
      "\xC3\xA4"
      "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], "\xC3\xA4" + std::string(33, 'a'));
  EXPECT_EQ(lines[1], "  " + std::string(11, 'a'));
}

TEST(ValueLines, OnTheCanvasAScriptIsCutAfterFourLinesAndOnPaperItIsWhole) {
  const char* const text = "a_long_name := 1;\nb_name := 2;\n\nc_name := 3;\nd_name := 4;\ne := 5";
  EXPECT_THAT(Script(text), ElementsAre("a_long_name := 1;", "b_name := 2;", "c_name := 3;",
                                        std::string("d_name := 4;") + icon::kEllipsis));
  EXPECT_THAT(Script(text, true), ElementsAre("a_long_name := 1;", "b_name := 2;", "c_name := 3;",
                                              "d_name := 4;", "e := 5"));
}

TEST(ValueLines, GuardsAreScripts) {
  PortLine port;
  port.name = "_skipIf";
  port.value = "is_docked && battery.percentage > 0.95";
  EXPECT_EQ(ValueLines(port, false).size(), 2U);
}

TEST(ValueLines, OtherTextsAreCutOnTheCanvasAndWholeOnPaper) {
  const char* const text = "I am on my way to the kitchen, please step aside";
  EXPECT_THAT(Literal(text, false),
              ElementsAre(std::string("I am on my way to the kitchen, ple") + icon::kEllipsis));
  EXPECT_THAT(Literal(text, true),
              ElementsAre("I am on my way to the kitchen,", "  please step aside"));
}

TEST(ValueLines, AKeyIsNeverBroken) {
  PortLine port;
  port.name = "goal";
  port.value = "{the_very_long_name_of_the_next_goal_of_the_robot}";
  port.key = "the_very_long_name_of_the_next_goal_of_the_robot";
  EXPECT_THAT(ValueLines(port, true), ElementsAre(std::string(port.value)));
  EXPECT_EQ(ValueLines(port, false).size(), 1U);
}

}  // namespace
}  // namespace coppice::editor
