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

TEST_F(FontsTest, LackNothingIfTheyHaveAllCharacters) {
  EXPECT_FALSE(fonts_.Lacks("T\xC3\xBCr"));
  EXPECT_NE(fonts_.Pick(Face::kSans, 13)->FindGlyphNoFallback(0xFC), nullptr);
}

TEST(Fonts, OfUsualCharactersTellThatATextHasAnother) {
  const Fonts fonts(1, Characters::kUsual);
  ASSERT_EQ(fonts.error(), "");
  EXPECT_FALSE(fonts.Lacks("Door? <a/> 100 %"));
  EXPECT_FALSE(fonts.Lacks(std::string("a") + icon::kEllipsis + icon::kMiddleDot + icon::kSearch));
  EXPECT_TRUE(fonts.Lacks("T\xC3\xBCr"));
}

TEST(Fonts, DoNotLackWhatNoFontHas) {
  const Fonts fonts(1, Characters::kUsual);
  for (const char* text : {"\xE6\x88\xBF", "\xF0\x9F\x9A\xAA", "cut off: \xC3"}) {
    EXPECT_FALSE(fonts.Lacks(text)) << text;
  }
}

TEST(Fonts, OfUsualCharactersAndThoseOfATextLackNothingOfIt) {
  const std::string text = "T\xC3\xBCr \xE6\x88\xBF, T\xC3\xBCr";
  EXPECT_EQ(UnusualCharacters(text), std::vector<ImWchar>{0xFC});
  const Fonts fonts(1, Characters::kUsual, UnusualCharacters(text));
  EXPECT_FALSE(fonts.Lacks(text));
  EXPECT_TRUE(fonts.Lacks("\xC3\xA9"));
}

TEST(Fonts, OfUsualCharactersAreBakedIntoAMuchSmallerTexture) {
  const Fonts usual(1, Characters::kUsual);
  const Fonts all(1);
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
