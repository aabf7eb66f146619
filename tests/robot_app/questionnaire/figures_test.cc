#include "robot_app/questionnaire/figures.h"

#include <gmock/gmock.h>

#include "tests/support/folders.h"

namespace coppice::robot::questionnaire {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

TEST(Median, IsTheMiddleOneOrTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(Median({5, 1, 3}), 3);
  EXPECT_EQ(Median({5, 1, 3, 4}), 3.5);
  EXPECT_EQ(Median({}), std::nullopt);
}

// By hand: the items' variances are 5/3 and 4/3, that of the sums 3, 4, 7, 8 is 17/3, so alpha is
// 2 * (1 - 3 / (17/3)) = 16/17.
TEST(CronbachAlpha, IsAsWorkedOutByHand) {
  EXPECT_NEAR(*CronbachAlpha({{1, 2}, {2, 2}, {3, 4}, {4, 4}}), 16.0 / 17, 1e-12);
}

TEST(CronbachAlpha, IsOneForItemsThatAgreeAndNegativeForThoseThatRunAgainstEachOther) {
  EXPECT_NEAR(*CronbachAlpha({{1, 1, 1}, {3, 3, 3}, {4, 4, 4}}), 1, 1e-12);
  EXPECT_LT(*CronbachAlpha({{1, 5}, {2, 3}, {5, 2}}), 0);
}

TEST(CronbachAlpha, IsUnknownWhereNothingDiffers) {
  EXPECT_EQ(CronbachAlpha({{3, 3}}), std::nullopt);
  EXPECT_EQ(CronbachAlpha({{3, 3}, {3, 3}}), std::nullopt);
  EXPECT_EQ(CronbachAlpha({{3}, {4}}), std::nullopt);
}

TEST(Figures, StandBesideThoseOfThePaper) {
  Diagnostics diagnostics;
  const Questionnaire godspeed =
      Questionnaire::Load(SourceFolder() + "/robot_app/questionnaire/godspeed.yaml", diagnostics);
  ASSERT_FALSE(diagnostics.has_errors()) << diagnostics.ToString();
  ASSERT_EQ(godspeed.Columns().size(), 24u);
  std::vector<Marks> people(3, Marks(24, 3));
  people[0][0] = 1;
  people[1][1] = 5;
  people[2][2] = 0;  // left out: not part of alpha
  const std::string text = FiguresText(godspeed, people);
  EXPECT_THAT(text, HasSubstr("3 people"));
  EXPECT_THAT(text, ContainsRegex("Anthropomorphism +-?[0-9.]+ +0.84 +3 3 3 3 3 +3.5 2.5 3 3 3"));
  EXPECT_THAT(text, ContainsRegex("Perceived Safety +- +-0.20 +3 3 3 +5 4 4"));
}

}  // namespace
}  // namespace coppice::robot::questionnaire
