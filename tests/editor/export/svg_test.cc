#include "editor/export/svg.h"

#include <gtest/gtest.h>

#include "bt_core/model/document.h"
#include "tests/editor/export/painted.h"
#include "tests/editor/shared_fonts.h"

namespace coppice::editor {
namespace {

std::string SvgOf(const std::string& xml) {
  PictureMaker maker(1, SharedFonts(1));
  return ToSvg(maker.Draw(Painted(xml).painting), Glyphs());
}

TEST(Svg, IsWellFormedWhateverTheTextsAre) {
  const std::string svg = SvgOf(
      "<A><B name='&lt;&amp;&quot;>' x='a&#9;b&#10;c'/><C name='größer ≥ \xF0\x9F\x98\x80'/></A>");
  Diagnostics diagnostics;
  const auto document = Document::FromText(svg, "tree.svg", diagnostics);
  ASSERT_TRUE(document) << diagnostics.ToString();
  EXPECT_EQ(document->element(kRootElement).tag, "svg");
  EXPECT_EQ(document->AttributeValue(document->element(kRootElement), "xmlns"),
            "http://www.w3.org/2000/svg");
}

TEST(Svg, KeepsTextsAsTextsAndIconsAsOutlines) {
  const std::string svg = SvgOf("<Sequence><Open door='{door}'/></Sequence>");
  EXPECT_EQ(CountOf(svg, ">Sequence</text>"), 1U);
  EXPECT_EQ(CountOf(svg, ">{door}</text>"), 1U);
  EXPECT_GT(CountOf(svg, "<path d=\"M"), 0U);
  EXPECT_EQ(CountOf(svg, "FontAwesome"), 0U);
}

TEST(Svg, OpensAndClosesItsClips) {
  const std::string svg = SvgOf("<A><B x='1'/></A>");
  EXPECT_GT(CountOf(svg, "<g clip-path"), 0U);
  EXPECT_EQ(CountOf(svg, "<g clip-path"), CountOf(svg, "</g>"));
}

TEST(Svg, WritesEachKindOfShape) {
  Drawing drawing;
  drawing.size = {100, 50};
  const auto item = [&](DrawnItem::Kind kind, std::vector<Point> points, Color color, float size) {
    drawing.items.push_back({kind, std::move(points), color, size, {}, Face::kSans, 0});
  };
  item(DrawnItem::Kind::kFill, {{0, 0}, {1, 0}, {0, 1}}, 0xFF0000FF, 0);
  item(DrawnItem::Kind::kCurve, {{0, 0}, {1, 0}, {0, 1}, {2, 2}}, 0x80FF0000, 2);
  item(DrawnItem::Kind::kDisc, {{5, 6}}, 0xFF00FF00, 3);
  item(DrawnItem::Kind::kBox, {{1, 2}, {11, 22}}, 0xFFFFFFFF, 4);
  const std::string svg = ToSvg(drawing, Glyphs());
  EXPECT_NE(svg.find(R"(viewBox="0 0 100 50")"), std::string::npos);
  EXPECT_NE(svg.find(R"(<polygon points="0 0 1 0 0 1" fill="#ff0000"/>)"), std::string::npos);
  EXPECT_NE(svg.find(R"(stroke="#0000ff" stroke-opacity="0.5")"), std::string::npos);
  EXPECT_NE(svg.find(R"(<circle cx="5" cy="6" r="3")"), std::string::npos);
  EXPECT_NE(svg.find(R"(<rect x="1" y="2" width="10" height="20" rx="4")"), std::string::npos);
}

}  // namespace
}  // namespace coppice::editor
