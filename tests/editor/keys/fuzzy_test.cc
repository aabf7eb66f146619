#include "editor/keys/fuzzy.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

TEST(Fuzzy, FindsLettersInOrderOnly) {
  EXPECT_GT(FuzzyScore("fs", "Fit selection"), 0);
  EXPECT_EQ(FuzzyScore("sf", "Fit all"), 0);
  EXPECT_EQ(FuzzyScore("xyz", "Fit all"), 0);
}

TEST(Fuzzy, IgnoresCaseAndBlanks) { EXPECT_GT(FuzzyScore("FIT all", "fitAll"), 0); }

TEST(Fuzzy, PrefersStartsOfWordsAndRuns) {
  EXPECT_GT(FuzzyScore("fs", "Fit selection"), FuzzyScore("fs", "offset list"));
  EXPECT_GT(FuzzyScore("open", "Open file"), FuzzyScore("open", "Collapse or open"));
  EXPECT_GT(FuzzyScore("dt", "DriveTo"), FuzzyScore("dt", "undulating"));
}

TEST(Fuzzy, WholeTextsGoBeforeWordsAndThoseBeforeBeginnings) {
  EXPECT_GT(FuzzyScore("wait", "Wait"), FuzzyScore("wait", "CancelWait"));
  EXPECT_GT(FuzzyScore("wait", "CancelWait"), FuzzyScore("wait", "Waiting"));
  EXPECT_GT(FuzzyScore("wait", "WaitingForEverythingElse"), FuzzyScore("wait", "NoWaiter"));
  EXPECT_GT(FuzzyScore("wait", "NoWaiter"), FuzzyScore("wait", "WalkIt"));
}

TEST(Fuzzy, FindsLettersThatAWordStartWouldSkip) { EXPECT_GT(FuzzyScore("at", "cat A"), 0); }

TEST(Fuzzy, FitsEverythingWhenNothingIsTyped) { EXPECT_EQ(FuzzyScore("", "anything"), 1); }

}  // namespace
}  // namespace coppice::editor
