#include "editor/scene/notes.h"

#include <gtest/gtest.h>

#include "tests/editor/canvas/make_scene.h"
#include "tests/editor/read_forest.h"

namespace coppice::editor {
namespace {

std::string Note(const std::string& xml, const char* path) {
  const auto scene = MakeScene(xml);
  return scene->nodes[scene->FindPath(path)].note;
}

TEST(Notes, StandAboveWhatTheyAreAbout) {
  EXPECT_EQ(Note("<A><!-- first\n   thing --><B/>\n<C/></A>", "1.1"), "first thing");
  EXPECT_EQ(Note("<A><!-- first --><B/>\n<C/></A>", "1.2"), "");
}

TEST(Notes, OfManyWordsAreCut) {
  const std::string word = "gr\xC3\xBC\xC3\x9F ";
  std::string comment, comments;
  for (int i = 0; i < 100'000; ++i) {
    comment += word;
    comments += "<!--" + word + "-->";
  }
  const std::string note = Note("<A><!--" + comment + "--><B/>\n</A>", "1.1");
  EXPECT_EQ(note.substr(0, 8), word + "g");
  EXPECT_LE(note.size(), 1000U);
  EXPECT_GT(note.size(), 990U);
  EXPECT_LE(Note("<A>" + comments + "<B/>\n</A>", "1.1").size(), 1000U);
}

TEST(Notes, AreTakenTogether) {
  EXPECT_EQ(Note("<A>\n<!-- one -->\n\n<!-- two -->\n<B/></A>", "1.1"), "one two");
}

TEST(Notes, BehindAnElementOnItsLineAreAboutThatOne) {
  const std::string xml = "<A>\n<B/> <!-- of B -->\n<!-- of C -->\n<C/>\n</A>";
  EXPECT_EQ(Note(xml, "1.1"), "of B");
  EXPECT_EQ(Note(xml, "1.2"), "of C");
}

TEST(Notes, BehindAStartTagAreAboutItsElement) {
  const std::string xml = "<A> <!-- of A -->\n<B/>\n</A>";
  EXPECT_EQ(Note(xml, "1"), "of A");
  EXPECT_EQ(Note(xml, "1.1"), "");
}

TEST(Notes, BehindTheLastChildAreAboutTheLastChild) {
  EXPECT_EQ(Note("<A>\n<B/>\n<!-- end -->\n</A>", "1.1"), "end");
}

TEST(Notes, BeforeATreeAreAboutItsRoot) {
  const Forest forest = ReadForest(
      "<root BTCPP_format='4'>\n<!-- the round -->\n<BehaviorTree "
      "ID='T'><A/></BehaviorTree></root>");
  EXPECT_EQ(BuildScene(forest, 0, NodeModels()).nodes[0].note, "the round");
}

TEST(Notes, ALineOfSlashesIsNone) {
  EXPECT_EQ(Note("<A>\n<!-- ////////// -->\n<B/></A>", "1.1"), "");
  EXPECT_EQ(Note("<A>\n<!-- of B -->\n<!-- ========= -->\n<B/></A>", "1.1"), "of B");
  EXPECT_EQ(Note("<A>\n<!-- ä -->\n<B/></A>", "1.1"), "ä");
}

}  // namespace
}  // namespace coppice::editor
