#include "editor/live/robot_source.h"

#include <gtest/gtest.h>

#include "tests/editor/live/live_robot.h"

namespace coppice::editor {
namespace {

TEST(RobotSourceTest, RefusesWhatIsNoEndpoint) {
  EXPECT_THROW(RobotSource("host:99999"), std::invalid_argument);
  EXPECT_THROW(RobotSource(":1667"), std::invalid_argument);
}

TEST(RobotSourceTest, NamesOneTreeOfSeveralBehindASlash) {
  const RobotSource source("127.0.0.1:1/mission");
  EXPECT_EQ(source.name(), "127.0.0.1:1/mission");
  EXPECT_TRUE(source.is_robot());
}

TEST(RobotSourceTest, WakesWhenThereIsNews) {
  LiveRobot robot(R"(<BehaviorTree ID="Main"><Do as="work"/></BehaviorTree>)");
  std::atomic<int> wakes{0};
  RobotSource source(robot.endpoint(), [&wakes] { ++wakes; });
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (wakes == 0 && std::chrono::steady_clock::now() < end) robot.Tick();
  EXPECT_GT(wakes, 0);
  EXPECT_TRUE(source.has_news());
}

}  // namespace
}  // namespace coppice::editor
