// Robots that come and go, and what is looked up while they run.
#include <gtest/gtest.h>

#include <chrono>
#include <memory>

#include "tests/editor/driver.h"
#include "tests/editor/executed_source.h"
#include "tests/editor/gallery/drawn_text.h"
#include "tests/editor/live/live_robot.h"

namespace coppice::editor {
namespace {

constexpr char kBefore[] = R"(<BehaviorTree ID="Main"><Do as="work"/></BehaviorTree>)";
constexpr char kAfter[] =
    R"(<BehaviorTree ID="Main"><Sequence><Do as="work"/><Do as="rest"/></Sequence></BehaviorTree>)";

class RestartStory : public testing::Test {
 protected:
  void Start(const std::string& tree, std::uint16_t port = 0) {
    robot_ = std::make_unique<LiveRobot>(tree, port);
  }

  // As people wait: until it is so.
  template <class Is>
  bool Await(const Is& is) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (std::chrono::steady_clock::now() < end) {
      if (robot_) robot_->Tick();
      driver_.Frames(1);
      if (is()) return true;
    }
    return false;
  }
  RunPhase Phase() {
    const RunView* const run = driver_.editor.state().workspace.run();
    return run ? run->phase() : RunPhase::kConnecting;
  }
  bool IsLive() { return Phase() == RunPhase::kLive; }

  void Connect() {
    driver_.Frames();
    driver_.Press('K', kCtrl);
    driver_.Frames();
    driver_.Type(robot_->endpoint());
    driver_.Press(kKeyEnter);
    ASSERT_TRUE(Await([this] { return IsLive(); }));
  }

  std::unique_ptr<LiveRobot> robot_;
  Driver driver_;
};

TEST_F(RestartStory, ARobotThatComesBackWithAnotherTreeIsShownAgain) {
  Start(kBefore);
  Connect();
  const std::uint16_t port = robot_->port();
  robot_.reset();
  ASSERT_TRUE(Await([this] { return !IsLive(); }));
  Start(kAfter, port);
  ASSERT_TRUE(Await([this] { return IsLive() && driver_.Has("canvas/Main/1.2"); }));
  EXPECT_TRUE(driver_.Has("strip/" + robot_->endpoint()));
  driver_.Picture("story_robot_came_back");
}

TEST_F(RestartStory, ABreakpointIsSetBeforeTheRobotIsThereAndStopsIt) {
  Start(kBefore);
  Connect();
  const std::uint16_t port = robot_->port();
  ASSERT_TRUE(Await([this] { return driver_.Has("canvas/Main/1"); }));
  ASSERT_TRUE(driver_.Click("canvas/Main/1"));
  driver_.Press(kKeyF1 + 8);
  driver_.Frames();
  robot_.reset();
  ASSERT_TRUE(Await([this] { return !IsLive(); }));
  Start(kBefore, port);
  robot_->StartTicking();
  const auto stands = [this] { return driver_.Has("strip/stopped"); };
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!stands() && std::chrono::steady_clock::now() < end) driver_.Frames(1);
  EXPECT_TRUE(stands());
  driver_.Press('W');
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("run/why/stands"));
  driver_.Picture("story_stands_on_a_robot");
  driver_.Press(kKeyF1 + 8);  // takes it away, so that the robot can end
  driver_.Press(kKeyF1 + 4);
  driver_.Frames();
}

TEST(SeveralRobotsStory, EachHasATabAndKeysGoRound) {
  Driver driver;
  driver.AddRobot("one:1", kLiveTree);
  driver.AddRobot("two:2", kLiveTree);
  driver.Frames();
  const auto shown = [&] { return driver.editor.state().workspace.run()->name(); };
  ASSERT_TRUE(driver.Click("strip/one:1"));
  EXPECT_EQ(shown(), "one:1");
  driver.Press(kKeyTab, kCtrl);
  EXPECT_EQ(shown(), "two:2");
  driver.Press(kKeyTab, kCtrl);
  EXPECT_EQ(shown(), "one:1");
  driver.Press('W', kCtrl);
  EXPECT_FALSE(driver.Has("strip/one:1"));
}

TEST(RunningStory, TheListOfWhatRunsLeadsThere) {
  Driver driver;
  AddExecuted(driver, "robot:1", 10);
  driver.Frames();
  driver.Press('N');
  driver.Frames();
  ASSERT_TRUE(driver.Click("run/running/pass/Drive"));
  EXPECT_EQ(driver.Selected(), "1.2.1");
}

TEST(RunningStory, FollowingGoesWhereItRuns) {
  Driver driver;
  AddExecuted(driver, "robot:1", 10);
  driver.Frames();
  driver.view().camera.offset = {5000, 5000};
  driver.Frames(2);
  ASSERT_FALSE(driver.Has("canvas/Main/1.2.1"));
  ASSERT_TRUE(driver.Click("canvasbar/follow"));
  driver.Frames(400);
  EXPECT_TRUE(driver.Has("canvas/Main/1.2.1"));
}

TEST(KeyOfTheSelectionStory, TheBlackboardShowsOnlyWhatTheNodeUses) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  robot->Write("Main", "goal", "door");
  robot->Write("Main", "weather", "rain");
  driver.Frames(6);
  ASSERT_TRUE(driver.Has("blackboard/Main/weather"));
  ASSERT_TRUE(driver.Click("canvas/Main/1.2"));
  driver.Press('B');
  driver.Frames();
  EXPECT_TRUE(driver.Has("blackboard/Main/goal"));
  EXPECT_FALSE(driver.Has("blackboard/Main/weather"));
}

// What is written within the box of a node.
std::string WrittenOn(const Driver& driver, const std::string& path) {
  const Box box = driver.BoxOf(path);
  std::string text;
  for (const DrawnGlyph& glyph : DrawnText(driver.editor)) {
    if (box.Contains(glyph.box.center()) && glyph.code < 0x80)
      text += static_cast<char>(glyph.code);
  }
  return text;
}

TEST(LivePortsStory, PortsOfARunShowWhatTheirKeysHoldAndGoBackInTimeWithIt) {
  Driver driver;
  auto source = std::make_unique<ExecutedSource>("robot:1", R"(<BehaviorTree ID="Main"><Sequence>
    <Script code="n := '0'"/><KeepRunningUntilFailure><Sequence><Do as="{n}"/>
    <Script code="n = n + '1'"/></Sequence></KeepRunningUntilFailure></Sequence></BehaviorTree>)");
  ExecutedSource& robot = *source;
  driver.editor.AddRun(std::move(source));
  robot.Ticks(3);
  driver.Frames(20);
  driver.Picture("live_ports");
  const std::string node = "canvas/Main/1.2.1.1";
  EXPECT_NE(WrittenOn(driver, node).find("0111"), std::string::npos) << WrittenOn(driver, node);
  EXPECT_EQ(WrittenOn(driver, node).find("{n}"), std::string::npos);
  driver.Press(kKeyLeft);
  driver.Frames();
  EXPECT_EQ(WrittenOn(driver, node).find("0111"), std::string::npos) << WrittenOn(driver, node);
  EXPECT_NE(WrittenOn(driver, node).find("011"), std::string::npos) << WrittenOn(driver, node);
}

}  // namespace
}  // namespace coppice::editor
