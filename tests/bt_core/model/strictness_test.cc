#include "bt_core/model/strictness.h"

#include "tests/bt_core/model/edited.h"

namespace coppice {
namespace {

std::string Warnings(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_TRUE(Document::FromText(text, "t.xml", diagnostics)) << diagnostics.ToString();
  EXPECT_FALSE(diagnostics.has_errors());
  return diagnostics.ToString();
}

// The strict text: of the same meaning, and without warnings.
std::string Strict(const std::string& text) {
  const Document document = Parsed(text);
  std::string strict = After(document, StrictXmlEdit(document));
  EXPECT_EQ(Warnings(strict), "");
  const Document after = Parsed(strict);
  EXPECT_EQ(after.elements().size(), document.elements().size());
  for (ElementIndex i{0}; i < after.elements().size(); ++i) {
    const Element& a = after.element(i);
    EXPECT_EQ(a.tag, document.element(i).tag);
    for (const Attribute* x = after.attributes_begin(a); x != after.attributes_end(a); ++x) {
      EXPECT_EQ(x->value, document.AttributeValue(document.element(i), x->name));
    }
  }
  return strict;
}

TEST(Strictness, StrictXmlIsLeftAlone) {
  const std::string text =
      "\xEF\xBB\xBF<?xml version=\"1.0\"?>\n<!-- a-b - c -->\n<a x='&lt;&#65; > \"' y=\"'\">"
      "&amp; words > <![CDATA[ && < ]]><b></b ></a>\n";
  EXPECT_EQ(Warnings(text), "");
  EXPECT_TRUE(StrictXmlEdit(Parsed(text)).empty());
}

TEST(Strictness, MendsAmpersandsAndLessThanInValues) {
  EXPECT_EQ(Strict(R"(<a x='a &lt; 3 && b' y="<;0.5">b & c</a>)"),
            R"(<a x='a &lt; 3 &amp;&amp; b' y="&lt;;0.5">b &amp; c</a>)");
}

TEST(Strictness, MendsDashesInComments) {
  EXPECT_EQ(Strict("<!-------><a/><!-- ---- title ---- --><!-- x --->"),
            "<!--===--><a/><!-- ==== title ==== --><!-- x =-->");
}

TEST(Strictness, MendsALateDeclaration) {
  EXPECT_EQ(Strict("\n  <?xml version='1.0'?><a/>"), "<?xml version='1.0'?><a/>");
  EXPECT_EQ(Strict("\xEF\xBB\xBF\n<?xml version='1.0'?><a/>"),
            "\xEF\xBB\xBF<?xml version='1.0'?><a/>");
}

TEST(Strictness, MendsTags) {
  EXPECT_EQ(Strict("< a x='1'y='2'><b></b z='>'>< /a>"), "<a x='1' y='2'><b></b></a>");
}

TEST(Strictness, WarnsOncePerKindAtTheFirstPlace) {
  EXPECT_EQ(Warnings("<a x='a && b'>\n<b y='c & d'/>\n<!-- -- --></a>"),
            "t.xml:1:9: warning: '&' stands for itself; strict XML parsers refuse it "
            "(write &amp;; 2 more in this file)\n"
            "t.xml:3:6: warning: \"--\" in a comment; strict XML parsers refuse it (write =)\n");
}

TEST(Strictness, BytesThatAreNoUtf8AreAWarningAndStay) {
  EXPECT_EQ(Warnings("<a>\n<!-- T\xFCr --></a>"),
            "t.xml:2:7: warning: this is not UTF-8 (save the file as UTF-8)\n");
  EXPECT_TRUE(StrictXmlEdit(Parsed("<a><!-- T\xFCr --></a>")).empty());
}

TEST(Strictness, WhatTinyxml2DoesNotReadIsAWarning) {
  EXPECT_EQ(Warnings("<a/>\n</b><!-- <c"),
            "t.xml:2:1: warning: what follows is ignored "
            "(an end tag that closes nothing, or a zero byte)\n");
}

TEST(Strictness, WhatIsOutsideOfTheRootIsNotMended) {
  EXPECT_TRUE(StrictXmlEdit(Parsed("<a/><b x='1'></b>")).empty());
}

}  // namespace
}  // namespace coppice
