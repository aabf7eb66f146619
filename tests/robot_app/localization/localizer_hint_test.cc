// Hints of somebody who recognizes places: believed only if the scan fits there.
#include <gtest/gtest.h>

#include <cmath>

#include "robot_app/localization/localizer.h"
#include "tests/robot_app/localization/localized_robot.h"

namespace coppice::robot::localization {
namespace {

constexpr Pose2D kOffice104{32, 5, 1};  // looks like 101 to the scanner
constexpr Pose2D kOffice101{8, 5, 1};

class LocalizerHintTest : public testing::Test {
 protected:
  // Known to be in the hall, then carried away and lost.
  std::unique_ptr<LocalizedRobot> CarriedTo(const Pose2D& place) const {
    auto robot = Started({46, 0, 0});
    robot->Carry(place);
    EXPECT_GE(robot->DriveUntil({}, 8, [&] { return robot->IsLost(); }), 0);
    return robot;
  }
  std::unique_ptr<LocalizedRobot> Started(const Pose2D& pose) const {
    auto robot = std::make_unique<LocalizedRobot>(floor_, pose, 1);
    robot->localizer().Expect({pose});
    robot->Drive({}, 1);
    EXPECT_TRUE(robot->IsOk());
    return robot;
  }
  static void Hint(LocalizedRobot& robot, const Pose2D& pose) {
    robot.localizer().AddHint(robot.now(), pose);
    robot.Drive({}, 0.5);
  }

  simulation::Floor floor_ = navigation::InstituteFloor();
};

TEST_F(LocalizerHintTest, TellsWhichOfTwoOfficesThatLookAlikeItIsWithoutATurn) {
  const auto robot = CarriedTo(kOffice104);
  EXPECT_TRUE(std::isinf(robot->Report().seconds_since_recognized));
  Hint(*robot, Compose(robot->Truth(), {0.2, -0.1, 0.05}));
  EXPECT_TRUE(robot->IsOk()) << robot->Report().message;
  EXPECT_LT(robot->Error(), 0.1);
  EXPECT_LT(robot->Report().seconds_since_recognized, 1);
  robot->TurnOnce();  // the other office still fits as well
  EXPECT_TRUE(robot->IsOk()) << robot->Report().message;
  EXPECT_LT(robot->Error(), 0.1);
}

TEST_F(LocalizerHintTest, EndsTheDoubtOfARobotThatHasLookedAround) {
  const auto robot = CarriedTo(kOffice104);
  robot->TurnOnce();
  EXPECT_EQ(robot->Report().phase, LocalizationPhase::kUncertain);
  Hint(*robot, robot->Truth());
  EXPECT_TRUE(robot->IsOk()) << robot->Report().message;
  EXPECT_LT(robot->Error(), 0.1);
}

TEST_F(LocalizerHintTest, IsNotBelievedWhereTheScanDoesNotFit) {
  const auto robot = CarriedTo(kOffice104);
  Hint(*robot, {46, 2, 0});
  EXPECT_TRUE(robot->IsLost());
  EXPECT_TRUE(std::isinf(robot->Report().seconds_since_recognized));
  const auto sure = Started({46, 0, 0});
  Hint(*sure, kOffice104);
  sure->Drive({}, 3);
  EXPECT_TRUE(sure->IsOk());
}

// Nothing but pictures can tell that it was carried there while its scanner was blind.
TEST_F(LocalizerHintTest, ASureRobotDoubtsAtTheFirstAndMovesAtTheSecondFromAnotherView) {
  const auto robot = Started(kOffice101);
  robot->SetLook([](const simulation::World& world) {
    LaserScan scan = navigation::ScanOf(world);
    scan.ranges.assign(scan.ranges.size(), NAN);
    return scan;
  });
  robot->Carry(kOffice104);
  robot->Drive({}, 0.5);
  robot->SetLook(navigation::SeesAll);
  robot->Drive({}, 0.5);
  Hint(*robot, robot->Truth());
  robot->Drive({}, 2);
  EXPECT_FALSE(robot->IsOk());
  robot->Drive({0, 0.4}, 1.5);
  Hint(*robot, robot->Truth());
  EXPECT_TRUE(robot->IsOk()) << robot->Report().message;
  EXPECT_LT(robot->Error(), 0.1);
}

// It doubts, and looks for other places; but it is not sure to be where it is not.
TEST_F(LocalizerHintTest, ASureRobotIsNotMovedByHintsOfTheSameViewHoweverMany) {
  const auto robot = Started(kOffice101);
  for (int i = 0; i < 30; ++i) {
    Hint(*robot, kOffice104);
    EXPECT_TRUE(robot->Error() < 0.1 || !robot->IsOk()) << i;
  }
  EXPECT_TRUE(std::isinf(robot->Report().seconds_since_recognized));
}

TEST_F(LocalizerHintTest, WhatWasSeenBeforeItWasCarriedIsNotUsed) {
  const auto robot = Started(kOffice101);
  const double before = robot->now() - 0.2;
  robot->Carry({46, 0, 0});
  robot->Drive({}, 0.2);
  robot->localizer().AddHint(before, kOffice101);
  robot->localizer().AddHint(robot->now() - 60, kOffice101);  // older than any history
  robot->Drive({}, 0.5);
  EXPECT_TRUE(std::isinf(robot->Report().seconds_since_recognized));
}

TEST_F(LocalizerHintTest, IsTheFirstPoseOfARobotThatWasStartedAnywhere) {
  LocalizedRobot robot(floor_, kOffice104, 1);
  robot.Drive({}, 1);
  EXPECT_FALSE(robot.IsOk());
  Hint(robot, robot.Truth());
  EXPECT_TRUE(robot.IsOk()) << robot.Report().message;
  EXPECT_LT(robot.Error(), 0.1);
}

}  // namespace
}  // namespace coppice::robot::localization
