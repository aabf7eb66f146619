#include "editor/theme/scale.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::editor {
namespace {

TEST(Scale, IsThatOfTheScreenUntilOneIsChosen) {
  EXPECT_EQ(ShownScale(kScaleOfScreen, 1.6F), 1.6F);
  EXPECT_EQ(ShownScale(2, 1.6F), 2);
}

TEST(Scale, GoesToTheNextOneAndStaysAtTheLast) {
  EXPECT_EQ(NextScale(1, 1), 1.25F);
  EXPECT_EQ(NextScale(1, -1), 0.75F);
  EXPECT_EQ(NextScale(1.6F, 1), 1.75F) << "from between two of them";
  EXPECT_EQ(NextScale(1.6F, -1), 1.5F);
  EXPECT_EQ(NextScale(3, 1), 3);
  EXPECT_EQ(NextScale(0.75F, -1), 0.75F);
}

TEST(Scale, IsOneThatCanBeChosenWhateverWasKept) {
  EXPECT_EQ(NearestScale(1.45F), 1.5F);
  EXPECT_EQ(NearestScale(900), 3);
  EXPECT_EQ(NearestScale(0), kScaleOfScreen);
  EXPECT_EQ(NearestScale(-1), kScaleOfScreen);
  EXPECT_EQ(NearestScale(std::nanf("")), kScaleOfScreen);
}

}  // namespace
}  // namespace coppice::editor
