#include "robot_app/navigation/navigation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "tests/robot_app/navigation/test_floor.h"

namespace coppice::robot::navigation {
namespace {

using End = Navigation::End;
using testing::HasSubstr;

constexpr double kStep = 0.05;

// An ideal robot on a floor that may differ from the map that it has been given.
class NavigationTest : public testing::Test {
 protected:
  void Begin(const Pose2D& pose, const Pose2D& goal) {
    pose_ = pose;
    navigation_.SetMap(map_);
    navigation_.SetGoal(goal, now_);
  }

  // Drives until the goal has ended, `until` is true, or `seconds` have passed.
  End Drive(
      double seconds, const std::function<bool()>& until = [] { return false; }) {
    for (const double stop = now_ + seconds; now_ < stop;) {
      now_ += kStep;
      if (seeing_ && ++steps_ % 2 == 0) navigation_.AddScan(pose_, ScanOf(floor_, pose_, now_));
      velocity_ = navigation_.Update(now_, pose_, located_ ? now_ : located_at_);
      if (located_) located_at_ = now_;
      pose_ = Advance(pose_, velocity_, kStep);
      EXPECT_GT(Clearance(floor_, pose_), 0.33) << "at " << pose_.x << ", " << pose_.y;
      seen_.insert(navigation_.status());
      if (navigation_.end() != End::kNone || until()) break;
    }
    return navigation_.end();
  }

  OccupancyGrid map_ = EmptyRoom(12, 6);
  OccupancyGrid floor_ = map_;
  Navigation navigation_;
  Pose2D pose_;
  Velocity2D velocity_;
  double now_ = 100;
  int steps_ = 0;
  bool seeing_ = true;
  bool located_ = true;
  double located_at_ = 0;
  std::set<NavigationStatus> seen_;
};

// A corridor of 2 m width, and a way around it.
class BlockedCorridor : public NavigationTest {
 protected:
  void WithDetour(bool detour) {
    Fill(map_, {0, 2}, {12, 2.2});
    if (detour) {
      Fill(map_, {1, 2}, {2.5, 2.2}, 0);
      Fill(map_, {9.5, 2}, {11, 2.2}, 0);
    }
    floor_ = map_;
  }
  void Block() { Fill(floor_, {6, 0}, {6.3, 2}); }
  void Unblock() { floor_ = map_; }
};

TEST_F(NavigationTest, ReachesAGoalAndStands) {
  Begin({1, 1, 0}, {10, 4, M_PI / 2});
  EXPECT_EQ(Drive(60), End::kReached);
  EXPECT_LT(Distance(pose_, {10, 4, 0}), 0.15);
  EXPECT_NEAR(NormalizeAngle(pose_.yaw - M_PI / 2), 0, 0.15);
  EXPECT_FALSE(navigation_.has_goal());
  EXPECT_EQ(navigation_.status(), NavigationStatus::kIdle);
  EXPECT_NEAR(velocity_.linear, 0, 0.05);
  EXPECT_TRUE(navigation_.path().empty());
}

TEST_F(NavigationTest, DrivesAroundWhatIsNotOnTheMap) {
  Begin({1, 3, 0}, {11, 3, 0});
  Fill(floor_, {5, 2.2}, {6, 3.8});
  EXPECT_EQ(Drive(90), End::kReached) << navigation_.message();
}

TEST_F(NavigationTest, ANewGoalReplacesTheOldOneWithoutAStop) {
  Begin({1, 1, 0}, {10, 1, 0});
  Drive(5);
  const double speed = velocity_.linear;
  EXPECT_GT(speed, 0.5);
  navigation_.SetGoal({10, 2, 0}, now_);
  Drive(kStep);
  EXPECT_NEAR(velocity_.linear, speed, 0.05);
  EXPECT_EQ(Drive(60), End::kReached);
  EXPECT_NEAR(pose_.y, 2, 0.15);
}

TEST_F(NavigationTest, CancelledItBrakesToAStop) {
  Begin({1, 1, 0}, {10, 1, 0});
  Drive(5);
  navigation_.Cancel(now_);
  EXPECT_EQ(Drive(3), End::kNone);
  EXPECT_EQ(velocity_.linear, 0);
  EXPECT_EQ(navigation_.status(), NavigationStatus::kIdle);
  EXPECT_EQ(navigation_.consecutive_failures(), 0);
}

TEST_F(NavigationTest, RefusesAGoalInAWallAtOnce) {
  Begin({1, 1, 0}, {0.2, 3, 0});
  EXPECT_EQ(Drive(1), End::kAborted);
  EXPECT_THAT(navigation_.message(), HasSubstr("is blocked"));
  EXPECT_THAT(navigation_.message(), HasSubstr("on the map"));
  EXPECT_EQ(navigation_.consecutive_failures(), 1);
}

TEST_F(NavigationTest, RefusesAGoalBeforeThereIsAMap) {
  navigation_.SetGoal({1, 1, 0}, now_);
  navigation_.Update(now_, {}, now_);
  EXPECT_EQ(navigation_.end(), End::kAborted);
  EXPECT_THAT(navigation_.message(), HasSubstr("no map"));
}

TEST_F(NavigationTest, StopsWhenTheLaserFallsSilentAndGoesOnWhenItReturns) {
  Begin({1, 1, 0}, {10, 1, 0});
  Drive(5);
  seeing_ = false;
  Drive(1.2);
  EXPECT_EQ(velocity_.linear, 0);
  EXPECT_EQ(navigation_.status(), NavigationStatus::kBlocked);
  EXPECT_THAT(navigation_.message(), HasSubstr("no laser scan"));
  seeing_ = true;
  EXPECT_EQ(Drive(60), End::kReached);
}

TEST_F(NavigationTest, AbortsWhenTheLocalizationStaysSilent) {
  Begin({1, 1, 0}, {10, 1, 0});
  Drive(5);
  located_ = false;
  Drive(1.2);
  EXPECT_EQ(velocity_.linear, 0);
  EXPECT_THAT(navigation_.message(), HasSubstr("no pose"));
  EXPECT_EQ(Drive(30), End::kAborted);
  EXPECT_THAT(navigation_.message(), HasSubstr("no pose"));
}

TEST_F(BlockedCorridor, TakesTheDetourWhenItSeesTheObstacle) {
  WithDetour(true);
  Begin({3, 1, 0}, {9, 1, 0});
  Block();
  double north = 0;
  EXPECT_EQ(Drive(120,
                  [&] {
                    north = std::max(north, pose_.y);
                    return false;
                  }),
            End::kReached)
      << navigation_.message();
  EXPECT_GT(north, 2.5);
}

TEST_F(BlockedCorridor, WaitsAndGoesOnWhenTheObstacleGoesAway) {
  WithDetour(false);
  Begin({1, 1, 0}, {10, 1, 0});
  Block();
  Drive(60, [&] { return navigation_.status() == NavigationStatus::kNoPath; });
  ASSERT_EQ(navigation_.status(), NavigationStatus::kNoPath);
  Drive(4);
  EXPECT_TRUE(navigation_.has_goal());
  EXPECT_NEAR(velocity_.linear, 0, 1e-9);
  Unblock();
  EXPECT_EQ(Drive(60), End::kReached) << navigation_.message();
  EXPECT_EQ(navigation_.consecutive_failures(), 0);
}

// Else a pose that comes late would look to who watches as if the way had become free.
TEST_F(BlockedCorridor, HasNoWayAfterAFailureWhileThePoseIsLate) {
  WithDetour(false);
  Begin({1, 1, 0}, {10, 1, 0});
  Block();
  ASSERT_EQ(Drive(60), End::kAborted);
  located_ = false;
  Drive(1.2);
  navigation_.SetGoal({10, 1, 0}, now_);
  Drive(kStep);
  EXPECT_EQ(navigation_.status(), NavigationStatus::kNoPath);
  EXPECT_THAT(navigation_.message(), HasSubstr("no pose"));
  located_ = true;
  Unblock();
  EXPECT_EQ(Drive(60), End::kReached) << navigation_.message();
}

TEST_F(BlockedCorridor, GivesUpAfterItsRecoveriesAndSaysWhy) {
  WithDetour(false);
  Begin({1, 1, 0}, {10, 1, 0});
  Block();
  Drive(60, [&] { return navigation_.status() == NavigationStatus::kNoPath; });
  const double held_at = now_;
  double turned = 0;
  double yaw = pose_.yaw;
  EXPECT_EQ(Drive(60,
                  [&] {
                    turned += NormalizeAngle(pose_.yaw - yaw);
                    yaw = pose_.yaw;
                    return false;
                  }),
            End::kAborted);
  EXPECT_NEAR(turned, 2 * M_PI, 0.6) << "looks around once";
  EXPECT_THAT(navigation_.message(), HasSubstr("no way to (10.00, 1.00) is free"));
  EXPECT_THAT(navigation_.message(), HasSubstr("recovering did not help"));
  EXPECT_GT(now_ - held_at, 8);
  EXPECT_LT(now_ - held_at, 35);
  EXPECT_EQ(navigation_.consecutive_failures(), 1);
}

TEST_F(BlockedCorridor, GivesUpInTimeAlsoWhereTimeIsSetBack) {
  WithDetour(false);
  Begin({2, 1, 0}, {10, 1, 0});
  Block();
  Drive(30, [this] { return navigation_.status() == NavigationStatus::kNoPath; });
  ASSERT_EQ(navigation_.status(), NavigationStatus::kNoPath);
  now_ -= 90;
  EXPECT_EQ(Drive(60), End::kAborted);
}

TEST_F(NavigationTest, DrivesOnAtOnceWhereTimeIsSetBack) {
  Begin({1, 1, 0}, {10, 4, 0});
  Drive(5);
  now_ -= 90;
  pose_ = {1, 5, M_PI};  // the simulator that began anew has put it elsewhere
  EXPECT_EQ(Drive(60), End::kReached);
}

TEST_F(BlockedCorridor, CountsFailuresUntilAGoalIsReached) {
  WithDetour(false);
  Begin({1, 1, 0}, {10, 1, 0});
  Block();
  EXPECT_EQ(Drive(120), End::kAborted);
  navigation_.SetGoal({10, 1, 0}, now_);
  EXPECT_EQ(Drive(120), End::kAborted);
  EXPECT_EQ(navigation_.consecutive_failures(), 2);
  navigation_.SetGoal({1, 1, 0}, now_);
  EXPECT_EQ(Drive(120), End::kReached);
  EXPECT_EQ(navigation_.consecutive_failures(), 0);
}

TEST_F(NavigationTest, SaysBlockedWhenSomethingStandsInTheWay) {
  // A door on the only way shuts right in front of the robot.
  Fill(map_, {6, 0}, {6.2, 2.4});
  Fill(map_, {6, 3.6}, {6.2, 6});
  floor_ = map_;
  Begin({1, 3, 0}, {10, 3, 0});
  Drive(60, [&] { return pose_.x > 5.0; });
  Fill(floor_, {6, 0}, {6.2, 6});
  EXPECT_EQ(Drive(120), End::kAborted);
  EXPECT_EQ(seen_.count(NavigationStatus::kNoPath) + seen_.count(NavigationStatus::kBlocked), 2u)
      << "near the door it is both";
}

TEST_F(NavigationTest, TheSameInputsGiveTheSameCommands) {
  std::vector<double> first;
  for (int round = 0; round < 2; ++round) {
    Navigation navigation;
    navigation.SetMap(map_);
    navigation.SetGoal({10, 4, 0}, 0);
    Pose2D pose{1, 1, 2};
    for (int i = 1; i < 400; ++i) {
      navigation.AddScan(pose, ScanOf(floor_, pose, i * kStep));
      const Velocity2D velocity = navigation.Update(i * kStep, pose, i * kStep);
      pose = Advance(pose, velocity, kStep);
      if (round == 0) {
        first.push_back(velocity.angular);
      } else {
        ASSERT_EQ(velocity.angular, first[i - 1]);
      }
    }
  }
}

}  // namespace
}  // namespace coppice::robot::navigation
