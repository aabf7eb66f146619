#include "robot_app/knowledge/understanding/intent_table.h"

#include <gmock/gmock.h>

#include <set>

#include "tests/robot_app/knowledge/language_files.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::knowledge {
namespace {

using testing::HasSubstr;

const IntentTable& Shipped() { return ShippedLanguageFiles().intents; }

std::string ProblemsOf(const std::string& text) {
  TemporaryFolder folder;
  coppice::WriteFile(folder.Path("intents.yaml"), text);
  Diagnostics diagnostics;
  LoadIntentTable(folder.Path("intents.yaml"), diagnostics);
  return diagnostics.ToString();
}

TEST(IntentTable, EveryIntentHasATouchPathAndSpokenExamples) {
  EXPECT_EQ(Shipped().size(), kIntents);
  for (const IntentRow& row : Shipped()) {
    EXPECT_FALSE(row.touch.empty()) << Word(row.intent);
    for (const Language language : kLanguages) {
      EXPECT_FALSE(In(language, row.examples).empty()) << Word(row.intent);
    }
  }
}

TEST(IntentTable, NoTwoIntentsAreBehindOneButton) {
  std::set<std::vector<std::string>> paths;
  for (const IntentRow& row : Shipped()) {
    EXPECT_TRUE(paths.insert(row.touch).second) << Word(row.intent);
  }
}

TEST(IntentTable, ARowWithoutTouchOrExampleIsAnError) {
  const std::string problems = ProblemsOf("intents: [{intent: help}]\n");
  EXPECT_THAT(problems, HasSubstr("expected a touch path"));
  EXPECT_THAT(problems, HasSubstr("expected examples in en"));
  EXPECT_THAT(problems, HasSubstr("there is no intent \"guide\""));
}

TEST(IntentTable, UnknownNamesAreErrorsWithTheNearestRightOne) {
  const std::string problems = ProblemsOf(
      "intents: [{intent: hepl, needs: [plaice], touch: [\"{persn}\"],\n"
      "           says: {en: {examples: [a]}, de: {examples: [b]}}}]\n");
  EXPECT_THAT(problems, HasSubstr("unknown intent \"hepl\" (did you mean \"help\"?)"));
  EXPECT_THAT(problems, HasSubstr("unknown slot \"plaice\" (did you mean \"place\"?)"));
  EXPECT_THAT(problems, HasSubstr("unknown slot \"persn\" (did you mean \"person\"?)"));
}

TEST(IntentTable, AnExampleTakesOpeningsByTheirName) {
  const std::string problems = ProblemsOf(
      "openings: {en: {ask: [do you know]}}\n"
      "intents: [{intent: help, touch: [help],\n"
      "           says: {en: {examples: [(aks) where]}, de: {examples: [b]}}}]\n");
  EXPECT_THAT(problems, HasSubstr("unknown opening \"aks\" (did you mean \"ask\"?)"));
}

// 30 000 of each in 700 kB would be 900 million sentences.
TEST(IntentTable, ExamplesAndOpeningsDoNotMultiplyWithoutEnd) {
  std::string openings, examples;
  for (int i = 0; i < 1000; ++i) {
    openings += "o" + std::to_string(i) + ", ";
    examples += "(ask) e" + std::to_string(i) + ", ";
  }
  const std::string problems = ProblemsOf(
      "openings: {en: {ask: [" + openings + "o]}}\n" + "intents: [{intent: help, touch: [help],\n" +
      "           says: {en: {examples: [" + examples + "a]}, de: {examples: [b]}}}]\n");
  EXPECT_THAT(problems, HasSubstr("3:"));
  EXPECT_THAT(problems, HasSubstr("multiply to too many sentences"));
}

}  // namespace
}  // namespace coppice::robot::knowledge
