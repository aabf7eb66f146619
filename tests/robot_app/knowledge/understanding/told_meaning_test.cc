#include "robot_app/knowledge/understanding/told_meaning.h"

#include <gmock/gmock.h>

#include "robot_app/knowledge/store/queries.h"
#include "tests/robot_app/knowledge/language_files.h"
#include "tests/robot_app/knowledge/sample_database.h"

namespace coppice::robot::knowledge {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class ToldMeaningTest : public testing::Test {
 protected:
  std::optional<Understanding> Checked(std::optional<Intent> intent,
                                       std::vector<NamedSlot> slots = {}) {
    return CheckedMeaning({intent, std::move(slots)}, ShippedLanguageFiles().intents, english_);
  }

  SampleDatabase sample_;
  const Understander english_{ShippedLanguageFiles().intents,
                              In(Language::kEnglish, ShippedLanguageFiles().words), Names(*sample_),
                              Language::kEnglish};
};

TEST_F(ToldMeaningTest, NamesAreFoundAsIfTheyHadBeenTyped) {
  const auto meant = Checked(Intent::kGuide, {{Kind::kPlace, "the libary"}});
  ASSERT_TRUE(meant);
  EXPECT_EQ(meant->verdict, Verdict::kUnderstood);
  EXPECT_EQ(meant->request, (Request{Intent::kGuide, {{Kind::kPlace, "library"}}}));
}

TEST_F(ToldMeaningTest, WhatIsNeededComesFirst) {
  const auto meant =
      Checked(Intent::kOpeningHours, {{Kind::kDay, "tomorrow"}, {Kind::kPlace, "library"}});
  ASSERT_TRUE(meant);
  EXPECT_THAT(meant->request.slots,
              ElementsAre(Slot{Kind::kPlace, "library"}, Slot{Kind::kDay, "tomorrow"}));
}

TEST_F(ToldMeaningTest, ANameOfTwoIsAmbiguousAndOneThatWasNotToldIsMissing) {
  const auto ambiguous = Checked(Intent::kFindPerson, {{Kind::kPerson, "Weber"}});
  ASSERT_TRUE(ambiguous);
  EXPECT_EQ(ambiguous->verdict, Verdict::kAmbiguous);
  EXPECT_THAT(ambiguous->choices,
              ElementsAre(Slot{Kind::kPerson, "anna_weber"}, Slot{Kind::kPerson, "paul_weber"}));
  EXPECT_EQ(Checked(Intent::kGuide)->verdict, Verdict::kMissing);
}

TEST_F(ToldMeaningTest, NoIntentIsNotUnderstood) {
  const auto meant = Checked(std::nullopt, {{Kind::kPlace, "library"}});
  ASSERT_TRUE(meant);
  EXPECT_EQ(meant->verdict, Verdict::kUnknown);
  EXPECT_THAT(meant->request.slots, IsEmpty());
}

TEST_F(ToldMeaningTest, WhatDoesNotFitIsNothing) {
  EXPECT_FALSE(Checked(Intent::kGuide, {{Kind::kPlace, "the moon"}})) << "a name of nobody";
  EXPECT_FALSE(Checked(Intent::kGuide, {{Kind::kPlace, ""}}));
  EXPECT_FALSE(Checked(Intent::kHelp, {{Kind::kPlace, "library"}})) << "a slot it does not take";
  EXPECT_FALSE(Checked(Intent::kGuide, {{Kind::kPlace, "library"}, {Kind::kPlace, "gym"}}));
  EXPECT_FALSE(Checked(Intent::kGuide, {{Kind::kPlace, "gym"}, {Kind::kPerson, "Anna Weber"}}));
}

}  // namespace
}  // namespace coppice::robot::knowledge
