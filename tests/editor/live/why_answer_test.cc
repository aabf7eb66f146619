#include "editor/live/why_answer.h"

#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

class WhyAnswerTest : public testing::Test {
 protected:
  WhyAnswerTest() {
    auto source = std::make_unique<ExecutedSource>("robot:1", kDoorTrees);
    robot_ = source.get();
    view_ = std::make_unique<RunView>(std::move(source), std::make_shared<NodeModels>());
    robot_->tree.results["drive"] = Status::kRunning;
    robot_->Ticks(3);
    robot_->tree.results["drive"] = Status::kFailure;
    robot_->Ticks(1);
    view_->Update(HookList(), 1);
  }
  NodeIndex Node(const std::string& path) const {
    const auto& nodes = view_->tree()->description()->nodes;
    NodeIndex i = 0;
    while (nodes[i].path != path) ++i;
    return i;
  }

  ExecutedSource* robot_ = nullptr;
  std::unique_ptr<RunView> view_;
  WhyAnswer why_;
};

TEST_F(WhyAnswerTest, TellsTheWalkToTheNodeAndWhatChanged) {
  why_.Ask(*view_, 0);
  ASSERT_FALSE(why_.lines().empty());
  EXPECT_EQ(why_.lines()[0].name, "mission");
  EXPECT_EQ(why_.lines()[0].status, Status::kFailure);
  EXPECT_TRUE(why_.lines()[0].is_asked);
  EXPECT_NE(why_.lines()[0].reason.find("pass"), std::string::npos) << why_.lines()[0].reason;
  EXPECT_NE(why_.change().find("Drive"), std::string::npos) << why_.change();
  EXPECT_EQ(why_.changed_node(), Node("pass/Drive"));
  EXPECT_EQ(why_.why_not(), "");
}

TEST_F(WhyAnswerTest, TellsWhyANodeWasNotTicked) {
  why_.Ask(*view_, Node("OpenDoor"));
  EXPECT_NE(why_.why_not(), "");
}

TEST_F(WhyAnswerTest, FollowsThePlayhead) {
  why_.Ask(*view_, 0);
  view_->playhead().GoToTick(1);
  view_->Update(HookList(), 2);
  why_.Ask(*view_, 0);
  EXPECT_EQ(why_.lines()[0].status, Status::kRunning);
  EXPECT_EQ(why_.change(), "") << "as in the tick before";
}

}  // namespace
}  // namespace coppice::editor
