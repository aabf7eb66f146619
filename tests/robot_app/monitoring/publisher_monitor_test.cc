#include "robot_app/monitoring/publisher_monitor.h"

#include <gtest/gtest.h>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::milliseconds;
using std::chrono::seconds;

class PublisherMonitorTest : public testing::Test {
 protected:
  PublisherMonitorTest() { monitor_.Watch(std::vector{watch_}); }
  Finding At(Time wall) { return monitor_.Report({}, {{}, wall}).at(0); }

  PublisherWatch watch_{"/cmd_vel", {"/velocity_mux", "/joystick"}};
  PublisherMonitor monitor_;
};

TEST_F(PublisherMonitorTest, ThoseWhoMayAreWell) {
  monitor_.OnMessage("/cmd_vel", "/velocity_mux", {{}, Time(seconds(1))});
  monitor_.OnMessage("/cmd_vel", "/joystick", {{}, Time(seconds(1))});
  EXPECT_EQ(At(Time(seconds(1))).level, HealthLevel::kOk);
}

TEST_F(PublisherMonitorTest, AStrangerIsAnErrorUntilItHasBeenSilentForFiveSeconds) {
  monitor_.OnMessage("/cmd_vel", "/stranger", {{}, Time(seconds(1))});
  monitor_.OnMessage("/cmd_vel", "/velocity_mux", {{}, Time(seconds(2))});
  EXPECT_EQ(At(Time(seconds(6) - milliseconds(1))).level, HealthLevel::kError);
  EXPECT_EQ(At(Time(seconds(2))).message,
            "/stranger publishes here, where only /velocity_mux, /joystick may");
  EXPECT_EQ(At(Time(seconds(6))).level, HealthLevel::kOk);
}

TEST_F(PublisherMonitorTest, NobodyIsRestartedForAStranger) {
  monitor_.OnMessage("/cmd_vel", "/stranger", {{}, Time(seconds(1))});
  EXPECT_EQ(At(Time(seconds(1))).monitor, "publisher");
  EXPECT_EQ(At(Time(seconds(1))).node, "");
}

TEST_F(PublisherMonitorTest, OtherTopicsAreAnybodys) {
  monitor_.OnMessage("/scan", "/stranger", {{}, Time(seconds(1))});
  EXPECT_EQ(At(Time(seconds(1))).level, HealthLevel::kOk);
}

TEST_F(PublisherMonitorTest, AnotherConfigurationThatWatchesTheSameForgetsNoStranger) {
  monitor_.OnMessage("/cmd_vel", "/stranger", {{}, Time(seconds(1))});
  monitor_.Watch(std::vector{watch_});
  EXPECT_EQ(At(Time(seconds(2))).level, HealthLevel::kError);
}

}  // namespace
}  // namespace coppice::robot::monitoring
