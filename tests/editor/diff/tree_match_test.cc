#include "editor/diff/tree_match.h"

#include <gtest/gtest.h>

#include "tests/editor/canvas/make_scene.h"

namespace coppice::editor {
namespace {

// "1.1<1.2": after < before, for each node that is in another place; "1.2<" is new.
std::string Match(const std::string& before, const std::string& after) {
  const auto a = MakeScene(before);
  const auto b = MakeScene(after);
  const TreeMatch match = MatchTrees(*a, *b);
  std::string text;
  for (std::uint32_t i = 0; i < b->nodes.size(); ++i) {
    const std::uint32_t old = match.before_of[i];
    const std::string was = old == kNoSceneNode ? "" : a->nodes[old].path;
    EXPECT_TRUE(old == kNoSceneNode || match.after_of[old] == i);
    if (was != b->nodes[i].path) text += b->nodes[i].path + "<" + was + " ";
  }
  return text;
}

TEST(TreeMatch, FindsEveryNodeOfTheSameTree) {
  EXPECT_EQ(Match("<A><B/><B/><C><B/></C></A>", "<A><B/><B/><C><B/></C></A>"), "");
}

TEST(TreeMatch, KnowsANodeAgainWhosePortsOrNameHaveChanged) {
  EXPECT_EQ(Match("<A><B x='1'/><B x='2'/></A>", "<A><B x='1'/><B x='3'/></A>"), "");
  EXPECT_EQ(Match("<A><B name='old'/></A>", "<A><B name='new'/></A>"), "");
}

TEST(TreeMatch, FindsWhatAnInsertedNodeHasPushedAside) {
  EXPECT_EQ(Match("<A><B/><C/></A>", "<A><D/><B/><C/></A>"), "1.1< 1.2<1.1 1.3<1.2 ");
}

TEST(TreeMatch, FindsWhatIsLeftWhenANodeIsGone) {
  EXPECT_EQ(Match("<A><D/><B/><C/></A>", "<A><B/><C/></A>"), "1.1<1.2 1.2<1.3 ");
}

TEST(TreeMatch, FindsABranchThatWasMovedElsewhere) {
  EXPECT_EQ(Match("<A><S><X y='1'/><Z/></S><F/></A>", "<A><S/><F><X y='1'/><Z/></F></A>"),
            "1.2.1<1.1.1 1.2.2<1.1.2 ");
}

TEST(TreeMatch, FindsATreeInsideItsNewRoot) {
  EXPECT_EQ(Match("<A><B/><C/></A>", "<W><A><B/><C/></A></W>"), "1< 1.1<1 1.1.1<1.1 1.1.2<1.2 ");
}

TEST(TreeMatch, FindsABranchInsideANewParentOfTheSameType) {
  EXPECT_EQ(Match("<A><S><X/><Y/></S></A>", "<A><S><S><X/><Y/></S></S></A>"),
            "1.1< 1.1.1<1.1 1.1.1.1<1.1.1 1.1.1.2<1.1.2 ");
}

TEST(TreeMatch, FindsABranchInsideTwoNewParentsOfTheSameType) {
  EXPECT_EQ(Match("<A><S><X/></S><B/></A>", "<A><S><S><S><X/></S></S></S><B/></A>"),
            "1.1< 1.1.1< 1.1.1.1<1.1 1.1.1.1.1<1.1.1 ");
}

TEST(TreeMatch, FindsOneChangeDeepInATreeOfEqualBranches) {
  const std::string branch = "<S><X/><Y/></S>";
  EXPECT_EQ(Match("<A>" + branch + "<S><X/><Y v='1'/></S>" + branch + "</A>",
                  "<A>" + branch + "<S><X/><Y v='2'/></S>" + branch + "</A>"),
            "");
  EXPECT_EQ(Match("<A>" + branch + branch + "<B/></A>", "<A>" + branch + "<B/></A>"), "1.2<1.3 ");
}

TEST(TreeMatch, HashesTellWhatIsSeenOfANodeFromWhatIsBelowIt) {
  const TreeHashes a = HashTree(*MakeScene("<A x='1'><!-- one --><B y='2'/></A>"));
  const TreeHashes b = HashTree(*MakeScene("<A x='1'><!-- two --><B y='3'/></A>"));
  EXPECT_EQ(a.named, b.named);
  EXPECT_NE(a.whole[0], b.whole[0]);
  EXPECT_NE(a.shown[1], b.shown[1]);
}

TEST(TreeMatch, KnowsANodeOfAnotherTypeByItsChildren) {
  EXPECT_EQ(Match("<A><S><X/><Y/></S></A>", "<A><F><X/><Y/></F></A>"), "");
}

TEST(TreeMatch, AcceptsEmptyTrees) {
  const auto tree = MakeScene("<A/>");
  EXPECT_EQ(MatchTrees({}, *tree).before_of, std::vector<std::uint32_t>{kNoSceneNode});
  EXPECT_EQ(MatchTrees(*tree, {}).after_of, std::vector<std::uint32_t>{kNoSceneNode});
}

}  // namespace
}  // namespace coppice::editor
