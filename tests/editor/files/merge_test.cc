#include "editor/files/merge.h"

#include <gmock/gmock.h>

#include <random>

namespace coppice::editor {
namespace {

using testing::ElementsAre;

constexpr char kBefore[] = "<S>\n  <A x=\"1\" y=\"2\"/>\n  <B/>\n  <!-- c -->\n  <C/>\n</S>\n";

std::string With(std::string text, const std::string& what, const std::string& by) {
  text.replace(text.find(what), what.size(), by);
  return text;
}

TEST(Merge, ChangesOfDifferentPlacesAreBothThere) {
  const MergedText merged =
      MergeTexts(kBefore, With(kBefore, "<B/>", "<B/>\n  <New/>"), With(kBefore, "  <C/>\n", ""));
  EXPECT_TRUE(merged.conflicts.empty());
  EXPECT_EQ(merged.text, "<S>\n  <A x=\"1\" y=\"2\"/>\n  <B/>\n  <New/>\n  <!-- c -->\n</S>\n");
}

TEST(Merge, ChangesOfDifferentAttributesOfANodeAreBothThere) {
  const MergedText merged =
      MergeTexts(kBefore, With(kBefore, "x=\"1\"", "x=\"7\""), With(kBefore, "y=\"2\"", "y=\"8\""));
  EXPECT_TRUE(merged.conflicts.empty());
  EXPECT_THAT(merged.text, testing::HasSubstr(R"(<A x="7" y="8"/>)"));
}

TEST(Merge, WhereBothChangedTheSameMineStays) {
  const MergedText merged =
      MergeTexts(kBefore, With(kBefore, "x=\"1\"", "x=\"7\""), With(kBefore, "x=\"1\"", "x=\"8\""));
  EXPECT_THAT(merged.text, testing::HasSubstr(R"(<A x="7" y="2"/>)"));
  ASSERT_EQ(merged.conflicts.size(), 1U);
  EXPECT_EQ(merged.conflicts[0].mine, R"( x="7")");
  EXPECT_EQ(merged.conflicts[0].theirs, R"( x="8")");
  EXPECT_EQ(merged.text.substr(merged.conflicts[0].offset, 6), R"( x="7")");
}

TEST(Merge, TheSameChangeOfBothIsNoConflict) {
  const std::string both = With(kBefore, "<B/>", "<D/>");
  const MergedText merged = MergeTexts(kBefore, both, both);
  EXPECT_TRUE(merged.conflicts.empty());
  EXPECT_EQ(merged.text, both);
}

TEST(Merge, WithoutChangesOfOneSideItIsTheOther) {
  const std::string other = With(kBefore, "<B/>", "<D a='<'/>");
  EXPECT_EQ(MergeTexts(kBefore, kBefore, other).text, other);
  EXPECT_EQ(MergeTexts(kBefore, other, kBefore).text, other);
  EXPECT_EQ(MergeTexts("", "", "").text, "");
  EXPECT_EQ(MergeTexts("", "a", "").text, "a");
}

TEST(Merge, CutsATextIntoTagsAndAttributes) {
  EXPECT_THAT(
      XmlPieces("<?x?>\n<A b='>' c = \"/>\" /><!-- < -->t</A>"),
      ElementsAre("<?x?>", "\n", "<A", " b='>'", R"( c = "/>")", " />", "<!-- < -->", "t", "</A>"));
}

TEST(Merge, ThePiecesOfAnyTextAreTheText) {
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i) {
    std::string text;
    for (std::size_t n = random() % 30; n > 0; --n) text += "<>/=\"' aB!-?[]\n"[random() % 15];
    std::string together;
    for (const std::string_view piece : XmlPieces(text)) {
      EXPECT_FALSE(piece.empty());
      together += piece;
    }
    ASSERT_EQ(together, text);
  }
}

TEST(Merge, OfRandomTextsKeepsWhatOneSideAloneChanged) {
  std::mt19937 random(2);
  const auto any = [&] {
    std::string text;
    for (std::size_t n = random() % 12; n > 0; --n)
      text += "<" + std::string(1, "abc"[random() % 3]) + "/>";
    return text;
  };
  for (int i = 0; i < 3000; ++i) {
    const std::string before = any();
    const std::string one = any();
    ASSERT_EQ(MergeTexts(before, one, before).text, one);
    ASSERT_EQ(MergeTexts(before, before, one).text, one);
    ASSERT_EQ(MergeTexts(before, one, one).text, one);
  }
}

}  // namespace
}  // namespace coppice::editor
