#include "robot_app/knowledge/answers/answer_texts.h"

#include <gmock/gmock.h>

#include "tests/robot_app/knowledge/language_files.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::knowledge {
namespace {

using testing::HasSubstr;

const AnswerTexts& English() { return In(Language::kEnglish, ShippedLanguageFiles().texts); }
const AnswerTexts& German() { return In(Language::kGerman, ShippedLanguageFiles().texts); }

TEST(AnswerTexts, ASentenceIsFilledInAndBeginsWithACapital) {
  EXPECT_EQ(English().Fill("closed", {{"place", "the library"}, {"day", "today"}}),
            "The library is closed today.");
  EXPECT_EQ(Capitalized("übermorgen"), "Übermorgen");
  EXPECT_EQ(Capitalized(""), "");
}

TEST(AnswerTexts, ListsAreJoined) {
  EXPECT_EQ(English().List({"a", "b", "c"}), "a, b and c");
  EXPECT_EQ(German().List({"a", "b"}), "a und b");
  EXPECT_EQ(German().List({}), "");
}

TEST(AnswerTexts, DaysAreCalledAsPeopleCallThem) {
  const Day today{20782};
  EXPECT_EQ(English().DayName(today, today), "today");
  EXPECT_EQ(English().DayName(today + 2, today), "the day after tomorrow");
  EXPECT_EQ(German().DayName(today + 3, today), "am Samstag");
  EXPECT_EQ(English().DayName(today + 30, today), "on Friday, 25 December");
}

TEST(AnswerTexts, FloorsHaveNames) {
  EXPECT_EQ(English().Floor(0), "ground floor");
  EXPECT_EQ(German().Floor(2), "zweiter Stock");
  EXPECT_EQ(German().Floor(7), "7. Stock");
  EXPECT_EQ(English().Floor(-2), "basement");
}

TEST(AnswerTexts, WhatIsMissingUnknownOrNeverFilledInIsAnError) {
  TemporaryFolder folder;
  std::string text = coppice::ReadFile(LanguageFolder() + "/answers.en.yaml");
  text.replace(text.find("closed: \"{place}"), 16, "closed: \"{plaice}");
  text.replace(text.find("no_hours:"), 9, "no_hour:");
  coppice::WriteFile(folder.Path("answers.en.yaml"), text);
  Diagnostics diagnostics;
  AnswerTexts::Load(folder.path(), Language::kEnglish, diagnostics);
  EXPECT_THAT(diagnostics.ToString(),
              HasSubstr("\"closed\": nobody fills in {plaice} (did you mean \"place\"?)"));
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("\"no_hours\" is missing"));
  EXPECT_THAT(diagnostics.ToString(),
              HasSubstr("unknown key \"no_hour\" (did you mean \"no_hours\"?)"));
}

}  // namespace
}  // namespace coppice::robot::knowledge
