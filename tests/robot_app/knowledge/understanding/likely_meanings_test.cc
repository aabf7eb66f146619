#include "robot_app/knowledge/understanding/likely_meanings.h"

#include <gmock/gmock.h>

#include "robot_app/knowledge/store/queries.h"
#include "tests/robot_app/knowledge/language_files.h"
#include "tests/robot_app/knowledge/sample_database.h"

namespace coppice::robot::knowledge {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

class LikelyMeaningsTest : public testing::Test {
 protected:
  std::vector<Meaning> Of(const std::vector<Alternative>& alternatives) {
    return LikelyMeanings(english_, alternatives);
  }
  std::vector<Request> Asked(const std::vector<Alternative>& alternatives) {
    return WorthAsking(Of(alternatives));
  }

  SampleDatabase sample_;
  const Understander english_{ShippedLanguageFiles().intents,
                              In(Language::kEnglish, ShippedLanguageFiles().words), Names(*sample_),
                              Language::kEnglish};
};

TEST_F(LikelyMeaningsTest, TextsThatMeanTheSameWinTogether) {
  const auto meanings = Of({{"goodbye", 3},
                            {"where is a reading room", 2},
                            {"where is the reading room", 2.5},
                            {"where the reading room is", 0.5}});
  ASSERT_THAT(meanings, SizeIs(2));
  EXPECT_EQ(meanings[0].text, "where is the reading room");
  EXPECT_DOUBLE_EQ(meanings[0].share, 5.0 / 8);
  EXPECT_EQ(meanings[1].text, "goodbye");
}

TEST_F(LikelyMeaningsTest, AnotherPlaceIsAnotherMeaning) {
  const auto meanings = Of({{"where is the reading room", 1}, {"where is the copy shop", 1.5}});
  EXPECT_EQ(meanings.at(0).text, "where is the copy shop");
  EXPECT_DOUBLE_EQ(meanings.at(0).share, 0.6);
}

TEST_F(LikelyMeaningsTest, WhatIsNotUnderstoodIsOneMeaning) {
  const auto meanings =
      Of({{"the moon was blue", 2}, {"where is the copy shop", 3}, {"them on was blue", 2}});
  EXPECT_EQ(meanings.at(0).text, "the moon was blue");
  EXPECT_DOUBLE_EQ(meanings.at(0).share, 4.0 / 7);
}

TEST_F(LikelyMeaningsTest, NothingMeansNothing) { EXPECT_THAT(Of({}), IsEmpty()); }

TEST_F(LikelyMeaningsTest, WhatIsSureOrTooUnlikelyIsNotAskedBack) {
  EXPECT_THAT(Asked({{"where is the copy shop", 9}, {"where is the reading room", 1}}), IsEmpty());
  EXPECT_THAT(Asked({{"the moon was blue", 6}, {"where is the copy shop", 3}, {"goodbye", 1}}),
              IsEmpty());
  EXPECT_THAT(Asked({}), IsEmpty());
}

TEST_F(LikelyMeaningsTest, WhatWasHardlyUnderstoodIsAskedBack) {
  EXPECT_THAT(Asked({{"the moon was blue", 5}, {"where is the copy shop", 4}, {"goodbye", 1}}),
              SizeIs(1));
}

// "What are the gun options for lunch" is no wish for lunch to be acted on: a word was heard wrong.
TEST_F(LikelyMeaningsTest, WhatLeavesWordsUnexplainedIsAskedBack) {
  const std::vector<Alternative> heard = {{"please take me to the copy shop banana", 9},
                                          {"goodbye", 0.1}};
  const auto meanings = Of(heard);
  EXPECT_EQ(meanings.at(0).understanding.request.intent, Intent::kGuide);
  EXPECT_GT(meanings[0].share, 0.98);
  EXPECT_NEAR(meanings[0].sure, 0.7, 0.02);
  EXPECT_THAT(Asked(heard), SizeIs(1));
  EXPECT_THAT(Asked({heard[0]}), IsEmpty()) << "that is how it was said";
}

TEST_F(LikelyMeaningsTest, WhatLeavesWordsUnexplainedMakesNothingElseLikelier) {
  const std::vector<Alternative> heard = {
      {"please take me to the copy shop banana", 4}, {"the moon was blue", 4.5}, {"goodbye", 1.5}};
  EXPECT_DOUBLE_EQ(Of(heard).at(1).share, 0.4);
  EXPECT_THAT(Asked(heard), SizeIs(1)) << "as before";
}

TEST_F(LikelyMeaningsTest, TheTwoLikeliestAreAskedBack) {
  const auto asked = Asked({{"where is the copy shop", 4},
                            {"when does the copy shop close", 3},
                            {"goodbye", 2},
                            {"where is the reading room", 1}});
  ASSERT_THAT(asked, SizeIs(2));
  EXPECT_EQ(asked[0].intent, Intent::kFindPlace);
  EXPECT_EQ(asked[1].intent, Intent::kOpeningHours);
}

TEST_F(LikelyMeaningsTest, OfAnAmbiguousNameBothAreAskedBack) {
  const auto asked =
      Asked({{"where is the office of Weber", 5}, {"the moon was blue", 4}, {"goodbye", 1}});
  ASSERT_THAT(asked, SizeIs(2));
  EXPECT_EQ(asked[0].slots.at(0).subject, "anna_weber");
  EXPECT_EQ(asked[1].slots.at(0).subject, "paul_weber");
}

}  // namespace
}  // namespace coppice::robot::knowledge
