#include "editor/diff/tree_diff.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/editor/canvas/make_scene.h"

namespace coppice::editor {
namespace {

std::string Diff(const std::string& before, const std::string& after) {
  const auto a = MakeScene(before);
  const auto b = MakeScene(after);
  std::string text;
  for (const NodeDiff& diff : DiffTrees(*a, *b)) text += ToString(diff, *a, *b) + "\n";
  return text;
}

// "1 A, 1.1 B +": paths and names of the merged tree, with the sign of what became of them.
std::string Merged(const std::string& before, const std::string& after) {
  const auto a = MakeScene(before);
  const auto b = MakeScene(after);
  const MergedTree merged = MergeTrees(*a, *b);
  std::string text;
  for (std::size_t i = 0; i < merged.kinds.size(); ++i) {
    const SceneNode& node = merged.scene.nodes[i];
    text += node.path + " " + std::string(node.name);
    if (merged.kinds[i]) text += std::string(" ") + "+->~"[merged.kinds[i] - 1];
    text += i + 1 < merged.kinds.size() ? ", " : "";
  }
  return text;
}

TEST(TreeDiff, SaysNothingAboutTheSameTree) {
  EXPECT_EQ(Diff("<A><B x='1'/><C/></A>", "<A>\n  <B x='1'/> <C/></A>"), "");
}

TEST(TreeDiff, NamesWhatCameAndWhatWent) {
  EXPECT_EQ(Diff("<A><B/><C/></A>", "<A><B/><D/><C/></A>"), "+ 1.2 D\n");
  EXPECT_EQ(Diff("<A><B/><C/></A>", "<A><C/></A>"), "- 1.1 B\n");
}

TEST(TreeDiff, NamesTheAttributesThatChanged) {
  EXPECT_EQ(Diff("<A><R n='3' m='1'/></A>", "<A><R n='5' k='2'/></A>"),
            "~ 1.1 R: n \"3\" -> \"5\", m \"1\" -> \"\", k \"\" -> \"2\"\n");
  EXPECT_EQ(Diff("<A><R name='x'/></A>", "<A><R name='y'/></A>"), "~ 1.1 y: name \"x\" -> \"y\"\n");
}

TEST(TreeDiff, NamesATypeThatChangedAroundTheSameChildren) {
  EXPECT_EQ(Diff("<A><S><X/><Y/></S></A>", "<A><F><X/><Y/></F></A>"),
            "~ 1.1 F: type \"S\" -> \"F\"\n");
}

TEST(TreeDiff, NamesTheOneThatMovedAmongItsSiblings) {
  EXPECT_EQ(Diff("<A><B/><C/><D/></A>", "<A><D/><B/><C/></A>"), "> 1.1 D (was 1.3)\n");
}

TEST(TreeDiff, CallsMovedWhatStandsAtAnotherNumber) {
  EXPECT_EQ(Diff("<A><B/><C/></A>", "<A><D/><C/><B/></A>"), "+ 1.1 D\n> 1.3 B (was 1.1)\n");
  EXPECT_EQ(Diff("<A><D/><C/><B/></A>", "<A><B/><C/></A>"), "> 1.1 B (was 1.3)\n- 1.1 D\n");
}

TEST(TreeDiff, NamesABranchThatMovedToAnotherParentOnce) {
  EXPECT_EQ(Diff("<A><S><X y='1'/></S><F/></A>", "<A><S/><F><X y='1'/></F></A>"),
            "> 1.2.1 X (was 1.1.1)\n");
}

TEST(TreeDiff, DoesNotCallWrappingAndUnwrappingAMove) {
  EXPECT_EQ(Diff("<A><B/><C/></A>", "<A><W><B/></W><C/></A>"), "+ 1.1 W\n");
  EXPECT_EQ(Diff("<A><W><B/></W><C/></A>", "<A><B/><C/></A>"), "- 1.1 W\n");
  EXPECT_EQ(Diff("<A><B/></A>", "<W><A><B/></A></W>"), "+ 1 W\n");
}

TEST(TreeDiff, NamesMoveAndChangeOfOneNode) {
  EXPECT_EQ(Diff("<A><B x='1'/><C/><D/></A>", "<A><C/><D/><B x='2'/></A>"),
            "> 1.3 B (was 1.1)\n~ 1.3 B: x \"1\" -> \"2\"\n");
}

TEST(TreeDiff, MergesRemovedNodesWhereTheyWere) {
  EXPECT_EQ(Merged("<A><B/><C/><D/></A>", "<A><B/><D/><E/></A>"),
            "1 A, 1.1 B, 1.2 C -, 1.3 D, 1.4 E +");
  EXPECT_EQ(Merged("<A><B><X/><Y/></B></A>", "<A><C/></A>"),
            "1 A, 1.1 B -, 1.1.1 X -, 1.1.2 Y -, 1.2 C +");
}

TEST(TreeDiff, MergesARootThatIsGone) {
  EXPECT_EQ(Merged("<W><A><B/></A><C/></W>", "<A><B/></A>"), "1 W -, 1.1 A, 1.1.1 B, 1.2 C -");
  EXPECT_EQ(Merged("<A><B/></A>", "<C><D/></C>"), "1 C +, 1.1 D +, 1.2 A -, 1.2.1 B -");
}

TEST(TreeDiff, MergesTreesOfWhichOneIsEmpty) {
  const auto tree = MakeScene("<A><B/></A>");
  const Scene empty;
  EXPECT_EQ(MergeTrees(*tree, empty).kinds, (std::vector<std::uint8_t>{2, 2}));
  EXPECT_EQ(MergeTrees(empty, *tree).kinds, (std::vector<std::uint8_t>{1, 1}));
  EXPECT_EQ(MergeTrees(empty, empty).kinds.size(), 0U);
}

TEST(TreeDiff, AMergedTreeSaysOldAndNew) {
  const auto a = MakeScene("<S name='go'><X/><Y/><R n='3' m='{k}'/></S>");
  const auto b = MakeScene("<F name='come'><X/><Y/><R n='5' x='1'/></F>");
  const MergedTree merged = MergeTrees(*a, *b);
  EXPECT_EQ(merged.scene.nodes[0].name, "come (was S, go)");
  std::string ports;
  for (std::uint32_t p = 0; p < merged.scene.nodes[3].port_count; ++p) {
    const PortLine& port = merged.scene.ports[merged.scene.nodes[3].first_port + p];
    ports += std::string(port.name) + "=" + std::string(port.value) + ";";
  }
  EXPECT_EQ(ports, "n=3 \u2192 5;x=(none) \u2192 1;m={k} \u2192 (none);");
}

// A tree of a few types and values; equal numbers give equal trees.
std::string RandomTree(std::mt19937& random, int depth) {
  const char type = static_cast<char>('A' + random() % 5);
  std::string xml = std::string("<") + type + " p='" + std::to_string(random() % 3) + "'>";
  for (unsigned i = depth > 0 ? random() % 4 : 0; i > 0; --i) xml += RandomTree(random, depth - 1);
  return xml + "</" + type + ">";
}

TEST(TreeDiff, AMergedTreeHasEveryNodeOfBothVersionsOnce) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    const auto a = MakeScene(RandomTree(random, 4));
    const auto b = MakeScene(RandomTree(random, 4));
    std::size_t removed = 0;
    for (const NodeDiff& diff : DiffTrees(*a, *b)) removed += diff.kind == DiffKind::kRemoved;
    const MergedTree merged = MergeTrees(*a, *b);
    ASSERT_EQ(merged.scene.nodes.size(), b->nodes.size() + removed) << round;
    ASSERT_EQ(merged.scene.nodes[0].end, merged.scene.nodes.size());
    for (std::uint32_t i = 1; i < merged.scene.nodes.size(); ++i) {
      const SceneNode& node = merged.scene.nodes[i];
      ASSERT_LT(node.parent, i);
      ASSERT_LE(node.end, merged.scene.nodes[node.parent].end);
    }
  }
}

}  // namespace
}  // namespace coppice::editor
