#include "editor/live/why_answer.h"

#include <gtest/gtest.h>

#include "bt_core/live/groot2/groot2_history.h"
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
    NodeIndex i{0};
    while (nodes[i].path != path) ++i;
    return i;
  }

  ExecutedSource* robot_ = nullptr;
  std::unique_ptr<RunView> view_;
  WhyAnswer why_;
};

TEST_F(WhyAnswerTest, TellsTheWalkToTheNodeAndWhatChanged) {
  why_.Ask(*view_, kRootNode);
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

TEST_F(WhyAnswerTest, SaysWhereTheRobotStandsAndNotInThePast) {
  robot_->StopBefore(Node("pass/Drive"));
  view_->Update(HookList(), 2);
  why_.Ask(*view_, kRootNode);
  EXPECT_EQ(why_.stands(), "stopped before \"Drive\"");
  EXPECT_EQ(why_.stands_at(), Node("pass/Drive"));
  view_->playhead().GoToTick(1);
  view_->Update(HookList(), 3);
  why_.Ask(*view_, kRootNode);
  EXPECT_EQ(why_.stands(), "");
}

TEST_F(WhyAnswerTest, FollowsThePlayhead) {
  why_.Ask(*view_, kRootNode);
  view_->playhead().GoToTick(1);
  view_->Update(HookList(), 2);
  why_.Ask(*view_, kRootNode);
  EXPECT_EQ(why_.lines()[0].status, Status::kRunning);
  EXPECT_EQ(why_.change(), "") << "as in the tick before";
}

// A robot with the Groot2 protocol: what its answers to polls hold is told.
class ForeignRobot final : public RunSource {
 public:
  ForeignRobot() {
    EXPECT_EQ(history_
                  .SetTree(RunId{1}, R"(<root BTCPP_format="4">
      <BehaviorTree ID="Main" _fullpath=""><Parallel name="both" _uid="1">
      <Wait name="wait" _uid="2"/><Look name="look" _uid="3"/></Parallel></BehaviorTree></root>)")
                  .problem(),
              "");
    EXPECT_EQ(history_.SetRecording("1000000").problem(), "");
    EXPECT_EQ(history_.AddStatuses(std::string("\1\0\0\2\0\0\3\0\0", 9), Time{}).problem(), "");
  }
  void Change(std::uint64_t microseconds, std::uint16_t uid, Status status) {
    std::string bytes;
    for (int i = 0; i < 6; ++i) bytes += static_cast<char>(microseconds >> (8 * i));
    bytes += {static_cast<char>(uid), 0, static_cast<char>(status)};
    EXPECT_EQ(history_.AddTransitions(bytes).problem(), "");
  }

  const std::string& name() const override { return name_; }
  bool is_robot() const override { return true; }
  void Pump(LiveListener& listener) override { queue_.Deliver(listener); }
  bool has_news() const override { return !queue_.empty(); }
  void Send(LiveCommand, LiveClient::ReplyHandler) override {}

 private:
  const std::string name_ = "robot:1667";
  LiveQueue queue_{nullptr};
  Groot2History history_{queue_, name_};
};

TEST(WhyAnswer, ARobotThatTellsChangesOnlyHasThrownNothing) {
  auto source = std::make_unique<ForeignRobot>();
  source->Change(1000, 2, Status::kRunning);
  source->Change(1000, 1, Status::kRunning);
  source->Change(9000, 3, Status::kFailure);
  RunView view(std::move(source), std::make_shared<NodeModels>());
  view.Update(HookList(), 1);
  WhyAnswer why;
  why.Ask(view, NodeIndex{1});
  EXPECT_TRUE(why.is_untold());
  EXPECT_EQ(why.why_not(),
            "this run holds status changes only, and \"wait\" had none; it may have been ticked");
  EXPECT_EQ(why.changed_node(), 2U);
  EXPECT_NE(why.change().find(R"("look" is FAILURE and was IDLE before)"), std::string::npos)
      << why.change();
  why.Ask(view, NodeIndex{2});
  EXPECT_FALSE(why.is_untold());
  EXPECT_EQ(why.why_not(), "");
}

}  // namespace
}  // namespace coppice::editor
