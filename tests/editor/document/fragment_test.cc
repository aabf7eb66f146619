#include "editor/document/fragment.h"

#include <gmock/gmock.h>

#include "tests/editor/document/drafts.h"

namespace coppice::editor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> Read(const std::string& text) {
  Diagnostics diagnostics;
  std::vector<std::string> fragments = ReadFragments(text, diagnostics);
  EXPECT_EQ(diagnostics.has_errors(), fragments.empty()) << diagnostics.ToString();
  return fragments;
}

std::string ErrorOf(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_THAT(ReadFragments(text, diagnostics), IsEmpty());
  return diagnostics.ToString();
}

TEST(CopyText, MovesNodesToTheLeftEdge) {
  const Document document = Parsed(kRound);
  EXPECT_EQ(CopyText(document, {Find(document, "inner"), Find(document, "A")}),
            "<A/>\n<Fallback name=\"inner\">\n  <C msec='5'/>\n  <D/>\n</Fallback>\n");
}

TEST(ReadFragments, GivesBackWhatWasCopied) {
  const Document document = Parsed(kRound);
  EXPECT_THAT(Read(CopyText(document, {Find(document, "A"), Find(document, "B")})),
              ElementsAre("<A/>", R"(<B goal="{goal}"/>)"));
}

TEST(ReadFragments, TakesTheNodesOutOfAFile) {
  EXPECT_THAT(Read("<?xml version=\"1.0\"?>\n<root><include path=\"a\"/><BehaviorTree ID=\"M\">"
                   "<A/></BehaviorTree><TreeNodesModel/></root>"),
              ElementsAre("<A/>"));
}

TEST(ReadFragments, NamesTheLineOfTheMistake) {
  EXPECT_THAT(ErrorOf("<A/>\n<B>\n"), HasSubstr("<B> of line 2 is not closed"));
  EXPECT_THAT(ErrorOf("<A x=1/>"), HasSubstr("clipboard:1:6:"));
  EXPECT_THAT(ErrorOf("<A/>\nwords"), HasSubstr("text between the nodes"));
}

TEST(ReadFragments, RefusesWhatIsNoNode) {
  EXPECT_NE(ErrorOf(""), "");
  EXPECT_NE(ErrorOf("hello"), "");
  EXPECT_NE(ErrorOf("<root></root>"), "");
  EXPECT_NE(ErrorOf("</clipboard><A/>"), "");
  EXPECT_NE(ErrorOf("<A/></clipboard><clipboard>"), "");
  EXPECT_THAT(ErrorOf("<TreeNodesModel/>"), HasSubstr("is no node"));
}

}  // namespace
}  // namespace coppice::editor
