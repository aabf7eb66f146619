#include "robot_app/ros/ros_clock.h"

#include <gtest/gtest.h>
#include <ros/time.h>

#include "tests/robot_app/ros_environment.h"

namespace coppice::robot {
namespace {

TEST(RosClock, ShowsRosTime) {
  ros::Time::setNow(ros::Time(123, 5));
  EXPECT_EQ(RosClock().Now(), std::chrono::seconds(123) + std::chrono::nanoseconds(5));
}

TEST(RosClock, ReturnsFromAWaitWhenWoken) {
  ros::Time::setNow(ros::Time(10));
  RosClock clock;
  WakeUp wake_up;
  wake_up.Notify();
  clock.WaitUntil(kNever, wake_up);
  EXPECT_FALSE(wake_up.WaitFor(Duration::zero())) << "the wake-up was not consumed";
}

TEST(RosClock, WaitsUntilSimulatedTimeHasCome) {
  ros::Time::setNow(ros::Time(10));
  RosClock clock;
  WakeUp wake_up;
  std::thread mover([] {
    for (int i = 0; i <= 20; ++i) {
      ros::Time::setNow(ros::Time(10.0 + 0.1 * i));
      std::this_thread::yield();
    }
  });
  const Time deadline = std::chrono::seconds(12);
  while (clock.Now() < deadline) clock.WaitUntil(deadline, wake_up);
  mover.join();
  EXPECT_GE(clock.Now(), deadline);
}

}  // namespace
}  // namespace coppice::robot
