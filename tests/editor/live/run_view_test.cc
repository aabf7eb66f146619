// Runs of real robots: real trees, real sockets, in this process.
#include "editor/live/run_view.h"

#include <gtest/gtest.h>

#include "bt_core/frames/pause_note.h"
#include "editor/live/robot_source.h"
#include "tests/editor/live/live_robot.h"

namespace coppice::editor {
namespace {

constexpr char kTrees[] = R"(<BehaviorTree ID="Main"><ReactiveSequence name="top">
  <Is as="ready" name="ready"/><SubTree ID="Sub" name="sub"/></ReactiveSequence></BehaviorTree>
  <BehaviorTree ID="Sub"><Do as="work" name="work" count="{count}"/></BehaviorTree>)";

class RunViewTest : public testing::Test {
 protected:
  static std::unique_ptr<RunView> Open(const std::string& endpoint, bool groot2_only = false) {
    LiveClientOptions options = RobotSource::DefaultOptions();
    options.groot2_only = groot2_only;
    return std::make_unique<RunView>(std::make_unique<RobotSource>(endpoint, nullptr, options),
                                     std::make_shared<NodeModels>());
  }

  // Lets frames go by until it holds.
  template <class Condition>
  bool Await(RunView& view, Condition holds, LiveRobot* ticked = nullptr) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (!holds()) {
      if (std::chrono::steady_clock::now() > end) return false;
      if (ticked) ticked->Tick();
      view.Update(hooks_, now_ += 0.02);
      std::this_thread::yield();
    }
    return true;
  }

  static Hook At(const std::string& path) {
    Hook hook;
    hook.path = path;
    return hook;
  }

  HookList hooks_;
  double now_ = 0;
};

TEST_F(RunViewTest, KeepsALiveRunSoThatTheUserCanGoBack) {
  LiveRobot robot(kTrees);
  const auto view = Open(robot.endpoint());
  EXPECT_EQ(view->phase(), RunPhase::kConnecting);
  ASSERT_TRUE(Await(
      *view, [&] { return view->run().size() >= 20; }, &robot));
  EXPECT_EQ(view->phase(), RunPhase::kLive);
  EXPECT_EQ(view->tree()->description()->nodes.size(), 4U);
  EXPECT_EQ(view->state().states[0].status, Status::kSuccess);
  robot.tree.results["ready"] = Status::kFailure;
  ASSERT_TRUE(Await(
      *view, [&] { return view->state().states[0].status == Status::kFailure; }, &robot));
  view->playhead().GoToTick(3);
  view->Update(hooks_, now_);
  EXPECT_EQ(view->state().states[0].status, Status::kSuccess) << "the past as it was";
  EXPECT_EQ(view->state().now, view->run().TimeOf(3));
}

TEST_F(RunViewTest, FollowsARobotThatKnowsTheGroot2ProtocolOnly) {
  LiveRobot robot(kTrees);
  const auto view = Open(robot.endpoint(), true);
  ASSERT_TRUE(Await(
      *view, [&] { return view->run().size() >= 3; }, &robot));
  EXPECT_EQ(view->connection().protocol, LiveConnection::Protocol::kGroot2);
  EXPECT_EQ(view->tree()->description()->nodes.size(), 4U);
}

TEST_F(RunViewTest, GoesOnBehindARobotThatWasStartedAnew) {
  std::uint16_t port = 0;
  std::unique_ptr<RunView> view;
  std::size_t before = 0;
  {
    LiveRobot robot(kTrees);
    port = robot.port();
    view = Open(robot.endpoint());
    ASSERT_TRUE(Await(
        *view, [&] { return view->run().size() >= 5; }, &robot));
    before = view->run().size();
  }
  ASSERT_TRUE(Await(*view, [&] { return view->phase() == RunPhase::kReconnecting; }));
  EXPECT_FALSE(view->state().is_fresh);
  EXPECT_GE(view->run().size(), before) << "what is known stays";
  LiveRobot again(kTrees, port);
  ASSERT_TRUE(Await(
      *view, [&] { return view->phase() == RunPhase::kLive; }, &again));
  const std::size_t old = view->run().size();
  ASSERT_TRUE(Await(
      *view, [&] { return view->run().size() > old; }, &again));
  ASSERT_FALSE(view->run().breaks().empty());
  EXPECT_TRUE(view->run().breaks().back().is_other_run);
  EXPECT_FALSE(view->run().breaks().back().is_other_tree);
}

TEST_F(RunViewTest, ABreakpointThatWasThereBeforeTheRobotStopsIt) {
  hooks_.Add("", At("sub/work"));
  LiveRobot robot(kTrees);
  const auto view = Open(robot.endpoint());
  robot.StartTicking();
  ASSERT_TRUE(Await(*view, [&] {
    return view->run().has_tree() && view->stop().where == DebugStop::Where::kBefore;
  }));
  EXPECT_EQ(view->stop_path(), "sub/work");
  const auto has_mark = [&](auto mark) {
    return view->state().states.size() > 3 && (view->state().states[3].marks & mark) != 0;
  };
  EXPECT_TRUE(Await(*view, [&] { return has_mark(kBreakpointMark) && has_mark(kStopMark); }));
  ASSERT_TRUE(
      Await(*view, [&] { return view->hooks().Find(1) && view->hooks().Find(1)->hits > 0; }));
  hooks_.Remove(1);
  ASSERT_TRUE(Await(*view, [&] { return view->stop().where == DebugStop::Where::kNowhere; }));
}

TEST_F(RunViewTest, TheFiguresKnowThatTheRobotStoodAtABreakpoint) {
  hooks_.Add("", At("sub/work"));
  LiveRobot robot(kTrees);
  const auto view = Open(robot.endpoint());
  robot.StartTicking();
  ASSERT_TRUE(Await(*view, [&] { return view->stop().where == DebugStop::Where::kBefore; }));
  hooks_.Remove(1);
  const auto& notes = view->run().recording().notes();
  ASSERT_TRUE(Await(*view, [&] { return !notes.empty(); }));
  EXPECT_TRUE(PauseOf(notes[0].note)) << notes[0].note.kind << ": " << notes[0].note.text;
}

TEST_F(RunViewTest, AForcedResultIsInTheHistory) {
  Hook fault = At("ready");
  fault.action = HookAction::kReplace;
  fault.status = Status::kFailure;
  hooks_.Add("", fault);
  LiveRobot robot(kTrees);
  const auto view = Open(robot.endpoint());
  robot.StartTicking();
  ASSERT_TRUE(Await(*view, [&] {
    return view->run().has_tree() && !view->run().TracksAt(0).injections().empty();
  }));
  EXPECT_EQ(view->run().TracksAt(0).injections()[0].node, 1U);
  view->Update(hooks_, now_);
  EXPECT_TRUE(view->state().states[1].marks & kFaultMark);
}

TEST_F(RunViewTest, ARunThatHasBecomeTooLongIsFollowedNoFurther) {
  LiveRobot robot(kTrees);
  const auto view = Open(robot.endpoint());
  ASSERT_TRUE(Await(
      *view, [&] { return view->run().size() >= 1; }, &robot));
  view->set_most_bytes(view->run().bytes() + 1000);
  ASSERT_TRUE(Await(
      *view, [&] { return view->phase() == RunPhase::kLeft; }, &robot));
  EXPECT_NE(view->connection().problem.find("connect again"), std::string::npos);
  const std::size_t size = view->run().size();
  robot.Tick();
  view->Update(hooks_, now_);
  EXPECT_EQ(view->run().size(), size);
  EXPECT_EQ(view->state().states[0].status, Status::kSuccess) << "what is known stays";
  view->Send(MakeCommand(LiveCommand::Kind::kPause));
  std::string answer;
  ASSERT_TRUE(Await(*view, [&] { return !(answer = view->TakeAnswer()).empty(); }));
  EXPECT_NE(answer.find("connect again"), std::string::npos) << answer;
}

TEST_F(RunViewTest, ARefusedCommandSaysWhy) {
  LiveRobot robot(kTrees);
  const auto view = Open(robot.endpoint());
  ASSERT_TRUE(Await(
      *view, [&] { return view->run().size() >= 1; }, &robot));
  view->Send(WriteKey("", "nokey", "1"));
  std::string answer;
  ASSERT_TRUE(Await(
      *view, [&] { return !(answer = view->TakeAnswer()).empty(); }, &robot));
  EXPECT_NE(answer.find("nokey"), std::string::npos) << answer;
}

}  // namespace
}  // namespace coppice::editor
