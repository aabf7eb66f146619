// Navigation drives the simulated robot over the whole floor, among people, without ROS.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <optional>

#include "robot_app/common/places/topological_map.h"
#include "robot_app/mapping/map_file.h"
#include "robot_app/navigation/navigation.h"
#include "tests/robot_app/navigation/world_robot.h"
#include "tests/support/folders.h"

namespace coppice::robot::navigation {
namespace {

using End = Navigation::End;

class NavigationInWorld : public testing::Test {
 protected:
  static constexpr double kStep = 0.05;

  NavigationInWorld() {
    world_.emplace(floor_, At({0, 0, 0}));
    world_->SetSonarsOn(true);
    Diagnostics diagnostics;
    places_ = *TopologicalMap::Load(
        SourceFolder() + "/robot_app/config/sites/institute/places.yaml", diagnostics);
    navigation_.SetMap(MapOf(floor_));
  }

  static simulation::WorldOptions At(const simulation::Pose2& start) {
    simulation::WorldOptions options;
    options.start = start;
    return options;
  }

  End DriveTo(const std::string& name, double seconds) {
    const Pose2D goal = *places_.places()[places_.Find(name)].pose;
    navigation_.SetGoal(goal, world_->time());
    for (const double stop = world_->time() + seconds; world_->time() < stop;) {
      if (world_->scan().time != scan_time_) {
        scan_time_ = world_->scan().time;
        navigation_.AddScan(PoseOf(*world_), ScanOf(*world_));
      }
      if (world_->echoes().time != echo_time_) {
        echo_time_ = world_->echoes().time;
        for (const RangeReading& reading : EchoesOf(*world_)) {
          EXPECT_TRUE(navigation_.AddRange(PoseOf(*world_), reading, world_->time()));
        }
      }
      const Velocity2D velocity =
          navigation_.Update(world_->time(), PoseOf(*world_), world_->time());
      if (navigation_.end() != End::kNone) break;
      // A person may walk into the robot; the robot must not drive into anything.
      for (int i = 0; i < 5; ++i) {
        world_->Step(kStep / 5, simulation::Velocity{velocity.linear, velocity.angular});
        if (world_->touching() && std::abs(world_->velocity().linear) > 0.1) ++bumps_;
      }
      const double error = navigation_.follower().tracking_error();
      error_ = std::max(error_, error);
      error_sum_ += error;
      ++updates_;
      if (world_->protective_stop()) ++protective_stops_;
    }
    if (navigation_.end() == End::kReached) {
      EXPECT_LT(Distance(PoseOf(*world_), goal), 0.15) << name;
      EXPECT_LT(std::abs(NormalizeAngle(PoseOf(*world_).yaw - goal.yaw)), 0.15) << name;
    }
    return navigation_.end();
  }

  simulation::Floor floor_ = InstituteFloor();
  std::optional<simulation::World> world_;
  Navigation navigation_;
  TopologicalMap places_;
  double scan_time_ = -1;
  double echo_time_ = -1;
  double error_ = 0;
  double error_sum_ = 0;
  int updates_ = 0;
  int bumps_ = 0;
  int protective_stops_ = 0;
};

TEST_F(NavigationInWorld, DrivesToEveryPlaceOfTheTopologicalMap) {
  for (const Place& place : places_.places()) {
    if (!place.Is("patrol")) continue;
    EXPECT_EQ(DriveTo(place.name, 180), End::kReached)
        << place.name << ": " << navigation_.message();
  }
  EXPECT_EQ(bumps_, 0);
  EXPECT_LT(error_sum_ / updates_, 0.03);
  // A new way around a person can begin aside of the moving robot: it brakes on the old one.
  EXPECT_LT(error_, 0.45);
  std::cout << "simulated " << world_->time() << " s, tracking error on average "
            << error_sum_ / updates_ << " m, at most " << error_ << " m, protective stops in "
            << protective_stops_ << " steps\n";
}

TEST_F(NavigationInWorld, DrivesToThemOnTheMapThatTheRobotMadeItself) {
  Diagnostics diagnostics;
  const auto map =
      mapping::LoadMap(SourceFolder() + "/robot_app/config/sites/institute/map.yaml", diagnostics);
  ASSERT_TRUE(map) << diagnostics.ToString();
  navigation_.SetMap(*map);
  for (const Place& place : places_.places()) {
    if (!place.Is("patrol")) continue;
    EXPECT_EQ(DriveTo(place.name, 180), End::kReached)
        << place.name << ": " << navigation_.message();
  }
  EXPECT_EQ(bumps_, 0);
}

TEST_F(NavigationInWorld, ABlockedCorridorEndsTheGoalAndAnOpenOneDoesNot) {
  ASSERT_EQ(DriveTo("corridor_west", 60), End::kReached);
  ASSERT_TRUE(world_->SetPlaceBlocked("corridor_west", true));
  EXPECT_EQ(DriveTo("corridor_middle", 120), End::kAborted);
  EXPECT_EQ(navigation_.consecutive_failures(), 1);
  EXPECT_LT(world_->robot().x, 9.4);
  ASSERT_TRUE(world_->SetPlaceBlocked("corridor_west", false));
  EXPECT_EQ(DriveTo("corridor_middle", 120), End::kReached) << navigation_.message();
  EXPECT_EQ(navigation_.consecutive_failures(), 0);
  EXPECT_EQ(bumps_, 0);
}

TEST_F(NavigationInWorld, LeavesTheStationByItselfWhereThereIsRoom) {
  world_.emplace(floor_);
  world_->SetSonarsOn(true);
  EXPECT_EQ(DriveTo("corridor_west", 60), End::kReached) << navigation_.message();
}

TEST_F(NavigationInWorld, PlansAcrossTheFloorWellWithinAControlPeriod) {
  Costmap costmap;
  const OccupancyGrid map = MapOf(floor_);
  const Pose2D goal = *places_.places()[places_.Find("hall_north")].pose;
  const auto began = std::chrono::steady_clock::now();
  costmap.Update(map);
  const auto costs = std::chrono::steady_clock::now();
  const Plan plan = FindPath(costmap, {-0.8, 0}, {goal.x, goal.y});
  const auto planned = std::chrono::steady_clock::now();
  const auto smooth = SmoothPath(costmap, plan.points);
  const auto end = std::chrono::steady_clock::now();
  using Milliseconds = std::chrono::duration<double, std::milli>;
  std::cout << map.frame.width << " x " << map.frame.height << " cells, " << PathLength(smooth)
            << " m: costs " << Milliseconds(costs - began).count() << " ms, path "
            << Milliseconds(planned - costs).count() << " ms, smoothing "
            << Milliseconds(end - planned).count() << " ms\n";
  ASSERT_EQ(plan.status, PlanStatus::kOk);
  EXPECT_TRUE(PathIsFree(costmap, smooth));
  // Generous: the figure printed is for people; this fails only if the algorithm is wrong.
  EXPECT_LT(Milliseconds(end - began).count(), 2000);
}

}  // namespace
}  // namespace coppice::robot::navigation
