#include "bt_core/model/xml_error.h"

#include <gtest/gtest.h>
#include <tinyxml2.h>

namespace coppice {
namespace {

// "offset: message (hint)" of a text that tinyxml2 refuses.
std::string Error(const std::string& text) {
  tinyxml2::XMLDocument xml;
  const bool accepted = xml.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS;
  EXPECT_FALSE(accepted && xml.RootElement()) << text;
  const auto error = FindXmlError(text);
  if (!error) return "nothing";
  return std::to_string(error->offset) + ": " + error->message +
         (error->hint.empty() ? "" : " (" + error->hint + ")");
}

TEST(XmlError, AMissingEndTagIsFoundWhereItIsMissed) {
  EXPECT_EQ(Error("<a>\n<b>\n<c/>\n</a>"),
            "13: <b> of line 2 is not closed before </a> (</b> is missing)");
  EXPECT_EQ(Error("<a>\n<b/>\n"), "0: <a> is never closed (expected </a>)");
}

TEST(XmlError, AWrongEndTagNamesWhatItShouldClose) {
  EXPECT_EQ(Error("<a><Sequence>\n</Seqence></a>"),
            "14: </Seqence> does not close <Sequence> of line 1 (expected </Sequence>)");
  EXPECT_EQ(Error("</b><a>"), "0: </b> closes nothing (remove it)");
}

TEST(XmlError, AttributesAreNamed) {
  EXPECT_EQ(Error("<a><b x=1 y='2'/></a>"),
            R"(8: the value of "x" must stand in quotes (write x="1"))");
  EXPECT_EQ(Error("<a><b x y='2'/></a>"), R"(6: attribute "x" has no value (write x="..."))");
  EXPECT_EQ(Error("<a x='1' x='2'/>"),
            R"(9: second attribute "x" in the same element (remove one))");
  EXPECT_EQ(Error("<Move, target = {x}/>"),
            R"(5: unexpected ',' in <Move> (expected attribute="value" or '>'))");
}

TEST(XmlError, AMissingQuoteIsFoundAtItsBeginning) {
  EXPECT_EQ(Error("<a>\n<b x=\"1/>\n<b y=\"2\"/>\n</a>"), "9: this value has no closing quote");
  EXPECT_EQ(Error("<a x='1/></a>"), R"(5: the value of "x" has no closing quote)");
}

TEST(XmlError, AMissingBracketIsFound) {
  EXPECT_EQ(Error("<a>\n<b x='1'\n<c/></a>"), "13: <b> is not closed by '>' before this");
  EXPECT_EQ(Error("<a>1 < 2</a>"),
            "7: a name must follow '<' (write &lt; for a '<' that stands for itself)");
}

TEST(XmlError, UnclosedMarkupIsNamed) {
  EXPECT_EQ(Error("<a>\n\t<!-- "), "5: comment without -->");
  EXPECT_EQ(Error("<a><![CDATA[ "), "3: CDATA without ]]>");
  EXPECT_EQ(Error("<?xml version='1.0'><a/>"), "0: <? without ?>");
}

TEST(XmlError, WhatStandsInTheWrongPlaceIsNamed) {
  EXPECT_EQ(Error("<a/>\nwords"), "5: text outside of the root element (put it in a comment)");
  EXPECT_EQ(Error("<!-- --><?xml?><a/>"),
            "8: malformed or misplaced <?xml ?> declaration (it must come first in the file)");
}

TEST(XmlError, AZeroByteIsNamed) {
  EXPECT_EQ(Error(std::string("<a>\0</a>", 8)), "3: a zero byte (is this a text file?)");
}

TEST(XmlError, WhatIsNoMistakeIsNotReported) {
  for (const char* text :
       {"", "<!-- -->", R"(<a x='>' y="<"/>)", "<?xml?>\n<!-- <a> --><a><b></b></a >",
        "<a><![CDATA[<]]>words &amp; words</a>", "words <a/>"}) {
    EXPECT_FALSE(FindXmlError(text)) << text;
  }
}

}  // namespace
}  // namespace coppice
