#include "editor/theme/contrast.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

constexpr Color kBlack = 0xFF000000;
constexpr Color kWhite = 0xFFFFFFFF;

TEST(Contrast, IsThatOfWcag) {
  EXPECT_NEAR(Contrast(kBlack, kWhite), 21, 0.01);
  EXPECT_NEAR(Contrast(kWhite, kWhite), 1, 1e-9);
  EXPECT_NEAR(Contrast(0xFF777777, kWhite), 4.48, 0.01);
  EXPECT_NEAR(Contrast(0xFF0000FF, kWhite), 4.00, 0.01) << "red";
}

TEST(Contrast, MakesAColourReadableAndNoStrongerThanThat) {
  const Color grey = 0xFFAAAAAA;
  const Color readable = Readable(grey, kBlack, {kWhite});
  EXPECT_GE(Contrast(readable, kWhite), kReadable);
  EXPECT_LT(Contrast(readable, kWhite), kReadable + 1);
  EXPECT_EQ(Readable(kBlack, kBlack, {kWhite}), kBlack);
}

TEST(Contrast, KnowsWhichColoursTheColourBlindMixUp) {
  const Color red = 0xFF0033CC;
  const Color green = 0xFF338000;
  EXPECT_GT(Difference(red, green, Vision::kNormal), 100);
  EXPECT_LT(Difference(red, green, Vision::kDeuteranopia),
            Difference(red, green, Vision::kNormal) / 3);
  EXPECT_NEAR(Difference(kBlack, kWhite, Vision::kProtanopia), 100, 1);
  EXPECT_EQ(Difference(red, red, Vision::kTritanopia), 0);
}

}  // namespace
}  // namespace coppice::editor
