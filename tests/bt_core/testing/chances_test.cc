#include "bt_core/testing/chances.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coppice {
namespace {

using std::chrono::milliseconds;

TEST(Chances, TheSameSeedAndNameGiveTheSameNumbersOnEveryComputer) {
  Dice dice(7, "drive");
  Dice same(7, "drive");
  Dice other(7, "dock");
  const double first = dice.Next();
  EXPECT_EQ(first, same.Next());
  EXPECT_NE(first, other.Next());
  EXPECT_NE(first, Dice(8, "drive").Next());
  EXPECT_NEAR(first, 0.3233679, 5e-8);
}

TEST(Chances, ResultsComeInTheirProportions) {
  const Chances chances{6, 3, 1, Duration(0), Duration(0)};
  Dice dice(1, "");
  int counts[5] = {};
  for (int i = 0; i < 10000; ++i) ++counts[static_cast<int>(Throw(chances, dice).result)];
  EXPECT_NEAR(counts[static_cast<int>(Status::kSuccess)], 6000, 200);
  EXPECT_NEAR(counts[static_cast<int>(Status::kFailure)], 3000, 200);
  EXPECT_NEAR(counts[static_cast<int>(Status::kSkipped)], 1000, 200);
}

TEST(Chances, TimesLieWithinTheRangeAndReachItsEnds) {
  const Chances chances{1, 0, 0, milliseconds(100), milliseconds(300)};
  Dice dice(1, "");
  Duration shortest = std::chrono::hours(1);
  Duration longest{0};
  for (int i = 0; i < 1000; ++i) {
    const DrawnResult outcome = Throw(chances, dice);
    EXPECT_EQ(outcome.result, Status::kSuccess);
    shortest = std::min(shortest, outcome.after);
    longest = std::max(longest, outcome.after);
  }
  EXPECT_GE(shortest, milliseconds(100));
  EXPECT_LT(shortest, milliseconds(105));
  EXPECT_LE(longest, milliseconds(300));
  EXPECT_GT(longest, milliseconds(295));
}

TEST(Chances, WhoSkipsDoesSoAtOnce) {
  Dice dice(1, "");
  const DrawnResult outcome = Throw({0, 0, 1, milliseconds(100), milliseconds(300)}, dice);
  EXPECT_EQ(outcome.result, Status::kSkipped);
  EXPECT_EQ(outcome.after, Duration(0));
}

TEST(Chances, AnOutcomeMayHoldForSomeTime) {
  const Chances chances{1, 1, 0, Duration(0), Duration(0), milliseconds(100), milliseconds(300)};
  Dice dice(1, "");
  Duration longest{0};
  for (int i = 0; i < 1000; ++i) {
    const DrawnResult outcome = Throw(chances, dice);
    EXPECT_GE(outcome.holds, milliseconds(100));
    longest = std::max(longest, outcome.holds);
  }
  EXPECT_LE(longest, milliseconds(300));
  EXPECT_GT(longest, milliseconds(295));
}

TEST(Chances, OneElementIsAsProbableAsAnother) {
  Dice dice(3, "");
  const std::vector<int> list = {0, 1, 2};
  int counts[3] = {};
  for (int i = 0; i < 3000; ++i) ++counts[ChooseOne(list, dice)];
  for (const int count : counts) EXPECT_NEAR(count, 1000, 100);
}

}  // namespace
}  // namespace coppice
