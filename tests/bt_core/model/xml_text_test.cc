#include "bt_core/model/xml_text.h"

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <random>
#include <string>

namespace coppice {
namespace {

TEST(XmlText, DecodesReferences) {
  EXPECT_EQ(DecodeXml("&lt;&gt;&amp;&quot;&apos;"), "<>&\"'");
  EXPECT_EQ(DecodeXml("&#65;&#x42;&#xe9;&#x20AC;&#128512;"),
            "AB\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
}

TEST(XmlText, AnAmpersandThatBeginsNoReferenceStandsForItself) {
  for (const char* text : {"a && b", "&", "&nbsp;", "&lt", "&#;", "&#x;", "&#xZ;", "&#65", "&#0;",
                           "&#1114112;", "&#4294967361;", "&#65z;", "& lt;"}) {
    EXPECT_EQ(DecodeXml(text), text);
  }
  EXPECT_EQ(DecodeXml("a &lt; 3 && b"), "a < 3 && b") << "tinyxml2 9 loses the ampersands";
}

TEST(XmlText, EveryKindOfLineEndIsOneLineFeed) {
  EXPECT_EQ(DecodeXml("1\r\n2\n\r3\r4\n5\r\r"), "1\n2\n3\n4\n5\n\n");
}

TEST(XmlText, AgreesWithTinyxml2WhereNoAmpersandStandsForItself) {
  const std::string pieces[] = {"a",        " ",  "&lt;", "&amp;", "&#65;",
                                "&#x20ac;", "\r", "\n",   "\t",    ">"};
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    std::string raw;
    for (int length = static_cast<int>(random() % 12); length > 0; --length) {
      raw += pieces[random() % std::size(pieces)];
    }
    tinyxml2::XMLDocument xml;
    ASSERT_EQ(xml.Parse(("<a x='" + raw + "'/>").c_str()), tinyxml2::XML_SUCCESS);
    EXPECT_EQ(DecodeXml(raw), xml.RootElement()->Attribute("x")) << raw;
  }
}

TEST(XmlText, OnlyReferencesAndCarriageReturnsNeedDecoding) {
  EXPECT_FALSE(NeedsDecoding("plain\ntext > <"));
  EXPECT_TRUE(NeedsDecoding("a&lt;"));
  EXPECT_TRUE(NeedsDecoding("a\r"));
}

TEST(XmlText, FindsTheRawPlaceOfACharacter) {
  const std::string_view raw = "a &lt; b &amp;&amp; \xC3\xA9 c";
  const std::string decoded = DecodeXml(raw);
  EXPECT_EQ(RawOffset(raw, 0), 0U);
  EXPECT_EQ(RawOffset(raw, decoded.find('<')), raw.find("&lt;"));
  EXPECT_EQ(RawOffset(raw, decoded.find('b')), raw.find('b'));
  EXPECT_EQ(RawOffset(raw, decoded.find("&&") + 1), raw.rfind("&amp;"));
  EXPECT_EQ(RawOffset(raw, decoded.find('c')), raw.find('c'));
  EXPECT_EQ(RawOffset(raw, decoded.size()), raw.size());
  EXPECT_EQ(RawOffset(raw, 1000), raw.size());
}

TEST(XmlText, AByteInsideOfAReferencedCharacterLiesAtTheReference) {
  EXPECT_EQ(RawOffset("x&#x20AC;y", 1), 1U);
  EXPECT_EQ(RawOffset("x&#x20AC;y", 3), 1U);
  EXPECT_EQ(RawOffset("x&#x20AC;y", 4), 9U);
  EXPECT_EQ(RawOffset("1\r\n2", 2), 3U);
}

TEST(XmlText, EscapedValuesDecodeToThemselves) {
  const std::string value = "a < \"b\" && 'c' > \t1\n2\r3 &lt; \xC3\xA9";
  for (const char quote : {'"', '\''}) {
    const std::string raw = EscapeXmlValue(value, quote);
    EXPECT_EQ(raw.find_first_of(std::string("<\n\r\t") + quote), std::string::npos) << raw;
    EXPECT_EQ(DecodeXml(raw), value);
  }
  EXPECT_EQ(EscapeXmlValue(R"('a' > "b")", '"'), "'a' > &quot;b&quot;");
  EXPECT_EQ(EscapeXmlValue(R"('a' > "b")", '\''), R"(&apos;a&apos; > "b")");
}

TEST(XmlText, KnowsTheLengthOfAReference) {
  EXPECT_EQ(ReferenceLength("&lt;x"), 4U);
  EXPECT_EQ(ReferenceLength("&#x41;"), 6U);
  EXPECT_EQ(ReferenceLength("&& "), 0U);
  EXPECT_EQ(ReferenceLength("x"), 0U);
  EXPECT_EQ(ReferenceLength(""), 0U);
}

TEST(XmlText, KnowsTheLengthOfAName) {
  EXPECT_EQ(NameLength("Sequence name"), 8U);
  EXPECT_EQ(NameLength("a/>"), 1U);
  EXPECT_EQ(NameLength("1a"), 0U);
  EXPECT_EQ(NameLength(""), 0U);
}

TEST(XmlText, KnowsNames) {
  for (const char* name : {"a", "_skipIf", "xml:lang", "T\xC3\xBCr", "a-b.c1"}) {
    EXPECT_TRUE(IsXmlName(name)) << name;
  }
  for (const char* name : {"", "1a", "-a", "a b", "a>", "a=", "a\"", "a/"}) {
    EXPECT_FALSE(IsXmlName(name)) << name;
  }
}

}  // namespace
}  // namespace coppice
