#include "robot_app/knowledge/understanding/likeliest_meaning.h"

#include <gtest/gtest.h>

#include "robot_app/knowledge/store/queries.h"
#include "tests/robot_app/knowledge/language_files.h"
#include "tests/robot_app/knowledge/sample_database.h"

namespace coppice::robot::knowledge {
namespace {

class LikeliestMeaningTest : public testing::Test {
 protected:
  LikelyText Of(const std::vector<Alternative>& alternatives) {
    return LikeliestMeaning(english_, alternatives);
  }

  SampleDatabase sample_;
  const Understander english_{ShippedLanguageFiles().intents,
                              In(Language::kEnglish, ShippedLanguageFiles().words), Names(*sample_),
                              Language::kEnglish};
};

TEST_F(LikeliestMeaningTest, TextsThatMeanTheSameWinTogether) {
  const LikelyText likely = Of({{"goodbye", 3},
                                {"where is a reading room", 2},
                                {"where is the reading room", 2.5},
                                {"where the reading room is", 0.5}});
  EXPECT_EQ(likely.text, "where is the reading room");
  EXPECT_DOUBLE_EQ(likely.share, 5.0 / 8);
}

TEST_F(LikeliestMeaningTest, AnotherPlaceIsAnotherMeaning) {
  const LikelyText likely = Of({{"where is the reading room", 1}, {"where is the copy shop", 1.5}});
  EXPECT_EQ(likely.text, "where is the copy shop");
  EXPECT_DOUBLE_EQ(likely.share, 0.6);
}

TEST_F(LikeliestMeaningTest, WhatIsNotUnderstoodIsOneMeaning) {
  const LikelyText likely =
      Of({{"the moon was blue", 2}, {"where is the copy shop", 3}, {"them on was blue", 2}});
  EXPECT_EQ(likely.text, "the moon was blue");
  EXPECT_DOUBLE_EQ(likely.share, 4.0 / 7);
}

TEST_F(LikeliestMeaningTest, NothingMeansNothing) {
  EXPECT_EQ(Of({}).text, "");
  EXPECT_EQ(Of({}).share, 0);
}

}  // namespace
}  // namespace coppice::robot::knowledge
