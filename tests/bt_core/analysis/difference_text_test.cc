#include "bt_core/analysis/difference_text.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

TEST(DifferenceText, TellsWhatANodeReturnedInBothRuns) {
  EXPECT_EQ(Sentence(RunDifference{"Drive", 1, 12, "SUCCESS", "FAILURE"}),
            R"(In tick 12, "Drive" returned SUCCESS here, but FAILURE there)");
}

TEST(DifferenceText, CountsTheTicksIfThereAreMore) {
  EXPECT_EQ(Sentence(RunDifference{"Drive", 3, 12, "not ticked", "RUNNING"}),
            R"(In tick 12, "Drive" was not ticked here, but returned RUNNING there; )"
            "it differs in 3 ticks");
}

TEST(DifferenceText, TellsTheValuesOfAKey) {
  EXPECT_EQ(Sentence(RunDifference{"Main{goal}", 1, 2, "= 1", "= 2"}),
            R"(In tick 2, key "goal" of "Main" became 1 here, but 2 there)");
  EXPECT_EQ(Sentence(RunDifference{"Main{goal}", 1, 2, "= 1", "not written"}),
            R"(In tick 2, key "goal" of "Main" became 1 here, but was not written there)");
}

PartingPoint Parting(const char* what, const char* second_what, const char* first,
                     const char* second) {
  PartingPoint point;
  point.tick = 4;
  point.what = what;
  point.second_what = second_what;
  point.first = first;
  point.second = second;
  return point;
}

TEST(DifferenceText, TellsWhereTheRunsPart) {
  EXPECT_EQ(Sentence(Parting("Drive", "", "SUCCESS", "FAILURE")),
            R"(The runs diverge in tick 4: "Drive" returned SUCCESS here, but FAILURE there)");
}

TEST(DifferenceText, TellsWhichRunDidSomethingElseFirst) {
  EXPECT_EQ(Sentence(Parting("Drive", "Dock", "SUCCESS", "FAILURE")),
            R"(The runs diverge in tick 4: here, "Drive" returned SUCCESS; )"
            R"(there, "Dock" returned FAILURE first)");
}

TEST(DifferenceText, TellsWhichTickHadEndedAlready) {
  EXPECT_EQ(
      Sentence(Parting("Drive", "", "nothing more", "FAILURE")),
      R"(The runs diverge in tick 4: there, "Drive" returned FAILURE; here, the tick had ended)");
  EXPECT_EQ(
      Sentence(Parting("Drive", "", "SUCCESS", "nothing more")),
      R"(The runs diverge in tick 4: here, "Drive" returned SUCCESS; there, the tick had ended)");
}

}  // namespace
}  // namespace coppice
