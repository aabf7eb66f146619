#include "bt_core/model/source_text.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

Document Parsed(const std::string& text) {
  Diagnostics diagnostics;
  auto document = Document::FromText(text, "a.xml", diagnostics);
  EXPECT_TRUE(document) << diagnostics.ToString();
  return *document;
}

// More lines than one place of the index is for, some of them deeper than a byte can say.
std::string LongText() {
  std::string text = "<a>\r\n";
  for (std::size_t i = 0; i < 100; ++i) {
    text += std::string(i * 7, ' ') + "<b n='" + std::to_string(i) + "'\n\t c='&lt;\n>'/>\n \n\n";
  }
  return text + "</a>";
}

// All in one line, as programs write it, with tags that are longer than one reads at first.
std::string LongLine() {
  std::string text = "    <a>";
  for (std::size_t i = 0; i < 9; ++i) {
    text += "<b n='" + std::string(i * 150, 'x') + "' c=\"" + std::to_string(i) + "\"/>";
  }
  return text + "</a>";
}

class SourceTextTest : public testing::TestWithParam<std::string> {
 protected:
  const Document document_ = Parsed(GetParam());
  const SourceText source_{document_};
};

TEST_P(SourceTextTest, GivesTheTextBackByteForByte) { EXPECT_EQ(source_.text(), GetParam()); }

TEST_P(SourceTextTest, KnowsTheLineAndColumnOfEveryByte) {
  for (std::uint32_t at = 0; at < GetParam().size(); ++at) {
    const SourceLocation expected = document_.Location(at);
    const SourceLocation found = source_.Location(at);
    ASSERT_EQ(found.line, expected.line) << at;
    ASSERT_EQ(found.column, expected.column) << at;
  }
}

TEST_P(SourceTextTest, ReadsEveryStartTagAsTheDocumentHasIt) {
  for (const Element& element : document_.elements()) {
    StartTag expected{std::string(element.tag), {}};
    for (const Attribute* a = document_.attributes_begin(element);
         a != document_.attributes_end(element); ++a) {
      expected.attributes.push_back({std::string(a->name), std::string(a->value)});
    }
    ASSERT_TRUE(source_.StartTagAt(element.offset) == expected) << element.offset;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, SourceTextTest,
                         testing::Values("<a/>", "<a></a>\n", "\n\n  < a x = '1'y=\"2\"/>\n\n",
                                         "<a x='>' y=\"'\">\n<b/><!--\n <c/>--></a>", LongText(),
                                         LongLine()));

TEST(SourceText, SpeaksOfTheUsersFileAfterARewriting) {
  const Document before = Parsed("<a>\n<b/>\n <c/></a>");
  Diagnostics diagnostics;
  const auto rewritten = before.Rewritten({Replacement(5, 6, "long\n\n")}, diagnostics);
  ASSERT_TRUE(rewritten);
  const SourceLocation where =
      SourceText(*rewritten).Location(rewritten->element(ElementIndex{2}).offset);
  EXPECT_EQ(where.line, 3U);
  EXPECT_EQ(where.column, 2U);
}

}  // namespace
}  // namespace coppice
