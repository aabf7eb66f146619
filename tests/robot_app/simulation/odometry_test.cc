#include "robot_app/simulation/odometry.h"

#include <gtest/gtest.h>

namespace coppice::robot::simulation {
namespace {

void DriveStraight(Odometry& odometry, double metres) {
  for (int i = 0; i < 1000; ++i) {
    odometry.Move(metres / 1000, 0);
    odometry.Read((i + 1) * 0.02);
  }
}

TEST(Odometry, WithoutErrorsFollowsAnArcExactly) {
  OdometryOptions exact;
  exact.diameter_error = 0;
  exact.slip = 0;
  Odometry odometry(exact, 1);
  for (int i = 0; i < 1000; ++i) {  // a quarter of a circle of radius 2 m
    odometry.Move(kPi / 1000, kPi / 2 / 1000);
    odometry.Read(i * 0.01);
  }
  EXPECT_NEAR(odometry.pose().x, 2, 0.005);
  EXPECT_NEAR(odometry.pose().y, 2, 0.005);
  EXPECT_NEAR(odometry.pose().yaw, kPi / 2, 0.002);
}

TEST(Odometry, DriftsALittleButNotMuch) {
  double worst = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Odometry odometry({}, seed);
    DriveStraight(odometry, 20);
    EXPECT_NEAR(odometry.pose().x, 20, 0.5) << seed;
    worst = std::max(worst, Length(odometry.pose().position() - Vec2{20, 0}));
  }
  EXPECT_GT(worst, 0.02);
  EXPECT_LT(worst, 3);
}

TEST(Odometry, ReportsTheVelocityOfTheLastReading) {
  Odometry odometry({}, 1);
  odometry.Read(1);
  odometry.Move(0.045, 0.02);
  odometry.Read(1.05);
  EXPECT_NEAR(odometry.velocity().linear, 0.9, 0.02);
  EXPECT_NEAR(odometry.velocity().angular, 0.4, 0.1);
  EXPECT_EQ(odometry.time(), 1.05);
}

TEST(Odometry, StandsStillWhenTheRobotDoes) {
  Odometry odometry({}, 1);
  for (int i = 0; i < 100; ++i) odometry.Move(0, 0);
  odometry.Read(2);
  EXPECT_EQ(odometry.pose().x, 0);
  EXPECT_EQ(odometry.velocity().linear, 0);
}

TEST(Odometry, TheSameSeedGivesTheSameDrift) {
  Odometry a({}, 4);
  Odometry b({}, 4);
  Odometry c({}, 5);
  for (Odometry* odometry : {&a, &b, &c}) DriveStraight(*odometry, 10);
  EXPECT_EQ(a.pose().y, b.pose().y);
  EXPECT_NE(a.pose().y, c.pose().y);
}

TEST(Imu, MeasuresAccelerationsAndYawRate) {
  Imu imu(1);
  ImuReading mean;
  const int count = 2000;
  for (int i = 0; i < count; ++i) {
    imu.Measure(0.02, {0.5, 0.4}, {0.512, 0.4});
    mean.yaw_rate += imu.reading().yaw_rate / count;
    mean.acceleration_x += imu.reading().acceleration_x / count;
    mean.acceleration_y += imu.reading().acceleration_y / count;
    mean.acceleration_z += imu.reading().acceleration_z / count;
  }
  EXPECT_NEAR(mean.yaw_rate, 0.4, 0.001);
  EXPECT_NEAR(mean.acceleration_x, 0.6, 0.01);
  EXPECT_NEAR(mean.acceleration_y, 0.512 * 0.4, 0.01);
  EXPECT_NEAR(mean.acceleration_z, 9.81, 0.01);
}

}  // namespace
}  // namespace coppice::robot::simulation
