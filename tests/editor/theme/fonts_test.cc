#include "editor/theme/fonts.h"

#include <gtest/gtest.h>

#include <string>

#include "editor/theme/icons.h"
#include "editor/theme/imgui_context.h"

namespace coppice::editor {
namespace {

class FontsTest : public testing::Test {
 protected:
  const Fonts fonts_{1};

  // Whether all faces of these fonts have a glyph of the text's first unusual character.
  static bool Have(const Fonts& fonts, const char* text) {
    const ImWchar code = *UnusualCharacters(text).begin();
    for (const Face face : {Face::kSans, Face::kBold, Face::kMono}) {
      if (!fonts.Pick(face, 13)->FindGlyphNoFallback(code)) return false;
    }
    return true;
  }
};

TEST_F(FontsTest, PicksTheLargestThatIsNotTooLarge) {
  ASSERT_EQ(fonts_.error(), "");
  EXPECT_EQ(fonts_.Pick(Face::kSans, 13)->FontSize, 13);
  EXPECT_EQ(fonts_.Pick(Face::kBold, 18.9F)->FontSize, 17);
  EXPECT_EQ(fonts_.Pick(Face::kMono, 2)->FontSize, 7);
  EXPECT_EQ(fonts_.Pick(Face::kMono, 500)->FontSize, 40);
}

TEST_F(FontsTest, HasAGlyphForEveryIcon) {
  for (const char* glyph :
       {icon::kSearch,       icon::kCheck,       icon::kTimes,     icon::kClock,
        icon::kRepeat,       icon::kRefresh,     icon::kPause,     icon::kStop,
        icon::kForward,      icon::kQuestion,    icon::kWarning,   icon::kFolder,
        icon::kFolderOpen,   icon::kCogs,        icon::kBolt,      icon::kSitemap,
        icon::kCircle,       icon::kCircleOpen,  icon::kCode,      icon::kShield,
        icon::kFileCode,     icon::kPlug,        icon::kHourglass, icon::kPlusSquare,
        icon::kMinusSquare,  icon::kExclamation, icon::kPin,       icon::kRightArrow,
        icon::kDoubleArrows, icon::kEllipsis,    icon::kMiddleDot, icon::kTimesSign,
        icon::kFork,         icon::kAngle}) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(glyph);
    const unsigned code =
        bytes[0] >= 0xE0 ? (bytes[0] & 0x0FU) << 12 | (bytes[1] & 0x3FU) << 6 | (bytes[2] & 0x3FU)
                         : (bytes[0] & 0x1FU) << 6 | (bytes[1] & 0x3FU);
    for (const Face face : {Face::kSans, Face::kBold}) {
      EXPECT_NE(fonts_.Pick(face, 13)->FindGlyphNoFallback(static_cast<ImWchar>(code)), nullptr)
          << std::hex << code;
    }
  }
}

TEST_F(FontsTest, SeveralContextsWriteWithThem) {
  ImGuiContext* const first = fonts_.MakeContext();
  ImGuiContext* const second = fonts_.MakeContext();
  {
    const WithContext current(second);
    EXPECT_EQ(ImGui::GetIO().FontDefault, fonts_.Pick(Face::kSans, 13));
    EXPECT_TRUE(ImGui::GetIO().Fonts->IsBuilt());
  }
  ImGui::DestroyContext(second);
  const WithContext current(first);
  EXPECT_EQ(ImGui::GetIO().Fonts->Fonts[0], fonts_.Pick(Face::kSans, 0)) << "the fonts live on";
  ImGui::DestroyContext(first);
}

TEST_F(FontsTest, NoteWhatIsWrittenAndNotBaked) {
  fonts_.For("Door? <a/> 100 %", Face::kSans, 13);
  fonts_.For(std::string("a") + icon::kEllipsis + icon::kMiddleDot + icon::kSearch, Face::kSans,
             13);
  EXPECT_EQ(fonts_.TakeLacking(), CharacterSet());
  fonts_.For("T\xC3\xBCr", Face::kSans, 13);
  EXPECT_EQ(fonts_.TakeLacking(), CharacterSet{0xFC});
  EXPECT_EQ(fonts_.TakeLacking(), CharacterSet()) << "they were taken";
}

TEST_F(FontsTest, NoteNothingTwiceThatNoFontHas) {
  const Fonts asked(1, {0x0F00});  // Tibetan
  EXPECT_EQ(asked.Pick(Face::kSans, 13)->FindGlyphNoFallback(0x0F00), nullptr);
  asked.For("\xE0\xBC\x80", Face::kSans, 13);
  EXPECT_EQ(asked.TakeLacking(), CharacterSet());
}

TEST_F(FontsTest, HaveTheLettersOfEuropeAndEastAsiaThatTheyAreAskedFor) {
  for (const char* text :
       {"\xC3\xBC", "\xCE\xB1", "\xD0\x96", "\xE6\x88\xBF", "\xE3\x81\x82", "\xED\x95\x9C"}) {
    EXPECT_FALSE(Have(fonts_, text)) << text;
    EXPECT_TRUE(Have(Fonts(1, UnusualCharacters(text)), text)) << text;
  }
}

TEST_F(FontsTest, EastAsianCharactersAreAsWideAsTwoLettersInEveryFace) {
  const Fonts fonts(1, {0x623F});
  for (const Face face : {Face::kSans, Face::kBold, Face::kMono}) {
    const ImFont& font = *fonts.Pick(face, 13);
    EXPECT_GT(font.GetCharAdvance(0x623F), 11);
    EXPECT_GT(font.GetCharAdvance(0x623F), font.FallbackAdvanceX);
  }
}

TEST_F(FontsTest, OfAWholeDictionaryBakeWhatThereIsRoomFor) {
  CharacterSet all;
  for (ImWchar code = 0x4E00; code < 0x9FA0; ++code) all.insert(code);
  const Fonts fonts(2, all);
  ASSERT_EQ(fonts.error(), "");
  EXPECT_NE(fonts.Pick(Face::kSans, 13)->FindGlyphNoFallback(0x4E00), nullptr);
  EXPECT_LE(fonts.Pick(Face::kSans, 13)->ContainerAtlas->TexHeight, 16384);
}

TEST(Fonts, OfUsualCharactersAreBakedIntoAMuchSmallerTexture) {
  const Fonts usual(1);
  const Fonts all(1, Alphabets());
  const auto rows = [](const Fonts& fonts) {
    return fonts.Pick(Face::kSans, 13)->ContainerAtlas->TexHeight;
  };
  EXPECT_LT(3 * rows(usual), 2 * rows(all));
}

TEST(Fonts, AreTwiceAsLargeOnAScreenWithTinyPixels) {
  const Fonts fonts(2);
  EXPECT_EQ(fonts.error(), "");
  EXPECT_EQ(fonts.Pick(Face::kSans, 26)->FontSize, 26);
}

}  // namespace
}  // namespace coppice::editor
