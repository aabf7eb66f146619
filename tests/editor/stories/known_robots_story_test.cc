#include <gtest/gtest.h>

#include <chrono>

#include "tests/editor/driver.h"
#include "tests/editor/live/live_robot.h"

namespace coppice::editor {
namespace {

constexpr char kTree[] = R"(<BehaviorTree ID="Main"><Do as="work"/></BehaviorTree>)";
constexpr std::int64_t kDate = 1'700'000'000;

class KnownRobotsStory : public testing::Test {
 protected:
  EditorOptions Options(std::int64_t date = kDate) const {
    EditorOptions options;
    options.recent_file = folder_.Path("recent");
    options.date = [date] { return date; };
    return options;
  }

  // With the keys, as the first time.
  void Connect(Driver& driver, const std::string& endpoint) {
    driver.Press('K', kCtrl);
    driver.Frames();
    driver.Type(endpoint);
    driver.Press(kKeyEnter);
    WaitUntilLive(driver);
  }

  void WaitUntilLive(Driver& driver) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < end) {
      robot_.Tick();
      driver.Frames();
      const RunView* const run = driver.editor.state().workspace.run();
      if (run && run->phase() == RunPhase::kLive) return;
    }
    FAIL() << "the robot does not answer";
  }

  static std::string Shown(Driver& driver) {
    const RunView* const run = driver.editor.state().workspace.run();
    return run ? run->name() : "";
  }

  void MeetOnce() {
    Driver driver(Options());
    driver.Frames();
    Connect(driver, robot_.endpoint());
  }

  const TemporaryFolder folder_;
  LiveRobot robot_{kTree};
};

TEST_F(KnownRobotsStory, TheNextTimeTheStartScreenConnectsWithAClick) {
  MeetOnce();
  Driver later(Options(kDate + 7200));
  later.Frames();
  later.Picture("known_robots_start");
  ASSERT_TRUE(later.Click("start/robot/0"));
  WaitUntilLive(later);
  EXPECT_EQ(Shown(later), robot_.endpoint());
}

TEST_F(KnownRobotsStory, TheDialogConnectsByArrowAndEnter) {
  MeetOnce();
  Driver later(Options(kDate + 7200));
  MeetRobot(later.editor.state().recent.robots, {"127.0.0.1:9", "Elsewhere", kDate});
  later.Frames();
  later.Press('K', kCtrl);
  later.Frames();
  EXPECT_EQ(later.editor.state().popup.text, "127.0.0.1:9") << "the one that was met last";
  later.Press(kKeyDown);
  later.Press(kKeyDown);
  later.Frames();
  later.Picture("known_robots_dialog");
  later.Press(kKeyEnter);
  WaitUntilLive(later);
  EXPECT_EQ(Shown(later), robot_.endpoint());
}

TEST_F(KnownRobotsStory, WhatIsTypedIsConnectedToWhateverIsListed) {
  Driver driver(Options());
  MeetRobot(driver.editor.state().recent.robots, {"127.0.0.1:9", "", kDate});
  driver.Frames();
  Connect(driver, robot_.endpoint());
  EXPECT_EQ(Shown(driver), robot_.endpoint());
}

TEST_F(KnownRobotsStory, TheMenuOffersThem) {
  MeetOnce();
  Driver later(Options());
  later.Frames();
  ASSERT_TRUE(later.Click("menu/file"));
  ASSERT_TRUE(later.Click("menu/robot.known"));
  later.Frames();
  ASSERT_TRUE(later.Click("menu/robot/0"));
  WaitUntilLive(later);
  EXPECT_EQ(Shown(later), robot_.endpoint());
}

TEST_F(KnownRobotsStory, OneThatIsForgottenIsNotOfferedAgain) {
  MeetOnce();
  {
    Driver later(Options());
    later.Frames();
    ASSERT_TRUE(later.Click("start/robot/0/forget"));
    later.Frames();
    EXPECT_FALSE(later.Has("start/robot/0"));
  }
  Driver again(Options());
  again.Frames();
  EXPECT_FALSE(again.Has("start/robot/0"));
}

TEST_F(KnownRobotsStory, KeysForgetOne) {
  MeetOnce();
  Driver later(Options());
  later.Frames();
  later.Press('P', kCtrl);
  later.Type("forget a robot");
  later.Press(kKeyEnter);
  later.Frames();
  later.Press(kKeyEnter);
  later.Frames();
  EXPECT_FALSE(later.Has("start/robot/0"));
}

TEST_F(KnownRobotsStory, OneThatNeverAnsweredIsNotRemembered) {
  Driver driver(Options());
  driver.Frames();
  driver.Press('K', kCtrl);
  driver.Frames();
  driver.Type("127.0.0.1:9");
  driver.Press(kKeyEnter);
  driver.Frames(20);
  ASSERT_EQ(Shown(driver), "127.0.0.1:9");
  EXPECT_TRUE(driver.editor.state().recent.robots.empty());
}

}  // namespace
}  // namespace coppice::editor
