#include "robot_app/common/ros_clock.h"

#include <gtest/gtest.h>
#include <ros/time.h>

#include "tests/robot_app/ros_environment.h"

namespace coppice::robot {
namespace {

TEST(RosClock, ShowsRosTime) {
  ros::Time::setNow(ros::Time(123, 5));
  EXPECT_EQ(RosClock().Now(), Time(std::chrono::seconds(123) + std::chrono::nanoseconds(5)));
}

TEST(RosClock, GoesOnWhereRosTimeGoesBack) {
  RosClock clock;
  ros::Time::setNow(ros::Time(500));
  EXPECT_EQ(clock.Now(), Time(std::chrono::seconds(500)));
  ros::Time::setNow(ros::Time(200));
  EXPECT_EQ(clock.Now(), Time(std::chrono::seconds(500)));
  ros::Time::setNow(ros::Time(203));
  EXPECT_EQ(clock.Now(), Time(std::chrono::seconds(503)));
}

TEST(RosClock, ReturnsFromAWaitWhenWoken) {
  ros::Time::setNow(ros::Time(10));
  RosClock clock;
  WakeUp wake_up;
  wake_up.Notify();
  clock.WaitUntil(kNever, wake_up);
  EXPECT_FALSE(wake_up.WaitFor(Duration::zero())) << "the wake-up was not consumed";
}

// Nobody tells when simulated time moves: a wait that trusted it would hang when /clock stands
// still.
TEST(RosClock, LooksAgainAlthoughSimulatedTimeStandsStill) {
  ros::Time::setNow(ros::Time(10));
  RosClock clock;
  WakeUp wake_up;
  clock.WaitUntil(Time(std::chrono::seconds(1000)), wake_up);
  EXPECT_EQ(clock.Now(), Time(std::chrono::seconds(10)));
}

}  // namespace
}  // namespace coppice::robot
