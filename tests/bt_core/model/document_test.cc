#include "bt_core/model/document.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace coppice {
namespace {

struct Loaded {
  std::optional<Document> document;
  Diagnostics diagnostics;
};

Loaded Load(std::string text) {
  Loaded loaded;
  loaded.document = Document::FromText(std::move(text), "t.xml", loaded.diagnostics);
  return loaded;
}

// Every name and value must stand in the user's text where the index says.
void ExpectOffsetsExact(const Document& document) {
  const std::string& text = document.text();
  for (const Element& element : document.elements()) {
    EXPECT_EQ(text.at(element.offset), '<');
    EXPECT_EQ(text.substr(element.offset + 1, element.tag.size()), element.tag);
    EXPECT_EQ(text.at(element.start_tag_end - 1), '>');
    EXPECT_EQ(text.at(element.end - 1), '>');
    for (const Attribute* a = document.attributes_begin(element);
         a != document.attributes_end(element); ++a) {
      EXPECT_EQ(text.substr(a->name_offset, a->name.size()), a->name);
      const char quote = text.at(a->value_offset - 1);
      EXPECT_TRUE(quote == '"' || quote == '\'') << a->name;
      EXPECT_EQ(text.at(a->value_end), quote) << a->name;
    }
  }
}

std::string FirstError(const std::string& text) {
  const Loaded loaded = Load(text);
  EXPECT_FALSE(loaded.document) << text;
  return loaded.diagnostics.all().empty() ? "" : ToString(loaded.diagnostics.all().front());
}

TEST(Document, IndexesElementsInDocumentOrder) {
  const auto document = Load("<a><b><c/></b><d/>text<e/></a>").document;
  ASSERT_TRUE(document);
  ASSERT_EQ(document->elements().size(), 5U);
  const char* tags[] = {"a", "b", "c", "d", "e"};
  const ElementIndex parents[] = {kNoElement, kRootElement, ElementIndex{1}, kRootElement,
                                  kRootElement};
  const ElementIndex first_children[] = {ElementIndex{1}, ElementIndex{2}, kNoElement, kNoElement,
                                         kNoElement};
  const ElementIndex siblings[] = {kNoElement, ElementIndex{3}, kNoElement, ElementIndex{4},
                                   kNoElement};
  const std::uint32_t counts[] = {3, 1, 0, 0, 0};
  for (ElementIndex i{0}; i < 5; ++i) {
    const Element& element = document->element(i);
    EXPECT_EQ(element.tag, tags[i]);
    EXPECT_EQ(element.parent, parents[i]) << tags[i];
    EXPECT_EQ(element.first_child, first_children[i]) << tags[i];
    EXPECT_EQ(element.next_sibling, siblings[i]) << tags[i];
    EXPECT_EQ(element.child_count, counts[i]) << tags[i];
  }
}

TEST(Document, RefusesAnElementWithVeryManyAttributes) {
  std::string text = "<root>\n<A";
  for (int i = 0; i < 1001; ++i) text += " a" + std::to_string(i) + "='='";
  const Loaded loaded = Load(text + "/></root>");
  EXPECT_FALSE(loaded.document);
  EXPECT_EQ(loaded.diagnostics.ToString(),
            "t.xml:2:1: error: an element with more than 1000 attributes\n");
}

TEST(Document, FindsAttributes) {
  const auto document = Load("<a x='1' y='two'><b x='3'/></a>").document;
  const Element& root = document->element(kRootElement);
  EXPECT_EQ(document->AttributeValue(root, "y"), "two");
  EXPECT_EQ(document->AttributeValue(root, "z"), "");
  EXPECT_EQ(document->FindAttribute(root, "z"), nullptr);
  EXPECT_EQ(document->AttributeValue(document->element(ElementIndex{1}), "x"), "3");
}

struct Prefix {
  const char* name;
  const char* text;
};
class DocumentOffsets : public testing::TestWithParam<Prefix> {};

TEST_P(DocumentOffsets, AreExactBehind) {
  const std::string prefix = GetParam().text;
  const auto document = Load(prefix + "<root  x = \"1\"\n\ty='2' ><b z=\"3\"/></root>").document;
  ASSERT_TRUE(document);
  ExpectOffsetsExact(*document);
  EXPECT_EQ(document->element(kRootElement).offset, prefix.size());
  const Attribute* x = document->attributes_begin(document->element(kRootElement));
  EXPECT_EQ(x[0].name_offset, prefix.size() + 7);
  EXPECT_EQ(x[0].value_offset, prefix.size() + 12);
  EXPECT_EQ(x[1].name_offset, prefix.size() + 16);
  EXPECT_EQ(document->element(ElementIndex{1}).offset, prefix.size() + 23);
}

INSTANTIATE_TEST_SUITE_P(
    , DocumentOffsets,
    testing::Values(Prefix{"Nothing", ""}, Prefix{"Blanks", " \r\n\t\n"},
                    Prefix{"ByteOrderMark", "\xEF\xBB\xBF"},
                    Prefix{"ByteOrderMarkAndBlanks", "\xEF\xBB\xBF\r\n "},
                    Prefix{"BlanksAndByteOrderMark", "\n\xEF\xBB\xBF"},
                    Prefix{"Declaration", "<?xml version=\"1.0\"?>\n"},
                    Prefix{"DeclarationAfterBlankLine", "\n<?xml version=\"1.0\"?>\n"},
                    Prefix{"Comment", "<!-- <a> & -->"},
                    Prefix{"CommentWithDashes", "<!------->\r\n"},
                    Prefix{"DocumentType", "<!DOCTYPE root>\n"},
                    Prefix{"DeclarationAndComments", "<?xml?><!--1-->\n<!--2-->"},
                    Prefix{"Text", " words "},
                    Prefix{"TextWithEntities", "\xEF\xBB\xBF a &amp; b\r\n"},
                    Prefix{"CharacterData", "<![CDATA[<x>]]>"}),
    [](const auto& instance) { return instance.param.name; });

TEST(Document, OffsetsAreExactInsideTheRoot) {
  const auto document = Load(
                            "<a>\r\n<!-- <no/> -->&amp;<b\r\n  x='&lt;&#65;'\r\n  y=\"a\r\nb\"/>"
                            "<![CDATA[<no/>]]><c z='>'/>\r\n</a>")
                            .document;
  ASSERT_TRUE(document);
  ASSERT_EQ(document->elements().size(), 3U);
  ExpectOffsetsExact(*document);
}

TEST(Document, BlanksBetweenBracketAndNameAreAllowed) {
  const auto document = Load(" <  a x='1'><\nb/></a>").document;
  ASSERT_TRUE(document);
  EXPECT_EQ(document->element(kRootElement).offset, 1U);
  EXPECT_EQ(document->attributes_begin(document->element(kRootElement))->name_offset, 6U);
  EXPECT_EQ(document->element(ElementIndex{1}).offset, 12U);
}

TEST(Document, ResolvesEntitiesAndLineEnds) {
  const auto document =
      Load("<a x='&lt;&amp;&#65;&gt;' y='1\r\n2' z='a && b' w='<;0.5'/>").document;
  ASSERT_TRUE(document);
  const Element& root = document->element(kRootElement);
  EXPECT_EQ(document->AttributeValue(root, "x"), "<&A>");
  EXPECT_EQ(document->AttributeValue(root, "y"), "1\n2");
  EXPECT_EQ(document->AttributeValue(root, "z"), "a && b");
  EXPECT_EQ(document->AttributeValue(root, "w"), "<;0.5");
}

TEST(Document, KnowsWhereElementsEnd) {
  const std::string text =
      "<a><b x='>' /><c>words > <!-- </c> --><![CDATA[</c>]]><d></d>\n</c ><e y='/'\n></e></a> ";
  const auto document = Load(text).document;
  ASSERT_TRUE(document);
  const auto start_tag = [&](ElementIndex i) {
    const Element& e = document->element(i);
    return text.substr(e.offset, e.start_tag_end - e.offset);
  };
  const auto whole = [&](ElementIndex i) {
    const Element& e = document->element(i);
    return text.substr(e.offset, e.end - e.offset);
  };
  EXPECT_EQ(whole(kRootElement) + " ", text);
  EXPECT_EQ(whole(ElementIndex{1}), "<b x='>' />");
  EXPECT_EQ(start_tag(ElementIndex{1}), whole(ElementIndex{1})) << "self-closing";
  EXPECT_EQ(start_tag(ElementIndex{2}), "<c>");
  EXPECT_EQ(whole(ElementIndex{2}), "<c>words > <!-- </c> --><![CDATA[</c>]]><d></d>\n</c >");
  EXPECT_EQ(whole(ElementIndex{3}), "<d></d>");
  EXPECT_EQ(start_tag(ElementIndex{4}), "<e y='/'\n>");
  EXPECT_EQ(whole(ElementIndex{4}), "<e y='/'\n></e>");
}

TEST(Document, KnowsWhereElementsEndInWhatOnlyTinyxml2Accepts) {
  const std::string text = "<a><b>< c></c x='>'></b></a><!-- --- -->";
  const auto document = Load(text).document;
  ASSERT_TRUE(document);
  ASSERT_EQ(document->elements().size(), 3U);
  EXPECT_EQ(document->element(kRootElement).end, text.find("<!--"));
  EXPECT_EQ(document->element(ElementIndex{1}).end, text.find("</a>"));
  EXPECT_EQ(document->element(ElementIndex{2}).end, text.find("</b"));
}

TEST(Document, FindsTheInnermostElementAtAPlace) {
  const std::string text = "\n<a>.<b><c/></b>.<d/>.</a>\n";
  const auto document = Load(text).document;
  const auto at = [&](std::size_t offset) {
    const ElementIndex index = document->ElementAt(static_cast<std::uint32_t>(offset));
    return index == kNoElement ? "none" : std::string(document->element(index).tag);
  };
  EXPECT_EQ(at(0), "none");
  EXPECT_EQ(at(text.find("<a")), "a");
  EXPECT_EQ(at(text.find("<b")), "b");
  EXPECT_EQ(at(text.find("<c") + 3), "c");
  EXPECT_EQ(at(text.find("</b")), "b");
  EXPECT_EQ(at(text.find(".<d")), "a");
  EXPECT_EQ(at(text.find("</a>") + 3), "a");
  EXPECT_EQ(at(text.size() - 1), "none");
}

TEST(Document, TextIsWhatStandsDirectlyInAnElement) {
  const auto document =
      Load(
          "<a> one <b>not &amp; this<c/></b>&lt;two<!-- no --><![CDATA[<&amp;>]]>\n"
          "</a>")
          .document;
  EXPECT_EQ(document->TextOf(document->element(kRootElement)), "one <two<&amp;>");
  EXPECT_EQ(document->TextOf(document->element(ElementIndex{1})), "not & this");
  EXPECT_EQ(document->TextOf(document->element(ElementIndex{2})), "");
}

TEST(Document, FindsThePlaceOfACharacterInsideOfAValue) {
  const std::string text = "<a x='1 &lt; 2 &amp;&amp; y\r\n == 3'/>";
  const auto document = Load(text).document;
  const Attribute& x = *document->FindAttribute(document->element(kRootElement), "x");
  EXPECT_EQ(document->RawValue(x), "1 &lt; 2 &amp;&amp; y\r\n == 3");
  EXPECT_EQ(document->OffsetInValue(x, 0), x.value_offset);
  EXPECT_EQ(document->OffsetInValue(x, x.value.find('<')), text.find("&lt;"));
  EXPECT_EQ(document->OffsetInValue(x, x.value.find('y')), text.find('y'));
  EXPECT_EQ(document->OffsetInValue(x, x.value.find('3')), text.find('3'));
  EXPECT_EQ(document->OffsetInValue(x, x.value.size()), x.value_end);
}

TEST(Document, ViewsSurviveAMove) {
  auto loaded = Load("<a x='&amp;' y='plain'/>");
  const Document moved = *std::move(loaded.document);
  EXPECT_EQ(moved.element(kRootElement).tag, "a");
  EXPECT_EQ(moved.AttributeValue(moved.element(kRootElement), "x"), "&");
  EXPECT_EQ(moved.AttributeValue(moved.element(kRootElement), "y"), "plain");
}

TEST(Document, LocatesOffsetsByLineAndColumn) {
  const auto document = Load("<a>\r\n  <b/>\n</a>").document;
  const auto at = [&](std::uint32_t offset) {
    const SourceLocation where = document->Location(offset);
    EXPECT_EQ(where.file, "t.xml");
    return std::pair(where.line, where.column);
  };
  EXPECT_EQ(at(0), std::pair(1U, 1U));
  EXPECT_EQ(at(4), std::pair(1U, 5U)) << "the line end belongs to its line";
  EXPECT_EQ(at(5), std::pair(2U, 1U));
  EXPECT_EQ(at(document->element(ElementIndex{1}).offset), std::pair(2U, 3U));
  EXPECT_EQ(at(12), std::pair(3U, 1U));
}

TEST(Document, KeepsTheTextAsItIs) {
  const std::string text = "\xEF\xBB\xBF<a  x = '1' ><!-- c --></a>\r\n";
  EXPECT_EQ(Load(text).document->text(), text);
}

TEST(Document, MalformedXmlIsReportedWithItsPlace) {
  EXPECT_EQ(FirstError("<a>\n  <b>\n</a>"),
            "t.xml:3:1: error: <b> of line 2 is not closed before </a> (</b> is missing)");
  EXPECT_EQ(FirstError("<a>\n <b x=1/></a>"),
            R"(t.xml:2:7: error: the value of "x" must stand in quotes (write x="1"))");
}

TEST(Document, WithoutElementThereIsNoDocument) {
  const std::string expected = R"(t.xml:1:1: error: no element (expected <root BTCPP_format="4">))";
  for (const char* text : {"", " \n", "<!-- only -->", "<?xml version='1.0'?>"}) {
    EXPECT_EQ(FirstError(text), expected) << text;
  }
}

TEST(Document, ATagThatBeginsAndEndsIsRefused) {
  EXPECT_EQ(FirstError("</a/>"),
            "t.xml:1:1: error: </a/> is neither a start tag nor an end tag "
            "(write <a/> or </a>)");
  EXPECT_NE(FirstError("<a>\n<b></c/></b></a>").find("t.xml:2:4: error: </c/> is neither"),
            std::string::npos);
}

TEST(Document, Utf16IsNamed) {
  const std::string utf16("\xFF\xFE<\0a\0", 6);
  EXPECT_EQ(FirstError(utf16), "t.xml:1:1: error: this file is UTF-16 (save it as UTF-8)");
}

TEST(Document, TooDeepNestingIsAnErrorAndNoCrash) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 1; i < depth; ++i) text += "<a>";
    text += "<b/>";
    for (int i = 1; i < depth; ++i) text += "</a>";
    return text;
  };
  EXPECT_TRUE(Load(nested(99)).document);
  EXPECT_EQ(FirstError(nested(100)),
            "t.xml:1:295: error: elements are nested more than 98 deep "
            "(make the inner ones a SubTree)");
  EXPECT_NE(FirstError(nested(100000)).find("nested"), std::string::npos);
}

TEST(Document, AValueOfAMegabyteIsFine) {
  const std::string value(1 << 20, 'x');
  const auto document = Load("<a x='" + value + "&amp;'/>").document;
  EXPECT_EQ(document->AttributeValue(document->element(kRootElement), "x"), value + "&");
}

TEST(Document, WhatFollowsAZeroByteIsIgnoredWithAWarning) {
  const Loaded loaded = Load(std::string("<a/>\n\0<b", 8));
  ASSERT_TRUE(loaded.document);
  EXPECT_EQ(loaded.document->text().size(), 8U) << "but kept";
  EXPECT_EQ(loaded.diagnostics.ToString(),
            "t.xml:2:1: warning: what follows is ignored "
            "(an end tag that closes nothing, or a zero byte)\n");
}

TEST(Document, WarnsOfWhatIsOutsideOfTheRoot) {
  const Loaded loaded = Load("hello\n<a/>bye\n <b/>");
  ASSERT_TRUE(loaded.document);
  EXPECT_EQ(loaded.diagnostics.ToString(),
            "t.xml:1:1: warning: text before the root element is ignored\n"
            "t.xml:2:5: warning: text behind the root element is ignored\n"
            "t.xml:3:2: warning: second root element <b> is ignored\n");
}

TEST(Document, WarnsOfTextInTreesOnceInEach) {
  const Loaded loaded = Load(
      "<root>stray<BehaviorTree><A>\n  one</A>two</BehaviorTree>\n<BehaviorTree>\n<![CDATA[x]]>"
      "</BehaviorTree>\n<TreeNodesModel><Action>described</Action></TreeNodesModel></root>");
  const std::string hint = " (a comment is written <!-- like this -->)\n";
  EXPECT_EQ(loaded.diagnostics.ToString(),
            "t.xml:2:3: warning: text in a tree is ignored" + hint +
                "t.xml:4:10: warning: text in a tree is ignored" + hint +
                "t.xml:1:7: warning: text in <root> is ignored" + hint);
}

TEST(Document, AnEditedDocumentHasTheSameName) {
  Diagnostics diagnostics;
  const auto document = Load("<a><b/></a>").document;
  const auto edited = document->Edited({{3, 4, "\n<c/>"}}, diagnostics);
  ASSERT_TRUE(edited);
  EXPECT_EQ(edited->text(), "<a>\n<c/></a>");
  EXPECT_EQ(edited->Location(edited->element(ElementIndex{1}).offset).line, 2U);
  EXPECT_EQ(edited->file(), "t.xml");
  EXPECT_FALSE(document->Edited({{3, 4, "<c>"}}, diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(Document, ARewrittenDocumentSpeaksOfTheOldPlaces) {
  Diagnostics diagnostics;
  const auto document = Load("<a>\n  <b x='1'/>\n  <c/>\n</a>").document;
  const auto rewritten =
      document->Rewritten({{0, 0, "<!-- 1\n2\n-->"}, {7, 1, "longer"}}, diagnostics);
  ASSERT_TRUE(rewritten);
  EXPECT_EQ(rewritten->element(ElementIndex{1}).tag, "longer");
  for (ElementIndex i{0}; i < 3; ++i) {
    const SourceLocation where = rewritten->Location(rewritten->element(i).offset);
    const SourceLocation old = document->Location(document->element(i).offset);
    EXPECT_EQ(std::pair(where.line, where.column), std::pair(old.line, old.column)) << i;
  }
  const SourceLocation x = rewritten->Location(
      rewritten->attributes_begin(rewritten->element(ElementIndex{1}))->name_offset);
  EXPECT_EQ(std::pair(x.line, x.column), std::pair(2U, 6U));
}

TEST(Document, RefusesATextThatIsLargerThanPeopleWrite) {
  const auto times = [](int count, const std::string& piece) {
    std::string text = "<root>";
    for (int i = 0; i < count; ++i) text += piece;
    return Load(text + "</root>");
  };
  EXPECT_TRUE(times(100'000, "<a b=''/>\n").document);
  for (const Loaded& loaded : {times(500'000, "<a/>"), times(5'000'001, "\n"), times(33 << 20, "x"),
                               times(250'000, "<a b=''/>")}) {
    EXPECT_FALSE(loaded.document);
    EXPECT_EQ(loaded.diagnostics.ToString(),
              "t.xml: error: too large for a tree: expected at most 32 MiB, 5 million lines and "
              "500000 elements and attributes\n");
  }
}

TEST(Document, ReadsAFile) {
  const std::string path = testing::TempDir() + "document_test.xml";
  std::ofstream(path) << "<root/>";
  Diagnostics diagnostics;
  const auto document = Document::FromFile(path, diagnostics);
  std::filesystem::remove(path);
  ASSERT_TRUE(document);
  EXPECT_EQ(document->file(), path);
  EXPECT_EQ(document->element(kRootElement).tag, "root");
}

TEST(Document, SaysWhenAFileCannotBeRead) {
  for (const std::string path : {"/no/such.xml", "/tmp", "/dev/zero"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(Document::FromFile(path, diagnostics)) << path;
    EXPECT_TRUE(diagnostics.has_errors());
  }
}

}  // namespace
}  // namespace coppice
