// Navigation with sonars drives the simulated robot among what its laser does not see, without ROS.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "robot_app/navigation/navigation.h"
#include "tests/robot_app/navigation/world_robot.h"

namespace coppice::robot::navigation {
namespace {

using End = Navigation::End;

// A hall of 12 m. The robot stands at (2, 0) and wants to (10, 0); the map is empty.
class NavigationWithSonars : public testing::Test {
 protected:
  void MakeHall(double width) {
    const double y = width / 2;
    floor_.walls = {{{0, -y}, {12, -y}, {12, y}, {0, y}, {0, -y}}};
    floor_.docked = {1, 0, 0};
  }
  void AddLowBox(double width) {
    floor_.places.push_back({"box", {{6, 0}, {0.4, width}, 0}, 0.15});
  }

  End Drive(double seconds, bool hears = true) {
    simulation::WorldOptions options;
    options.start = simulation::Pose2{2, 0, 0};
    world_.emplace(floor_, options);
    world_->SetSonarsOn(hears);
    for (const simulation::FloorBox& place : floor_.places) {
      EXPECT_TRUE(world_->SetPlaceBlocked(place.name, true));
    }
    navigation_.SetMap(MapOf(floor_));
    navigation_.SetGoal({10, 0, 0}, 0);
    while (world_->time() < seconds && navigation_.end() == End::kNone) {
      Sense();
      const Velocity2D velocity =
          navigation_.Update(world_->time(), PoseOf(*world_), world_->time());
      for (int i = 0; i < 5; ++i) {
        world_->Step(0.01, simulation::Velocity{velocity.linear, velocity.angular});
        touched_ = touched_ || world_->touching();
      }
      farthest_ = std::max(farthest_, world_->robot().x);
    }
    return navigation_.end();
  }

  simulation::Floor floor_;
  std::optional<simulation::World> world_;
  Navigation navigation_;
  bool touched_ = false;
  double farthest_ = 0;

 private:
  void Sense() {
    if (world_->scan().time != scan_time_) {
      scan_time_ = world_->scan().time;
      navigation_.AddScan(PoseOf(*world_), ScanOf(*world_));
    }
    if (world_->echoes().time == echo_time_) return;
    echo_time_ = world_->echoes().time;
    for (const RangeReading& reading : EchoesOf(*world_)) {
      EXPECT_TRUE(navigation_.AddRange(PoseOf(*world_), reading, world_->time()));
    }
  }

  double scan_time_ = -1;
  double echo_time_ = -1;
};

TEST_F(NavigationWithSonars, DrivesAroundABoxThatIsTooLowForTheLaser) {
  MakeHall(4);
  AddLowBox(0.6);
  EXPECT_EQ(Drive(60), End::kReached) << navigation_.message();
  EXPECT_FALSE(touched_);
}

TEST_F(NavigationWithSonars, BumpsIntoThatBoxWithoutThem) {
  MakeHall(4);
  AddLowBox(0.6);
  Drive(20, false);
  EXPECT_TRUE(touched_);
}

TEST_F(NavigationWithSonars, StopsBeforeABoxFromWallToWallAndGivesUp) {
  MakeHall(2.5);
  AddLowBox(2.4);
  EXPECT_EQ(Drive(120), End::kAborted);
  EXPECT_FALSE(touched_);
  EXPECT_LT(farthest_, 5.8 - kRobotRadius);
}

TEST_F(NavigationWithSonars, StopsBeforeAPaneOfGlassAndGivesUp) {
  MakeHall(2.5);
  floor_.glass = {{{6, -1.25}, {6, 1.25}}};
  EXPECT_EQ(Drive(120), End::kAborted);
  EXPECT_FALSE(touched_);
  EXPECT_LT(farthest_, 6 - kRobotRadius);
}

TEST_F(NavigationWithSonars, FindsTheGapBesideAPaneOfGlass) {
  MakeHall(4);
  floor_.glass = {{{6, -2}, {6, 0.4}}};
  EXPECT_EQ(Drive(90), End::kReached) << navigation_.message();
  EXPECT_FALSE(touched_);
}

TEST_F(NavigationWithSonars, DrivesAlongAPaneThatStandsAtASlant) {
  MakeHall(4);
  floor_.glass = {{{4, -2}, {7.2, 0.4}}};
  EXPECT_EQ(Drive(90), End::kReached) << navigation_.message();
  EXPECT_FALSE(touched_);
}

}  // namespace
}  // namespace coppice::robot::navigation
