#include "editor/document/project_names.h"

#include <gmock/gmock.h>

#include "tests/editor/document/drafts.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;

constexpr char kMain[] = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
<BehaviorTree ID="Main"><Sequence>
  <SubTree ID="Walk" goal="{place}"/>
  <SubTree ID="Walk" goal="{=}" name="Walk"/>
  <SubTree ID="Rest" _autoremap="True"/>
  <Beep goal="{goal}"/>
</Sequence></BehaviorTree></root>)";
constexpr char kWalk[] = R"(<root BTCPP_format="4">
<BehaviorTree ID="Walk"><Go to="{goal}" _skipIf="goal == @goal"/></BehaviorTree>
<BehaviorTree ID="Rest"><Sit goal="{goal}"/></BehaviorTree>
<TreeNodesModel><SubTree ID="Walk"/></TreeNodesModel></root>)";

class ProjectNamesTest : public testing::Test {
 protected:
  std::string After(const std::vector<Edit>& edits, std::size_t file) {
    return Apply(edits[file], files_[file].text());
  }
  const ProjectFiles files_ = {Parsed(kMain), Parsed(kWalk)};
  const NodeModels models_;
};

TEST_F(ProjectNamesTest, FindTreesAndTheirUses) {
  EXPECT_EQ(TreesIn(files_).size(), 3U);
  EXPECT_EQ(TreesCalled(files_, "Walk").size(), 1U);
  EXPECT_EQ(TreesCalled(files_, "Walk")[0].file, 1U);
  EXPECT_EQ(SubTreesOf(files_, "Walk").size(), 2U);
  EXPECT_EQ(CallersOf(files_, "Walk").ports, std::set<std::string>{"goal"});
  EXPECT_TRUE(CallersOf(files_, "Rest").autoremap);
  EXPECT_FALSE(CallersOf(files_, "Rest").none);
  EXPECT_TRUE(CallersOf(files_, "Main").none);
}

TEST_F(ProjectNamesTest, ATreeIsRenamedInAllFiles) {
  const auto edits = RenameTree(files_, "Walk", "Stroll");
  EXPECT_THAT(After(edits, 0), HasSubstr(R"(<SubTree ID="Stroll" goal="{=}" name="Walk"/>)"));
  EXPECT_THAT(After(edits, 1), HasSubstr(R"(<BehaviorTree ID="Stroll">)"));
  EXPECT_THAT(After(edits, 1), HasSubstr(R"(<TreeNodesModel><SubTree ID="Stroll"/>)"));
  EXPECT_THAT(After(RenameTree(files_, "Main", "M"), 0), HasSubstr(R"(main_tree_to_execute="M")"));
}

TEST_F(ProjectNamesTest, AKeyOfATreeIsRenamedWithThePortsOfItsSubTrees) {
  const auto edits =
      RenameKey(files_, models_, TreesCalled(files_, "Walk")[0], "goal", "target").value();
  EXPECT_THAT(After(edits, 1), HasSubstr(R"(<Go to="{target}" _skipIf="target == @goal"/>)"));
  EXPECT_THAT(After(edits, 1), HasSubstr(R"(<Sit goal="{goal}"/>)"));
  EXPECT_THAT(After(edits, 0), HasSubstr(R"(<SubTree ID="Walk" target="{place}"/>)"));
  EXPECT_THAT(After(edits, 0), HasSubstr(R"(target="{goal}" name)"));
}

TEST_F(ProjectNamesTest, TreesThatShareTheKeyByAutoremapAreRenamedToo) {
  const auto edits = RenameKey(files_, models_, {0, ElementIndex{1}}, "goal", "target").value();
  EXPECT_THAT(After(edits, 0), HasSubstr(R"(<SubTree ID="Walk" goal="{place}"/>)"));
  EXPECT_THAT(After(edits, 0), HasSubstr(R"(<SubTree ID="Walk" goal="{target}" name)"));
  EXPECT_THAT(After(edits, 0), HasSubstr(R"(<Beep goal="{target}"/>)"));
  EXPECT_THAT(After(edits, 1), HasSubstr(R"(<Sit goal="{target}"/>)"));
  EXPECT_THAT(After(edits, 1), HasSubstr(R"(<Go to="{goal}")"));
}

TEST_F(ProjectNamesTest, ANameThatIsTakenOrNoneIsRefused) {
  EXPECT_THAT(RenameKey(files_, models_, {0, ElementIndex{1}}, "goal", "place").problem(),
              HasSubstr("already"));
  EXPECT_NE(RenameKey(files_, models_, {0, ElementIndex{1}}, "goal", "two words").problem(), "");
}

}  // namespace
}  // namespace coppice::editor
