#include "robot_app/docking/dock_controller.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace coppice::robot::docking {
namespace {

using Phase = DockController::Phase;
using testing::HasSubstr;

constexpr double kStep = 0.05;
constexpr Pose2D kDocked{-2.4, 0, M_PI};  // base_link on the station
constexpr Pose2D kStaging{-0.8, 0, M_PI};

// An ideal robot, a station that stops it at the contacts, and a battery that may get current.
class DockControllerTest : public testing::Test {
 protected:
  void Run(double seconds = 400) {
    for (const double stop = input_.now + seconds; controller_.active() && input_.now < stop;) {
      input_.now += kStep;
      const Pose2D in_station = RelativeTo(station_, input_.pose);
      const bool contact = in_station.x > -0.02 && std::abs(in_station.y) < 0.04;
      if (contact && !was_contact_) ++contacts_;
      was_contact_ = contact;
      input_.current = contact && contacts_ >= current_from_contact_ ? 12 : idle_current_;
      if (is_seen_) input_.seen = StationSighting{station_, input_.now, 10, 0.001, 0.001};
      input_.obstacles.clear();
      for (const Point2D& point : fixed_)
        input_.obstacles.push_back(RelativeTo(input_.pose, point));
      const Velocity2D velocity = controller_.Update(input_);
      if (controller_.phase() == Phase::kFollowPath) {
        EXPECT_LE(velocity.linear, in_station.x > -0.4 ? 0.16 : 0.26);
        aside_ = in_station.y;
      }
      const Pose2D next = Advance(input_.pose, velocity, wheels_turn_ * kStep);
      if (RelativeTo(station_, next).x < 0) input_.pose = next;
      if (phases_.empty() || phases_.back() != controller_.phase()) {
        phases_.push_back(controller_.phase());
      }
    }
  }
  void See() { input_.seen = StationSighting{station_, input_.now, 10, 0.001, 0.001}; }
  void Dock(const Pose2D& from) {
    input_.pose = from;
    if (is_seen_) See();
    controller_.StartDocking(input_);
    Run();
  }

  DockSettings settings_;
  Pose2D station_ = kDocked;
  bool is_seen_ = true;
  DockController controller_{settings_};
  DockInput input_;
  std::vector<Point2D> fixed_;  // obstacles in the map frame
  std::vector<Phase> phases_;
  int contacts_ = 0;
  int current_from_contact_ = 1;  // the first contact that gives current
  bool was_contact_ = false;
  double idle_current_ = -6;
  double wheels_turn_ = 1;
  double aside_ = 0;  // lateral error at the end of the approach
};

TEST_F(DockControllerTest, DocksFromTheStagingPose) {
  Dock({-0.8, 0, M_PI});
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
  EXPECT_THAT(controller_.message(), HasSubstr("charging with 12.0 A at attempt 1"));
  EXPECT_LT(Distance(input_.pose, station_), 0.03);
  EXPECT_EQ(contacts_, 1);
}

TEST_F(DockControllerTest, ReachesTheStationWithinTwoCentimetresFromAnywhereNear) {
  for (const Pose2D& from : {Pose2D{-0.5, 0.4, 2.5}, Pose2D{0.5, -0.6, 0}, Pose2D{-0.75, 0.05, 3.0},
                             Pose2D{-0.8, 0.06, -3.0}, Pose2D{-1.5, 0.1, 3.1},
                             Pose2D{-1.4, -0.2, 0.3}, Pose2D{-2.0, 0.3, 3.0}}) {
    SCOPED_TRACE(testing::Message() << from.x << ' ' << from.y << ' ' << from.yaw);
    contacts_ = 0;
    was_contact_ = false;
    Dock(from);
    EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
    EXPECT_LT(std::abs(aside_), 0.02);
    EXPECT_EQ(controller_.attempt(), 1);
  }
}

TEST_F(DockControllerTest, RefusesFromFarAway) {
  Dock({3, 0, M_PI});
  EXPECT_EQ(controller_.phase(), Phase::kFailed);
  EXPECT_THAT(controller_.message(), HasSubstr("3.80 m from the staging pose"));
}

TEST_F(DockControllerTest, StandingInTheStationWithoutCurrentIsNoSuccess) {
  current_from_contact_ = 100;
  Dock({-0.8, 0, M_PI});
  EXPECT_EQ(controller_.phase(), Phase::kFailed);
  EXPECT_THAT(controller_.message(), HasSubstr("3 attempts failed"));
  EXPECT_THAT(controller_.message(), HasSubstr("no charging current"));
  EXPECT_EQ(contacts_, 6) << "each attempt draws back and presses on once";
  EXPECT_EQ(controller_.failed_attempts(), 3);
  EXPECT_THAT(controller_.why_failed(), HasSubstr("no charging current"));
  EXPECT_LT(Distance(input_.pose, kStaging), 0.1) << "out of the station's way";
}

TEST_F(DockControllerTest, TriesAgainALittleAside) {
  current_from_contact_ = 3;
  Dock({-0.8, 0, M_PI});
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
  EXPECT_EQ(controller_.attempt(), 2);
  EXPECT_EQ(controller_.failed_attempts(), 1);
  EXPECT_NEAR(aside_, settings_.retry_offset, 0.015);
  EXPECT_EQ(std::count(phases_.begin(), phases_.end(), Phase::kBackOut), 1);
}

TEST_F(DockControllerTest, PressesOnBeforeItBacksOut) {
  current_from_contact_ = 2;
  Dock({-0.8, 0, M_PI});
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
  EXPECT_EQ(controller_.attempt(), 1);
  EXPECT_EQ(std::count(phases_.begin(), phases_.end(), Phase::kPressOn), 1);
  EXPECT_EQ(std::count(phases_.begin(), phases_.end(), Phase::kBackOut), 0);
}

TEST_F(DockControllerTest, DrivesInAsFarAsideAsItIsTold) {
  input_.pose = kStaging;
  See();
  current_from_contact_ = 100;
  controller_.StartDocking(input_, -0.08, 1);
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kFailed);
  EXPECT_NEAR(aside_, -0.08, 0.02);
  EXPECT_THAT(controller_.message(), HasSubstr("1 attempts failed"));
}

TEST_F(DockControllerTest, PressesOnAloneAndStaysOnTheStation) {
  input_.pose = station_;
  See();
  contacts_ = 1;
  was_contact_ = true;
  current_from_contact_ = 2;
  controller_.StartPressingOn(input_);
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
  EXPECT_LT(Distance(input_.pose, station_), 0.06);
}

TEST_F(DockControllerTest, DoesNotPressOnAwayFromTheStation) {
  input_.pose = {-0.8, 0, M_PI};
  controller_.StartPressingOn(input_);
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kFailed);
  EXPECT_THAT(controller_.message(), HasSubstr("does not stand on the station"));
}

TEST_F(DockControllerTest, ACurrentThatDoesNotLastIsNoSuccess) {
  input_.pose = kStaging;
  See();
  controller_.StartDocking(input_);
  // Contact that makes and breaks every two seconds.
  double docked_at = -1;
  while (controller_.active() && controller_.attempt() == 1 && input_.now < 200) {
    input_.now += kStep;
    See();
    const bool waiting = controller_.phase() == Phase::kWaitForCurrent;
    if (waiting && docked_at < 0) docked_at = input_.now;
    input_.current = waiting && std::fmod(input_.now - docked_at, 2) < 1 ? 12 : -6;
    input_.pose = Advance(input_.pose, controller_.Update(input_), kStep);
  }
  EXPECT_EQ(controller_.attempt(), 2);
}

TEST_F(DockControllerTest, ABatteryThatDoesNotReportIsNoSuccess) {
  input_.battery_known = false;
  Dock({-0.8, 0, M_PI});
  EXPECT_EQ(controller_.phase(), Phase::kFailed);
  EXPECT_THAT(controller_.message(), HasSubstr("battery does not report"));
}

TEST_F(DockControllerTest, DoesNotDriveIntoWhatStandsBeforeTheStation) {
  fixed_ = {{-1.8, 0.1}};
  Dock({-0.8, 0, M_PI});
  EXPECT_EQ(controller_.phase(), Phase::kFailed);
  EXPECT_THAT(controller_.message(), HasSubstr("obstacle stands before the station"));
  EXPECT_EQ(contacts_, 0);
}

TEST_F(DockControllerTest, LetsOutWhoStandsBetweenItAndTheStation) {
  fixed_ = {{-1.6, 0.1}};
  input_.pose = kStaging;
  See();
  controller_.StartDocking(input_);
  Run(22);
  EXPECT_LT(RelativeTo(station_, input_.pose).x, -2.4);
  fixed_.clear();
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
}

TEST_F(DockControllerTest, TheStationItselfIsNoObstacle) {
  fixed_ = {{-2.83, 0}, {-2.86, 0.1}, {-2.86, -0.1}, {-3, 0.4}, {-3, -0.4}};
  Dock({-0.8, 0, M_PI});
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
}

TEST_F(DockControllerTest, IsDoneAtOnceWhenItIsChargingAlready) {
  was_contact_ = true;
  contacts_ = 1;
  input_.current = 12;
  Dock(station_);
  EXPECT_EQ(controller_.phase(), Phase::kDone);
  EXPECT_LT(input_.now, 4);
}

TEST_F(DockControllerTest, AFullBatteryNeedsNoCurrentToBeDocked) {
  current_from_contact_ = 100;
  input_.full = true;
  Dock({-0.8, 0, M_PI});
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
  EXPECT_EQ(controller_.message(), "docked with a full battery at attempt 1");
}

TEST_F(DockControllerTest, WithoutTheLandmarkItDoesNotDriveIn) {
  is_seen_ = false;
  input_.expected = kDocked;
  Dock(kStaging);
  EXPECT_EQ(controller_.phase(), Phase::kFailed);
  EXPECT_THAT(controller_.message(), HasSubstr("3 attempts failed"));
  EXPECT_THAT(controller_.message(), HasSubstr("landmark of the station is not seen"));
  EXPECT_LT(Distance(input_.pose, kStaging), 0.01);
  EXPECT_LT(input_.now, 25);
}

TEST_F(DockControllerTest, TurnsToWhereTheStationShouldBeInOrderToSeeIt) {
  is_seen_ = false;
  input_.expected = kDocked;
  input_.pose = {-0.8, 0, 0};
  controller_.StartDocking(input_);
  Run(5.9);
  EXPECT_GT(std::abs(input_.pose.yaw), M_PI - 1.1);
  is_seen_ = true;
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
}

TEST_F(DockControllerTest, NeedsNoMapToFindItsStation) {
  is_seen_ = false;
  input_.pose = {-0.8, 0, 0};
  controller_.StartDocking(input_);
  Run(4);
  EXPECT_EQ(controller_.phase(), Phase::kLook);
  EXPECT_GT(std::abs(input_.pose.yaw), 1) << "it looks around";
  is_seen_ = true;
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
}

TEST_F(DockControllerTest, WaitsWhileTheLandmarkIsHidden) {
  input_.pose = {-0.6, 0, M_PI};
  See();
  controller_.StartDocking(input_);
  Run(6);
  is_seen_ = false;
  Run(4);
  const Pose2D stopped = input_.pose;
  Run(3);
  EXPECT_EQ(controller_.phase(), Phase::kFollowPath);
  EXPECT_LT(Distance(input_.pose, stopped), 0.01);
  is_seen_ = true;
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
  EXPECT_EQ(controller_.attempt(), 1);
}

TEST_F(DockControllerTest, TheWayMovesWithTheStationAsItIsSeenBetter) {
  input_.pose = {-0.4, 0.2, M_PI};
  See();
  controller_.StartDocking(input_);
  Run(4);
  station_ = {-2.38, 0.1, M_PI - 0.06};
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
  EXPECT_EQ(controller_.attempt(), 1);
  EXPECT_LT(std::abs(aside_), 0.02);
}

TEST_F(DockControllerTest, PlansAnewWhenTheStationIsSeenElsewhere) {
  input_.pose = {0, 0.2, M_PI};
  See();
  controller_.StartDocking(input_);
  Run(4);
  station_ = {-2.3, -0.3, M_PI - 0.2};
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
  EXPECT_EQ(controller_.attempt(), 1);
  EXPECT_GE(std::count(phases_.begin(), phases_.end(), Phase::kTurnToPath), 2);
}

TEST_F(DockControllerTest, GoesRoundWhatStandsBesideTheStraightWay) {
  fixed_ = {{-0.9, 0.15}, {-0.9, 0.2}, {-0.9, 0.25}};
  Dock({-0.2, 0.5, M_PI});
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
  EXPECT_EQ(controller_.attempt(), 1);
}

TEST_F(DockControllerTest, FailsWhenTheWheelsDoNotMoveIt) {
  wheels_turn_ = 0;
  Dock({-0.8, 0, M_PI});
  EXPECT_EQ(controller_.phase(), Phase::kFailed);
  EXPECT_THAT(controller_.message(), HasSubstr("stuck"));
  EXPECT_LT(input_.now, 60);
}

TEST_F(DockControllerTest, UndocksWithoutSeeingTheLandmark) {
  is_seen_ = false;
  input_.pose = kDocked;
  input_.docked = true;
  input_.current = 12;
  controller_.StartUndocking(input_);
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
  EXPECT_LT(Distance(input_.pose, kStaging), 0.05);
}

TEST_F(DockControllerTest, UndocksStraightBackAndChecksThatTheCurrentStopped) {
  input_.pose = station_;
  input_.current = 12;
  See();
  controller_.StartUndocking(input_);
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
  EXPECT_LT(Distance(input_.pose, kStaging), 0.05);
  EXPECT_LT(input_.now, 20);
}

TEST_F(DockControllerTest, UndockingFailsWhenTheBatteryGoesOnReportingACurrent) {
  input_.pose = station_;
  idle_current_ = 12;
  See();
  controller_.StartUndocking(input_);
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kFailed);
  EXPECT_THAT(controller_.message(), HasSubstr("still reports charging"));
}

TEST_F(DockControllerTest, UndockingFailsWhenTheRobotIsStuck) {
  input_.pose = station_;
  wheels_turn_ = 0;
  See();
  controller_.StartUndocking(input_);
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kFailed);
  EXPECT_THAT(controller_.message(), HasSubstr("stuck on the way off the station, 1.60 m to go"));
}

TEST_F(DockControllerTest, UndockingElsewhereIsDoneAlready) {
  input_.pose = {5, 0, 0};
  controller_.StartUndocking(input_);
  EXPECT_EQ(controller_.phase(), Phase::kDone);
  EXPECT_THAT(controller_.message(), HasSubstr("not docked"));
}

TEST_F(DockControllerTest, CancelledItStands) {
  input_.pose = kStaging;
  controller_.StartDocking(input_);
  Run(3);
  controller_.Cancel();
  EXPECT_FALSE(controller_.active());
  EXPECT_EQ(controller_.Update(input_).linear, 0);
}

}  // namespace
}  // namespace coppice::robot::docking
