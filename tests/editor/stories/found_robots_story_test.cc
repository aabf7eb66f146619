// Robots that tell the network of themselves, in a network of the test's own.
#include <gtest/gtest.h>

#include <chrono>

#include "bt_core/live/discovery/announcer.h"
#include "bt_core/live/discovery/multicast_search.h"
#include "tests/bt_core/live/discovery/own_network.h"
#include "tests/editor/driver.h"
#include "tests/editor/live/live_robot.h"

namespace coppice::editor {
namespace {

constexpr char kTree[] = R"(<BehaviorTree ID="Main"><Do as="work"/></BehaviorTree>)";

class FoundRobotsStory : public testing::Test {
 protected:
  EditorOptions Options() const {
    EditorOptions options;
    options.recent_file = folder_.Path("recent");
    options.search = std::make_shared<MulticastSearch>(std::function<void()>(), "lo");
    return options;
  }

  RobotNotice Notice() const { return {"sobi-5", robot_.port(), "sobi", "Patrol", false}; }

  // Lets frames go by until the item is there, as people wait for it.
  static bool WaitFor(Driver& driver, const std::string& item) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (std::chrono::steady_clock::now() < end) {
      driver.Frames(1);
      if (driver.Has(item)) return true;
    }
    return false;
  }

  bool BecomesLive(Driver& driver) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (std::chrono::steady_clock::now() < end) {
      robot_.Tick();
      driver.Frames(1);
      const RunView* const run = driver.editor.state().workspace.run();
      if (run && run->phase() == RunPhase::kLive) return run->name() == robot_.endpoint();
    }
    return false;
  }

  const OwnNetwork network_;
  const TemporaryFolder folder_;
  LiveRobot robot_{kTree};
};

TEST_F(FoundRobotsStory, TheStartScreenOffersARobotThatTellsTheNetworkOfItself) {
  Driver driver(Options());
  driver.Frames();
  EXPECT_FALSE(driver.Has("start/found/0"));
  const Announcer announcer("lo", Notice());
  ASSERT_TRUE(WaitFor(driver, "start/found/0"));
  driver.Picture("found_robots_start");
  ASSERT_TRUE(driver.Click("start/found/0"));
  EXPECT_TRUE(BecomesLive(driver));
}

TEST_F(FoundRobotsStory, NothingConnectsByItself) {
  const Announcer announcer("lo", Notice());
  Driver driver(Options());
  ASSERT_TRUE(WaitFor(driver, "start/found/0"));
  driver.Frames(20);
  EXPECT_EQ(driver.editor.state().workspace.run(), nullptr);
  EXPECT_TRUE(driver.editor.state().recent.robots.empty());
}

TEST_F(FoundRobotsStory, TheDialogConnectsByArrowAndEnter) {
  const Announcer announcer("lo", Notice());
  Driver driver(Options());
  driver.Frames();
  driver.Press('K', kCtrl);
  ASSERT_TRUE(WaitFor(driver, "popup/0"));
  driver.Press(kKeyDown);
  driver.Frames();
  driver.Picture("found_robots_dialog");
  driver.Press(kKeyEnter);
  EXPECT_TRUE(BecomesLive(driver));
}

TEST_F(FoundRobotsStory, TheMenuOffersIt) {
  const Announcer announcer("lo", Notice());
  Driver driver(Options());
  ASSERT_TRUE(WaitFor(driver, "start/found/0"));
  ASSERT_TRUE(driver.Click("menu/file"));
  driver.Frames();
  ASSERT_TRUE(driver.Click("menu/robot.known"));
  driver.Frames();
  ASSERT_TRUE(driver.Click("menu/robot/0"));
  EXPECT_TRUE(BecomesLive(driver));
}

TEST_F(FoundRobotsStory, OneThatWasMetBeforeIsOfferedOnce) {
  const Announcer announcer("lo", Notice());
  Driver driver(Options());
  MeetRobot(driver.editor.state().recent.robots, {robot_.endpoint(), "Patrol", 1});
  ASSERT_TRUE(WaitFor(driver, "start/robot/0"));
  const auto is_told = [&] {
    const std::vector<OfferedRobot> robots = driver.editor.state().OfferedRobots();
    return robots.at(0).note == "Patrol, here now";
  };
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!is_told() && std::chrono::steady_clock::now() < end) driver.Frames(1);
  EXPECT_TRUE(is_told());
  EXPECT_FALSE(driver.Has("start/found/0"));
}

TEST_F(FoundRobotsStory, WhoDoesNotWantToAskTheNetworkSwitchesItOff) {
  const Announcer announcer("lo", Notice());
  Driver driver(Options());
  ASSERT_TRUE(WaitFor(driver, "start/found/0"));
  driver.Press('P', kCtrl);
  driver.Type("look for robots");
  driver.Press(kKeyEnter);
  driver.Frames();
  EXPECT_FALSE(driver.Has("start/found/0"));
}

TEST_F(FoundRobotsStory, NamesOfStrangersStayInTheirRow) {
  RobotNotice stranger = Notice();
  stranger.tree = std::string(60, 'W');
  stranger.host = "forget\u202e" + std::string(60, 'M');
  const Announcer announcer("lo", stranger);
  Driver driver(Options());
  ASSERT_TRUE(WaitFor(driver, "start/found/0"));
  driver.Picture("found_robots_stranger");
  const Box row = driver.BoxOf("start/found/0");
  EXPECT_LT(row.width(), 400);
}

}  // namespace
}  // namespace coppice::editor
