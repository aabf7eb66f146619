#include "bt_core/model/element_edits.h"

#include "tests/bt_core/model/edited.h"

namespace coppice {
namespace {

constexpr const char* kTree =
    "<root>\n"
    "  <!-- the way home -->\n"
    "  <S name='s'>\n"
    "    <A/> <!-- first -->\n"
    "    <!-- about B -->\n"
    "    <B x='1'>\n"
    "      <C/>\n"
    "    </B>\n"
    "  </S>\n"
    "  <T/>\n"
    "</root>\n";

std::string Replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

std::string Insert(const std::string& text, const char* parent, std::uint32_t position,
                   std::string_view xml) {
  const Document document = Parsed(text);
  return After(document, InsertElement(document, Find(document, parent), position, xml));
}
std::string Remove(const std::string& text, const char* tag) {
  const Document document = Parsed(text);
  return After(document, RemoveElement(document, Find(document, tag)));
}
std::string Move(const std::string& text, const char* tag, const char* parent,
                 std::uint32_t position) {
  const Document document = Parsed(text);
  return After(document,
               MoveElement(document, Find(document, tag), Find(document, parent), position));
}
std::string Wrap(const std::string& text, const char* tag, std::uint32_t count) {
  const Document document = Parsed(text);
  return After(document, WrapElements(document, Find(document, tag), count, "W"));
}
std::string Unwrap(const std::string& text, const char* tag) {
  const Document document = Parsed(text);
  return After(document, UnwrapElement(document, Find(document, tag)));
}

TEST(InsertElement, FirstGoesBehindTheStartTag) {
  EXPECT_EQ(Insert(kTree, "S", 0, "<N/>"), Replaced(kTree, "'s'>\n", "'s'>\n    <N/>\n"));
}

TEST(InsertElement, GoesBehindTheCommentOnTheLineOfItsNeighbour) {
  EXPECT_EQ(Insert(kTree, "S", 1, "<N/>"),
            Replaced(kTree, "<!-- first -->\n", "<!-- first -->\n    <N/>\n"));
}

TEST(InsertElement, LastGoesBehindTheLastChild) {
  const std::string expected = Replaced(kTree, "    </B>\n", "    </B>\n    <N/>\n");
  EXPECT_EQ(Insert(kTree, "S", 2, "<N/>"), expected);
  EXPECT_EQ(Insert(kTree, "S", 99, "<N/>"), expected);
}

TEST(InsertElement, TextOfSeveralLinesIsIndented) {
  EXPECT_EQ(
      Insert(kTree, "S", 2, "<N>\n\t<!-- c -->\n\t<M/>\n</N>"),
      Replaced(kTree, "    </B>\n", "    </B>\n    <N>\n    \t<!-- c -->\n    \t<M/>\n    </N>\n"));
  EXPECT_EQ(Insert(kTree, "T", 0, "<N>\n            <M/>\n          </N>"),
            Replaced(kTree, "<T/>\n", "<T>\n    <N>\n      <M/>\n    </N>\n  </T>\n"));
}

TEST(InsertElement, OpensAnElementThatHasNoChildren) {
  EXPECT_EQ(Insert(kTree, "T", 0, "<N/>"), Replaced(kTree, "<T/>", "<T>\n    <N/>\n  </T>"));
  EXPECT_EQ(Insert("<a>\n  <b x='1' />\n</a>", "b", 0, "<N/>"),
            "<a>\n  <b x='1'>\n    <N/>\n  </b>\n</a>");
  EXPECT_EQ(Insert("<a>\n  <b></b>\n</a>", "b", 0, "<N/>"), "<a>\n  <b>\n    <N/>\n  </b>\n</a>");
  EXPECT_EQ(Insert("<a>\n  <b>\n    <!-- c -->\n  </b>\n</a>", "b", 0, "<N/>"),
            "<a>\n  <b>\n    <!-- c -->\n    <N/>\n  </b>\n</a>");
}

TEST(InsertElement, StaysOnTheLineWhereAllStandsOnOne) {
  EXPECT_EQ(Insert("<a><b/><c/></a>", "a", 1, "<N/>"), "<a><b/><N/><c/></a>");
  EXPECT_EQ(Insert("<a><b/><c/></a>", "a", 0, "<N/>"), "<a><N/><b/><c/></a>");
  EXPECT_EQ(Insert("<a><b/><c/></a>", "c", 0, "<N/>"), "<a><b/><c><N/></c></a>");
}

TEST(InsertElement, UsesTheLineEndsAndTabsOfTheFile) {
  EXPECT_EQ(Insert("<a>\r\n\t<b/>\r\n</a>\r\n", "b", 0, "<N>\n</N>"),
            "<a>\r\n\t<b>\r\n\t\t<N>\r\n\t\t</N>\r\n\t</b>\r\n</a>\r\n");
}

TEST(RemoveElement, TakesItsOwnLines) {
  EXPECT_EQ(Remove(kTree, "T"), Replaced(kTree, "  <T/>\n", ""));
  EXPECT_EQ(Remove(kTree, "B"), Replaced(kTree, "    <B x='1'>\n      <C/>\n    </B>\n", ""));
}

TEST(RemoveElement, LeavesWhatElseStandsOnItsLine) {
  EXPECT_EQ(Remove(kTree, "A"), Replaced(kTree, "<A/>", ""));
  EXPECT_EQ(Remove("<a><b/><c/></a>", "b"), "<a><c/></a>");
  EXPECT_EQ(Remove("<a>\n <b/> <c/>  \n</a>", "c"), "<a>\n <b/>  \n</a>");
}

TEST(RemoveElement, TheRootStays) {
  EXPECT_TRUE(RemoveElement(Parsed("<a/>"), kRootElement).empty());
}

TEST(MoveElement, TakesItsLinesToAnotherPlaceAndDepth) {
  std::string expected = Replaced(kTree, "    <B x='1'>\n      <C/>\n    </B>\n", "");
  expected = Replaced(expected, "  <T/>\n", "  <T/>\n  <B x='1'>\n    <C/>\n  </B>\n");
  EXPECT_EQ(Move(kTree, "B", "root", 2), expected);
  expected = Replaced(kTree, "  <T/>\n", "");
  expected = Replaced(expected, "      <C/>\n", "      <C>\n        <T/>\n      </C>\n");
  EXPECT_EQ(Move(kTree, "T", "C", 0), expected);
}

TEST(MoveElement, CountsPositionsWithoutItself) {
  const std::string text = "<r>\n <a/>\n <b/>\n <c/>\n</r>\n";
  EXPECT_EQ(Move(text, "a", "r", 1), "<r>\n <b/>\n <a/>\n <c/>\n</r>\n");
  EXPECT_EQ(Move(text, "a", "r", 2), "<r>\n <b/>\n <c/>\n <a/>\n</r>\n");
  EXPECT_EQ(Move(text, "c", "r", 0), "<r>\n <c/>\n <a/>\n <b/>\n</r>\n");
  EXPECT_EQ(Move(text, "b", "r", 9), "<r>\n <a/>\n <c/>\n <b/>\n</r>\n");
}

TEST(MoveElement, WorksOnOneLine) {
  EXPECT_EQ(Move("<r><a/><b/><c/></r>", "a", "r", 1), "<r><b/><a/><c/></r>");
  EXPECT_EQ(Move("<r><a/><b/><c/></r>", "c", "a", 0), "<r><a><c/></a><b/></r>");
}

TEST(MoveElement, WhereItIsAlreadyOrIntoItselfIsNoEdit) {
  const Document document = Parsed(kTree);
  const ElementIndex b = Find(document, "B");
  EXPECT_TRUE(MoveElement(document, b, Find(document, "S"), 1).empty());
  EXPECT_TRUE(MoveElement(document, b, Find(document, "S"), 5).empty());
  EXPECT_TRUE(MoveElement(document, b, Find(document, "C"), 0).empty());
  EXPECT_TRUE(MoveElement(document, b, b, 0).empty());
}

TEST(ReplaceElement, PutsTheNewTextInItsPlace) {
  const Document document = Parsed(kTree);
  EXPECT_EQ(After(document, ReplaceElement(document, Find(document, "B"), "<N>\n  <M/>\n</N>")),
            Replaced(kTree, "<B x='1'>\n      <C/>\n    </B>", "<N>\n      <M/>\n    </N>"));
}

TEST(SetTag, ChangesBothTags) {
  const Document document = Parsed("<a><b x='1'><b/></b ><c/></a>");
  EXPECT_EQ(After(document, SetTag(document, ElementIndex{1}, "new")),
            "<a><new x='1'><b/></new ><c/></a>");
  EXPECT_EQ(After(document, SetTag(document, ElementIndex{2}, "new")),
            "<a><b x='1'><new/></b ><c/></a>");
  EXPECT_TRUE(SetTag(document, ElementIndex{1}, "b").empty());
  const Document lax = Parsed("<a>< b>< /b></a>");
  EXPECT_EQ(After(lax, SetTag(lax, ElementIndex{1}, "new")), "<a>< new>< /new></a>");
}

TEST(WrapElements, IndentsWhatIsNowInside) {
  EXPECT_EQ(Wrap(kTree, "T", 1), Replaced(kTree, "  <T/>\n", "  <W>\n    <T/>\n  </W>\n"));
  EXPECT_EQ(Wrap(kTree, "A", 2),
            Replaced(kTree,
                     "    <A/> <!-- first -->\n    <!-- about B -->\n    <B x='1'>\n      <C/>\n"
                     "    </B>\n",
                     "    <W>\n      <A/> <!-- first -->\n      <!-- about B -->\n"
                     "      <B x='1'>\n        <C/>\n      </B>\n    </W>\n"));
  EXPECT_EQ(Wrap("<a><b/><c/></a>", "b", 2), "<a><W><b/><c/></W></a>");
}

TEST(UnwrapElement, PutsTheChildrenInItsPlace) {
  EXPECT_EQ(Unwrap(kTree, "B"),
            Replaced(kTree, "    <B x='1'>\n      <C/>\n    </B>\n", "    <C/>\n"));
  EXPECT_EQ(Unwrap("<a>\n  <b>\n    <!-- c -->\n    <d/>\n    <e/>\n  </b>\n</a>", "b"),
            "<a>\n  <!-- c -->\n  <d/>\n  <e/>\n</a>");
  EXPECT_EQ(Unwrap("<a><b><c/><d/></b></a>", "b"), "<a><c/><d/></a>");
  EXPECT_EQ(Unwrap("<a>\n <b/>\n</a>", "b"), "<a>\n</a>") << "nothing is in it";
}

TEST(UnwrapElement, IsTheOppositeOfWrapping) {
  const Document document = Parsed(Wrap(kTree, "A", 2));
  EXPECT_EQ(After(document, UnwrapElement(document, Find(document, "W"))), kTree);
}

}  // namespace
}  // namespace coppice
