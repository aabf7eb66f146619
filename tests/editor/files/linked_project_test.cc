#include "editor/files/linked_project.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace coppice::editor {
namespace {

using testing::ElementsAre;

std::string Tree(const std::string& id, const std::string& nodes) {
  return "<BehaviorTree ID=\"" + id + "\">" + nodes + "</BehaviorTree>";
}

class LinkedProjectTest : public testing::Test {
 protected:
  std::string Open(const std::string& name, const std::string& trees) {
    const std::string path = folder_.Path(name);
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    WriteFile(path, "<root BTCPP_format=\"4\">" + trees + "</root>");
    EXPECT_TRUE(files_.Open(path, diagnostics_)) << diagnostics_.ToString();
    return path;
  }

  // The IDs of all trees that a file can use.
  std::vector<std::string> TreesOf(const std::string& path) {
    const auto linked = ReadLinked(files_, path, diagnostics_);
    std::vector<std::string> ids;
    if (!linked) return ids;
    for (const auto& [id, tree] : linked->project.trees()) ids.push_back(id);
    return ids;
  }

  const TemporaryFolder folder_;
  OpenProject files_;
  Diagnostics diagnostics_;
};

TEST_F(LinkedProjectTest, HasTheTreesThatAreMissingFromOtherOpenFiles) {
  const std::string pick = Open("pick.xml", Tree("Pick", R"(<SubTree ID="Open Gripper"/>)"));
  EXPECT_THAT(TreesOf(pick), ElementsAre("Pick"));
  Open("open_gripper.xml", Tree("Open Gripper", R"(<SubTree ID="Move"/>)"));
  Open("move.xml", Tree("Move", "<AlwaysSuccess/>"));
  Open("unneeded.xml", Tree("Unneeded", "<AlwaysSuccess/>"));
  EXPECT_THAT(TreesOf(pick), ElementsAre("Move", "Open Gripper", "Pick"));
  EXPECT_EQ(ReadLinked(files_, pick, diagnostics_)->own_documents, 1U);
  EXPECT_FALSE(diagnostics_.has_errors()) << diagnostics_.ToString();
}

TEST_F(LinkedProjectTest, KeepsTheMainTreeOfTheFile) {
  const std::string pick = Open("pick.xml", Tree("Pick", R"(<SubTree ID="Move"/>)"));
  const std::string move = folder_.Path("move.xml");
  WriteFile(move, R"(<root BTCPP_format="4" main_tree_to_execute="Move">)" +
                      Tree("Move", "<AlwaysSuccess/>") + "</root>");
  ASSERT_TRUE(files_.Open(move, diagnostics_));
  EXPECT_EQ(ReadLinked(files_, pick, diagnostics_)->main_tree, "Pick");
}

// Every file of Nav2 has a tree of that name.
TEST_F(LinkedProjectTest, LeavesOutAFileWhoseOtherTreesWouldComeTwice) {
  const std::string main = Open("a.xml", Tree("MainTree", R"(<SubTree ID="Move"/>)"));
  Open("b.xml", Tree("MainTree", "<AlwaysSuccess/>") + Tree("Move", "<AlwaysFailure/>"));
  EXPECT_THAT(TreesOf(main), ElementsAre("MainTree"));
  Open("c.xml", Tree("Move", "<AlwaysSuccess/>"));
  EXPECT_THAT(TreesOf(main), ElementsAre("MainTree", "Move"));
}

TEST_F(LinkedProjectTest, EndsWithTheProject) {
  const std::string here = Open("here/a.xml", Tree("A", R"(<SubTree ID="B"/>)"));
  Open("there/b.xml", Tree("B", "<AlwaysSuccess/>"));
  EXPECT_THAT(TreesOf(here), ElementsAre("A"));
  std::filesystem::create_directories(folder_.Path(".git"));  // now both are of one
  EXPECT_THAT(TreesOf(here), ElementsAre("A", "B"));
}

TEST_F(LinkedProjectTest, SaysNothingOfWhatIsWrongWithTheOthers) {
  const std::string pick = Open("pick.xml", Tree("Pick", R"(<SubTree ID="Move"/>)"));
  Open("move.xml", R"(<include path="nowhere.xml"/>)" + Tree("Move", "<AlwaysSuccess/>"));
  EXPECT_THAT(TreesOf(pick), ElementsAre("Pick"));
  EXPECT_EQ(diagnostics_.ToString(), "");
}

TEST(MissingTrees, AreThoseThatNoTreeIs) {
  Diagnostics diagnostics;
  const auto project = Project::FromText(
      "<root BTCPP_format=\"4\">" +
          Tree("A", R"(<Sequence><SubTree ID="B"/><SubTree ID="C"/><SubTree ID="B"/></Sequence>)") +
          Tree("C", "<AlwaysSuccess/>") + "</root>",
      "a.xml", diagnostics);
  EXPECT_THAT(MissingTrees(*project), ElementsAre("B"));
}

TEST(ProjectFolder, IsTheWorkingTreeOfGitOrElseTheFolderOfTheFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.Path("robot/.git"));
  std::filesystem::create_directories(folder.Path("robot/trees/deep"));
  EXPECT_EQ(ProjectFolder(folder.Path("robot/trees/deep/a.xml")), folder.Path("robot"));
  EXPECT_EQ(ProjectFolder(folder.Path("b.xml")), folder.path());
}

}  // namespace
}  // namespace coppice::editor
