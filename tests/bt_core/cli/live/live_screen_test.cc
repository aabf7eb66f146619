#include "bt_core/cli/live/live_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bt_core/cli/described_tree.h"

namespace coppice {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class LiveScreenTest : public ::testing::Test {
 protected:
  LiveScreenTest() { options_.endpoint = "robot:1667"; }
  std::vector<std::string> Draw() {
    return keeper_.Look([this](const LiveScene& scene) { return DrawScene(scene, options_); });
  }
  void Tick() {
    keeper_.OnTree(SmallTree());
    keeper_.OnState(SmallState());
    keeper_.OnTick(SmallTick().events());
  }

  ScreenOptions options_;
  LiveSceneKeeper keeper_;
};

TEST_F(LiveScreenTest, ShowsTheTreeWithTheRunningPath) {
  Tick();
  EXPECT_THAT(Draw(), ElementsAre("robot:1667  Main  tick 7  RUNNING  2.000 s  5 us",
                                  "> top [Sequence]  RUNNING",   //
                                  "    check [Check]  SUCCESS",  //
                                  ">   Drive::3  RUNNING",       //
                                  R"(  check: all is "well")"));
}

TEST_F(LiveScreenTest, ShowsTheBlackboardIfItIsWanted) {
  Tick();
  options_.shows_board = true;
  EXPECT_THAT(Draw(), ::testing::Contains("  Main/battery = 0.5"));
  keeper_.OnTree(SmallTree());
  keeper_.OnState(SmallState());
  EXPECT_THAT(Draw(), ::testing::Contains("  Main/battery = (no value)"));
}

TEST_F(LiveScreenTest, ShowsWhatAnIdleNodeWasLast) {
  keeper_.OnTree(SmallTree());
  HistoryState state = SmallState();
  state.last[1] = Status::kFailure;
  keeper_.OnState(state);
  EXPECT_THAT(Draw(), ::testing::Contains("    check [Check]  (FAILURE)"));
}

TEST_F(LiveScreenTest, SaysWhyThereIsNothingToSee) {
  LiveConnection connection;
  connection.problem = "no answer from robot:1667";
  keeper_.OnConnection(connection);
  EXPECT_THAT(Draw(), ElementsAre("robot:1667", "no answer from robot:1667"));
}

TEST_F(LiveScreenTest, ShowsWhatOthersHaveLeftInTheRobot) {
  ForeignHook foreign;
  foreign.hook.path = "inner/Alternate::5";
  foreign.hook.enabled = false;
  keeper_.OnForeignHooks({foreign});
  EXPECT_THAT(Draw(), Contains("somebody else's hook at inner/Alternate::5: before (off)"));
}

TEST_F(LiveScreenTest, LeavesOutIdleNodesIfThereIsNoRoom) {
  TreeDescription tree = SmallTree();
  HistoryState state = SmallState();
  for (int i = 0; i < 100; ++i) {
    DescribedNode node = tree.nodes[2];
    node.path = "dock/x" + std::to_string(i);
    node.parent = NodeIndex{2};
    tree.nodes.push_back(node);
    state.statuses.push_back(Status::kIdle);
    state.last.push_back(Status::kIdle);
  }
  keeper_.OnTree(tree);
  keeper_.OnState(state);
  options_.rows = 10;
  const std::vector<std::string> lines = Draw();
  EXPECT_LE(lines.size(), 10u);
  EXPECT_THAT(lines.back(), HasSubstr("more nodes"));
}

TEST_F(LiveScreenTest, CutsLinesAtCharactersAndKeepsTheCursorWhereItIs) {
  keeper_.OnTree(SmallTree());
  keeper_.OnState(SmallState());
  keeper_.Say("größe\x1b[2J\nzwei");
  options_.columns = 9;
  EXPECT_EQ(Draw().back(), R"(  größe\x)");
  options_.columns = 0;
  EXPECT_EQ(Draw().back(), R"(  größe\x1B[2J\nzwei)");
}

TEST_F(LiveScreenTest, ColoursStatuses) {
  Tick();
  options_.has_colours = true;
  EXPECT_THAT(Draw()[2], HasSubstr("\x1b[32m"));
  EXPECT_THAT(Draw(), SizeIs(5));
}

}  // namespace
}  // namespace coppice
