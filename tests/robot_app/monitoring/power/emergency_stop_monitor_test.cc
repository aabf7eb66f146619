#include "robot_app/monitoring/power/emergency_stop_monitor.h"

#include <gtest/gtest.h>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::seconds;

class EmergencyStopMonitorTest : public testing::Test {
 protected:
  explicit EmergencyStopMonitorTest() { Watch(Duration::zero()); }
  void Watch(Duration staleness) { monitor_.Watch(EmergencyStopWatch{"/stop", staleness}); }
  Finding At(Time now) { return monitor_.Report({}, {now, now}).at(0); }
  EmergencyStopMonitor monitor_;
};

TEST_F(EmergencyStopMonitorTest, IsAnErrorAtOnceAndAsLongAsItIsPressed) {
  monitor_.OnState(false, {Time(seconds(1)), Time(seconds(1))});
  EXPECT_EQ(At(Time(seconds(1))).level, HealthLevel::kOk);
  monitor_.OnState(true, {Time(seconds(2)), Time(seconds(2))});
  EXPECT_EQ(At(Time(seconds(2))).level, HealthLevel::kError);
  monitor_.OnState(true, {Time(seconds(3)), Time(seconds(3))});
  EXPECT_EQ(At(Time(seconds(60))).level, HealthLevel::kError);
  EXPECT_EQ(At(Time(seconds(60))).message, "pressed for 58 s");
  EXPECT_EQ(At(Time(seconds(60))).monitor, "emergency_stop");
  monitor_.OnState(false, {Time(seconds(61)), Time(seconds(61))});
  EXPECT_EQ(At(Time(seconds(61))).level, HealthLevel::kOk);
}

TEST_F(EmergencyStopMonitorTest, SilenceIsAllowedUnlessSaidOtherwise) {
  At(Time(seconds(1)));
  EXPECT_EQ(At(Time(seconds(1000))).level, HealthLevel::kOk);
  Watch(seconds(2));
  At(Time(seconds(1000)));
  EXPECT_EQ(At(Time(seconds(1003))).level, HealthLevel::kError);
  EXPECT_EQ(At(Time(seconds(2003))).message, "/stop: no message for 2e+03 s");
}

TEST_F(EmergencyStopMonitorTest, WithoutAWatchThereIsNothingToSay) {
  monitor_.Watch(std::nullopt);
  EXPECT_TRUE(monitor_.Report({}, {Time(seconds(1)), Time(seconds(1))}).empty());
}

}  // namespace
}  // namespace coppice::robot::monitoring
