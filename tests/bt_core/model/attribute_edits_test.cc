#include "bt_core/model/attribute_edits.h"

#include "tests/bt_core/model/edited.h"

namespace coppice {
namespace {

std::string Set(const std::string& text, std::string_view name, std::string_view value) {
  const Document document = Parsed(text);
  std::string after = After(document, SetAttribute(document, kRootElement, name, value));
  EXPECT_EQ(Parsed(after).AttributeValue(Parsed(after).element(kRootElement), name), value);
  return after;
}
std::string Remove(const std::string& text, std::string_view name) {
  const Document document = Parsed(text);
  return After(document, RemoveAttribute(document, kRootElement, name));
}

TEST(SetAttribute, ReplacesNothingButTheValue) {
  EXPECT_EQ(Set("<a  x = '1'\ty=\"2\" ><!-- c --></a>\r\n", "x", "3"),
            "<a  x = '3'\ty=\"2\" ><!-- c --></a>\r\n");
}

TEST(SetAttribute, TheSameValueIsNoEdit) {
  const Document document = Parsed("<a x='&lt;'/>");
  EXPECT_TRUE(SetAttribute(document, kRootElement, "x", "<").empty());
}

TEST(SetAttribute, EscapesForTheQuoteInUse) {
  EXPECT_EQ(Set("<a x='1'/>", "x", R"("a" < 'b' && c)"),
            R"(<a x='"a" &lt; &apos;b&apos; &amp;&amp; c'/>)");
  EXPECT_EQ(Set(R"(<a x="1"/>)", "x", R"("a" 'b')"), R"(<a x="&quot;a&quot; 'b'"/>)");
}

TEST(SetAttribute, ANewAttributeComesLastInTheStyleOfTheOthers) {
  EXPECT_EQ(Set("<a/>", "x", "1"), R"(<a x="1"/>)");
  EXPECT_EQ(Set("<a />", "x", "1"), R"(<a x="1" />)");
  EXPECT_EQ(Set("<a></a>", "x", "1"), R"(<a x="1"></a>)");
  EXPECT_EQ(Set("<a y='2'/>", "x", "it's"), "<a y='2' x='it&apos;s'/>");
}

TEST(SetAttribute, ANewAttributeStandsOnItsOwnLineIfTheLastOneDoes) {
  EXPECT_EQ(Set("<a y='2'\r\n   z='3'/>", "x", "1"), "<a y='2'\r\n   z='3'\r\n   x='1'/>");
}

TEST(SetAttribute, ScriptsKeepTheirLines) {
  EXPECT_EQ(Set("<a x='1;\r\n  2'/>", "x", "1;\n  3;\n4"), "<a x='1;\r\n  3;\r\n4'/>");
  EXPECT_EQ(Set("<a x='1'/>", "x", "1;\n2"), "<a x='1;&#10;2'/>");
}

TEST(RemoveAttribute, TakesTheBlanksBeforeIt) {
  EXPECT_EQ(Remove("<a x='1' y='2'  z='3'/>", "y"), "<a x='1'  z='3'/>");
  EXPECT_EQ(Remove("<a x='1' y='2'/>", "x"), "<a y='2'/>");
  EXPECT_EQ(Remove("<a x='1'/>", "x"), "<a/>");
  EXPECT_EQ(Remove("<a x='1' />", "x"), "<a />");
  EXPECT_EQ(Remove("<a x='1'\n   y='2'\n   z='3'>\n</a>", "y"), "<a x='1'\n   z='3'>\n</a>");
}

TEST(RemoveAttribute, AttributesThatTouchStayApartFromTheTag) {
  EXPECT_EQ(Remove("<a x='1'y='2'/>", "x"), "<a y='2'/>");
  EXPECT_EQ(Remove("<a x='1'y='2'/>", "y"), "<a x='1'/>");
}

TEST(RemoveAttribute, WithoutTheAttributeThereIsNothingToDo) {
  EXPECT_TRUE(RemoveAttribute(Parsed("<a/>"), kRootElement, "x").empty());
}

TEST(RenameAttribute, KeepsPlaceAndValue) {
  const Document document = Parsed("<a x = '&lt;' y='2'/>");
  EXPECT_EQ(After(document, RenameAttribute(document, kRootElement, "x", "long")),
            "<a long = '&lt;' y='2'/>");
  EXPECT_TRUE(RenameAttribute(document, kRootElement, "no", "z").empty());
  EXPECT_TRUE(RenameAttribute(document, kRootElement, "x", "x").empty());
}

}  // namespace
}  // namespace coppice
