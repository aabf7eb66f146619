#include "robot_app/expression/wishes.h"

#include <gtest/gtest.h>

namespace coppice::robot::expression {
namespace {

TEST(Wishes, NobodyWantsAnything) { EXPECT_EQ(Wishes().Shown(0), Expression::NEUTRAL); }

TEST(Wishes, TheMostImportantIsShown) {
  Wishes wishes;
  wishes.Want("trees", Expression::GUIDING, 0, 10);
  wishes.Want("tablet", Expression::LISTENING, 0, 10);
  wishes.Want("answer", Expression::SAD, 0, 10);
  EXPECT_EQ(wishes.Shown(1), Expression::LISTENING);
  wishes.Withdraw("tablet");
  EXPECT_EQ(wishes.Shown(1), Expression::SAD);
}

TEST(Wishes, ANewWishTakesThePlaceOfTheOneBeforeIt) {
  Wishes wishes;
  wishes.Want("tablet", Expression::LISTENING, 0, 10);
  wishes.Want("tablet", Expression::NEUTRAL, 1, 10);
  EXPECT_EQ(wishes.Shown(2), Expression::NEUTRAL);
}

TEST(Wishes, WhatIsNotSaidAgainIsForgotten) {
  Wishes wishes;
  wishes.Want("tablet", Expression::LISTENING, 0, 3);
  EXPECT_EQ(wishes.Shown(2.9), Expression::LISTENING);
  EXPECT_EQ(wishes.Shown(3.1), Expression::NEUTRAL);
}

TEST(Wishes, TreesThatFallSilentAreAnErrorUntilTheyAreBack) {
  Wishes wishes;
  wishes.Want(kTrees, Expression::SLEEP, 0, 3);
  EXPECT_EQ(wishes.Shown(4), Expression::ERROR);
  wishes.Want(kTrees, Expression::SLEEP, 5, 3);
  EXPECT_EQ(wishes.Shown(5), Expression::SLEEP);
}

TEST(Wishes, AFloodOfOwnersTakesNoMemory) {
  Wishes wishes;
  wishes.Want(kTrees, Expression::GREETING, 0, 10);
  for (int i = 0; i < 1000; ++i) wishes.Want(std::to_string(i), Expression::NEUTRAL, 0, 10);
  wishes.Want("late", Expression::SAD, 0, 10);
  EXPECT_EQ(wishes.Shown(1), Expression::GREETING);
}

}  // namespace
}  // namespace coppice::robot::expression
