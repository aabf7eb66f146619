#include "bt_core/model/layout.h"

#include "tests/bt_core/model/edited.h"

namespace coppice {
namespace {

TEST(Layout, LineEndsAreThoseOfTheLineBefore) {
  EXPECT_EQ(LineEndAt("a\r\nb\nc", 3), "\r\n");
  EXPECT_EQ(LineEndAt("a\r\nb\nc", 5), "\n");
  EXPECT_EQ(LineEndAt("a\r\nb", 0), "\r\n");
  EXPECT_EQ(LineEndAt("abc", 1), "\n");
  EXPECT_EQ(LineEndAt("", 0), "\n");
}

TEST(Layout, IndentationIsWhatStandsBeforeTheFirstThingOfALine) {
  EXPECT_EQ(IndentationAt("a\n \t<b/>", 4), " \t");
  EXPECT_EQ(IndentationAt("a\r\n<b/>", 3), "");
  EXPECT_EQ(IndentationAt("<b/>", 0), "");
  EXPECT_EQ(IndentationAt("a\n <b/><c/>", 7), std::nullopt);
}

TEST(Layout, TheStepIsThatOfTheNearestElements) {
  const Document document = Parsed("<a>\n <b>\n    <c/>\n </b>\n <d/>\n</a>");
  EXPECT_EQ(IndentationStep(document, Find(document, "b")), "   ") << "its children";
  EXPECT_EQ(IndentationStep(document, Find(document, "d")), " ") << "itself";
  EXPECT_EQ(IndentationStep(Parsed("<a><b/></a>"), ElementIndex{1}), "  ") << "nothing to follow";
  const Document odd = Parsed("<a>\n\t<b/>\n<c><d/></c></a>");
  EXPECT_EQ(IndentationStep(odd, Find(odd, "c")), "\t") << "the first of the file";
}

TEST(Layout, FindsTheEndTag) {
  const std::string text = "<a><b></b><!-- </a> --></a >";
  const Document document = Parsed(text);
  EXPECT_EQ(EndTagOffset(document, document.element(kRootElement)), text.rfind("</a"));
  EXPECT_EQ(EndTagOffset(document, document.element(ElementIndex{1})), text.find("</b"));
}

TEST(Layout, ReindentingLeavesValuesAlone) {
  EXPECT_EQ(
      Reindent("<a x='1\n  2'\n  y='3'>\n\n    <b/>\n  <![CDATA[\n  ]]>\n</a>", "  ", "\t", "\r\n"),
      "<a x='1\n  2'\r\n\ty='3'>\r\n\r\n\t  <b/>\r\n\t<![CDATA[\n  ]]>\r\n\t</a>");
}

}  // namespace
}  // namespace coppice
