#include "editor/theme/growing_fonts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace coppice::editor {
namespace {

class GrowingFontsTest : public testing::Test {
 protected:
  // What a frame at that time does.
  bool Write(const char* text, double now) {
    fonts_->For(text, Face::kSans, 13);
    return fonts_.AreLacking(now);
  }
  bool Fit(float scale, double now) { return fonts_.Fit(scale, now).value(); }

  GrowingFonts fonts_{nullptr, 1};
};

TEST_F(GrowingFontsTest, StayAsTheyAreForUsualTexts) {
  EXPECT_FALSE(Write("Door", 0));
  EXPECT_FALSE(Fit(1, 0));
  EXPECT_TRUE(std::isinf(fonts_.NextBakeIn(0)));
}

TEST_F(GrowingFontsTest, BakeTheAlphabetOfALetterThatWasWritten) {
  EXPECT_TRUE(Write("\xD0\x96", 0));
  EXPECT_TRUE(Fit(1, 0));
  EXPECT_EQ(fonts_->more().count(0x0436), 1U);
  EXPECT_FALSE(Write("\xD0\x96", 0));
}

TEST_F(GrowingFontsTest, BakeWhatATextNeedsBeforeItIsWritten) {
  fonts_.Expect("\xE6\x88\xBF");
  EXPECT_TRUE(Fit(1, 0));
  EXPECT_FALSE(Write("\xE6\x88\xBF", 0));
}

TEST_F(GrowingFontsTest, BakeNothingTwiceForAWindowThatHasBakedWhatItsFilesNeed) {
  const std::string text = "T\xC3\xBCr \xE6\x88\xBF";
  GrowingFonts fonts(std::make_shared<const Fonts>(1, UnusualCharacters(text)), 1);
  fonts.Expect(text);
  fonts->For(text, Face::kSans, 13);
  EXPECT_FALSE(fonts.AreLacking(0));
  EXPECT_FALSE(*fonts.Fit(1, 0));
}

TEST_F(GrowingFontsTest, BakeOnceASecondWhateverARobotSends) {
  Write("\xE6\x88\xBF", 5);
  ASSERT_TRUE(Fit(1, 5));
  EXPECT_FALSE(Write("\xE6\x88\xB8", 5.5));
  EXPECT_DOUBLE_EQ(fonts_.NextBakeIn(5.5), 0.5);
  EXPECT_FALSE(Fit(1, 5.5));
  EXPECT_TRUE(Fit(1, 6));
  EXPECT_EQ(fonts_->more().size(), 2U);
}

TEST_F(GrowingFontsTest, AnotherScaleKeepsTheCharacters) {
  Write("\xE6\x88\xBF", 0);
  ASSERT_TRUE(Fit(1, 0));
  EXPECT_TRUE(Fit(2, 0.1));
  EXPECT_EQ(fonts_->scale(), 2);
  EXPECT_EQ(fonts_->more().count(0x623F), 1U);
}

TEST(GrowingFonts, TakeTheGivenOnesAgainWhenTheyFit) {
  const auto given = std::make_shared<const Fonts>(1, Alphabets());
  GrowingFonts fonts(given, 1);
  EXPECT_TRUE(*fonts.Fit(1.5F, 0));
  EXPECT_TRUE(*fonts.Fit(1, 0));
  EXPECT_EQ(&*fonts, given.get());
}

}  // namespace
}  // namespace coppice::editor
