#include "robot_app/localization/odometry_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "tests/robot_app/navigation/world_robot.h"

namespace coppice::robot::localization {
namespace {

// The bare floor without people, and a robot that wanders about in its hall.
class FilterInWorld {
 public:
  explicit FilterInWorld(std::uint64_t seed) : world_(EmptyHall(), Options(seed)) {}

  void Drive(double seconds) {
    const double stop = world_.time() + seconds;
    while (world_.time() < stop) {
      world_.Step(0.02, Command(world_.time()));
      const double now = world_.time();
      const simulation::Odometry& wheels = world_.odometry();
      if (wheels.time() != wheels_time_) {
        wheels_time_ = wheels.time();
        filter_.AddWheels(now, ToPose2D(wheels.pose()),
                          {wheels.velocity().linear, wheels.velocity().angular});
        if (std::isfinite(filter_.innovation())) wheels_innovation_ += filter_.innovation();
        ++wheels_count_;
      }
      if (filter_.AddYawRate(now, world_.imu().yaw_rate, 0)) {
        gyro_innovation_ += filter_.innovation();
        ++gyro_count_;
      }
    }
  }

  // Both as seen from the start, where both frames lie.
  Pose2D Truth() const { return RelativeTo(ToPose2D(kStart), navigation::PoseOf(world_)); }
  Pose2D Wheels() const { return ToPose2D(world_.odometry().pose()); }
  const OdometryFilter& filter() const { return filter_; }
  double MeanWheelsInnovation() const { return wheels_innovation_ / wheels_count_; }
  double MeanGyroInnovation() const { return gyro_innovation_ / gyro_count_; }

 private:
  static constexpr simulation::Pose2 kStart{46, 0, 0};
  static Pose2D ToPose2D(const simulation::Pose2& pose) { return {pose.x, pose.y, pose.yaw}; }
  static simulation::Floor EmptyHall() {
    simulation::Floor floor = navigation::InstituteFloor();
    floor.people.clear();
    floor.furniture.clear();
    return floor;
  }
  static simulation::WorldOptions Options(std::uint64_t seed) {
    simulation::WorldOptions options;
    options.lidar.beams = 2;  // nobody looks at it
    options.seed = seed;
    options.start = kStart;
    return options;
  }
  static simulation::Velocity Command(double time) {  // eights, and a rest now and then
    const double phase = std::fmod(time, 30);
    if (phase > 27) return {0, 0};
    return {0.5, phase < 13.5 ? 0.4654 : -0.4654};
  }

  simulation::World world_;
  OdometryFilter filter_;
  double wheels_time_ = -1;
  double wheels_innovation_ = 0;
  double gyro_innovation_ = 0;
  int wheels_count_ = 0;
  int gyro_count_ = 0;
};

TEST(OdometryFilter, FollowsTheTruthBetterThanTheWheelsAlone) {
  double filter_error = 0, wheels_error = 0, filter_yaw = 0, wheels_yaw = 0;
  const int seeds = 10;
  for (int seed = 1; seed <= seeds; ++seed) {
    FilterInWorld run(seed);
    run.Drive(300);
    const Pose2D truth = run.Truth();
    filter_error += Distance(run.filter().pose(), truth) / seeds;
    wheels_error += Distance(run.Wheels(), truth) / seeds;
    filter_yaw += std::abs(NormalizeAngle(run.filter().pose().yaw - truth.yaw)) / seeds;
    wheels_yaw += std::abs(NormalizeAngle(run.Wheels().yaw - truth.yaw)) / seeds;
  }
  std::cout << "after 135 m: filter " << filter_error << " m, " << filter_yaw << " rad; wheels "
            << wheels_error << " m, " << wheels_yaw << " rad\n";
  EXPECT_LT(filter_error, 0.15);
  EXPECT_LT(filter_yaw, 0.02);
  EXPECT_LT(filter_error, wheels_error / 2);
  EXPECT_LT(filter_yaw, wheels_yaw / 4);
}

TEST(OdometryFilter, KnowsHowUncertainItIs) {
  int inside = 0;
  const int seeds = 10;
  for (int seed = 1; seed <= seeds; ++seed) {
    FilterInWorld run(100 + seed);
    run.Drive(120);
    const Pose2D truth = run.Truth();
    const OdometryFilter& filter = run.filter();
    const Eigen::Vector3d error(filter.pose().x - truth.x, filter.pose().y - truth.y,
                                NormalizeAngle(filter.pose().yaw - truth.yaw));
    for (int i = 0; i < 3; ++i) {
      if (std::abs(error(i)) < 3 * std::sqrt(filter.covariance()(i, i))) ++inside;
    }
    // It may be too careful, but not much, and never too sure.
    EXPECT_LT(run.MeanWheelsInnovation(), 3);
    EXPECT_GT(run.MeanWheelsInnovation(), 0.02);
    EXPECT_LT(run.MeanGyroInnovation(), 1.5);
    EXPECT_GT(run.MeanGyroInnovation(), 0.005);
    EXPECT_LT(std::sqrt(filter.covariance()(0, 0)), 0.3);
  }
  EXPECT_GE(inside, 3 * seeds - 2);
}

TEST(OdometryFilter, StartsWhereTheWheelsAre) {
  OdometryFilter filter;
  EXPECT_FALSE(filter.AddYawRate(1, 0.1, 0));
  EXPECT_FALSE(filter.started());
  ASSERT_TRUE(filter.AddWheels(5, {3, 4, 1}, {0.5, 0.1}));
  EXPECT_TRUE(filter.started());
  EXPECT_DOUBLE_EQ(filter.pose().x, 3);
  EXPECT_DOUBLE_EQ(filter.pose().yaw, 1);
  EXPECT_DOUBLE_EQ(filter.covariance()(0, 0), 0);
}

TEST(OdometryFilter, StandsStillWhenTheWheelsDo) {
  OdometryFilter filter;
  for (int i = 0; i < 10000; ++i) {
    filter.AddWheels(i * 0.05, {}, {});
    filter.AddYawRate(i * 0.05, i % 2 == 0 ? 0.002 : -0.002, 0);
  }
  EXPECT_NEAR(filter.pose().x, 0, 1e-6);
  EXPECT_NEAR(filter.pose().yaw, 0, 0.001);
}

TEST(OdometryFilter, RefusesWhatCannotBe) {
  OdometryFilter filter;
  EXPECT_FALSE(filter.AddWheels(1, {NAN, 0, 0}, {}));
  ASSERT_TRUE(filter.AddWheels(1, {}, {0.5, 0}));
  EXPECT_FALSE(filter.AddWheels(1.05, {}, {NAN, 0}));
  EXPECT_FALSE(filter.AddWheels(1.05, {}, {1e9, 0}));
  EXPECT_FALSE(filter.AddWheels(NAN, {}, {}));
  EXPECT_FALSE(filter.AddYawRate(1.05, INFINITY, 0));
  EXPECT_FALSE(filter.AddWheels(0.5, {}, {}));  // long overtaken
  EXPECT_TRUE(filter.AddYawRate(0.95, 0, 0));   // just overtaken
  EXPECT_EQ(filter.stamp(), 1);
  EXPECT_TRUE(std::isfinite(filter.pose().x));
}

TEST(OdometryFilter, StartsAnewWhenTimeIsSetBack) {
  OdometryFilter filter;
  ASSERT_TRUE(filter.AddWheels(100, {3, 4, 1}, {0.5, 0.1}));
  EXPECT_FALSE(filter.AddYawRate(10, 0.1, 0));
  ASSERT_TRUE(filter.AddWheels(10, {1, 0, 0}, {}));
  EXPECT_EQ(filter.stamp(), 10);
  EXPECT_DOUBLE_EQ(filter.pose().x, 1);
  EXPECT_DOUBLE_EQ(filter.velocity().linear, 0);
}

TEST(OdometryFilter, GoesOnWithoutTheGyroscope) {
  OdometryFilter filter;
  for (int i = 0; i <= 100; ++i) filter.AddWheels(i * 0.05, {}, {0.5, 0.2});
  EXPECT_NEAR(filter.pose().yaw, 1, 0.02);
  EXPECT_NEAR(std::hypot(filter.pose().x, filter.pose().y), 2.5 * 2 * std::sin(0.5), 0.02);
}

}  // namespace
}  // namespace coppice::robot::localization
