// Faults of charging, in a robot at six times real time. Times are ROS time.
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <memory>
#include <set>
#include <string>

#include "robot_app/common/places/pose_file.h"
#include "tests/robot_app/text_of.h"
#include "tests/support/folders.h"
#include "tests/system/fault_case.h"

namespace coppice::robot {
namespace {

using coppice_msgs::HealthEntry;
using coppice_msgs::RecoveryEvent;

RigOptions Options(const std::string& name, const std::string& charge) {
  RigOptions options;
  options.name = name;
  options.start = "2 0 3.14159";
  options.variables = {{"speed", "6"}, {"seed", "4"}, {"state_of_charge", charge}};
  return options;
}

// They end with the configuration "operating".
const std::set<std::string> kRestWhileCharging = {"localization", "navigation",
                                                  "navigation_monitor"};

bool WaitForCurrent(RobotRig& rig, double seconds) {
  const bool flows = rig.WaitFor([](const RobotState& state) { return state.charging(); }, seconds);
  EXPECT_TRUE(flows) << "no current";
  return flows;
}

// Its battery is low, so it drives home at once.
class DockingFaults : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    rig_ = std::make_unique<RobotRig>(Options("docking_faults", "0.26"));
    ASSERT_TRUE(rig_->Start());
  }
  static void TearDownTestSuite() { rig_.reset(); }

  static std::unique_ptr<RobotRig> rig_;
};

std::unique_ptr<RobotRig> DockingFaults::rig_;

TEST_F(DockingFaults, AStationThatWasMovedIsFoundByAnotherAttempt) {
  FaultCase fault(*rig_, "docking miss", "the contacts are bent 5 cm aside");
  ASSERT_TRUE(rig_->Inject("docking_offset", "", 0.05));
  // It has to drive there first; and an attempt lasts 40 s.
  fault.ExpectLevel("docking", "failures", HealthEntry::WARN, 120);
  fault.ExpectRecovery("dock", "docking", RecoveryEvent::FAILED);
  fault.ExpectRecovery("dock from aside", "docking", RecoveryEvent::SUCCEEDED);
  WaitForCurrent(*rig_, 120);
  fault.ExpectNominal();
  EXPECT_TRUE(rig_->WaitFor(
      [](const RobotState& s) { return s.Level("docking", "failures") == HealthEntry::OK; }, 30));
  fault.ExpectOnlyRestarted(kRestWhileCharging);
  fault.ExpectNobodyAsked();
}

TEST_F(DockingFaults, TheLocalizationRestsWhileItCharges) {
  ASSERT_TRUE(WaitForCurrent(*rig_, 120));
  EXPECT_TRUE(rig_->WaitFor(
      [](const RobotState& state) {
        return state.configuration() == "charging" && state.Pid("localization") == 0 &&
               state.Pid("navigation") == 0;
      },
      60));
}

TEST_F(DockingFaults, ContactWithoutCurrentIsNoCharging) {
  ASSERT_TRUE(WaitForCurrent(*rig_, 120));
  FaultCase fault(*rig_, "contact without current", "the charger is off for 40 s");
  ASSERT_TRUE(rig_->Inject("contact_without_current", "", 0, 40));
  // Whoever docks sets about it before it is an error.
  fault.ExpectLevel("charging", "current", HealthEntry::WARN, 20);
  fault.ExpectLevel("docking", "failures", HealthEntry::WARN, 120);
  fault.ExpectRecovery("dock", "docking", RecoveryEvent::BEGUN);
  WaitForCurrent(*rig_, 120);
  fault.ExpectNominal();
  EXPECT_TRUE(rig_->With([](const RobotState& state) { return state.charging(); }));
  fault.ExpectOnlyRestarted(kRestWhileCharging);
  fault.ExpectNobodyAsked();
}

// Half a metre and twenty degrees from where the map of places says; nobody has told the robot.
TEST(MovedStation, IsFoundByItsLandmarkLearnedAndFoundAgainByADockingThatWasKilled) {
  RobotRig rig(Options("moved_station", "0.26"));
  ASSERT_TRUE(rig.Start());
  const Instant begin = rig.Now();
  ASSERT_TRUE(rig.Inject("move_station", "-0.2 0.45 -0.35"));
  ASSERT_TRUE(WaitForCurrent(rig, 120)) << rig.TimelineSince(begin);
  const Pose2D station = Compose(Pose2D{-2.4, 0, M_PI}, {-0.2, 0.45, -0.35});
  const std::string file = (rig.folder() / "institute/station").string();
  const auto is_learned = [&] {
    const auto kept = LoadPose(file);
    return kept && Distance(*kept, station) < 0.1 &&
           std::abs(NormalizeAngle(kept->yaw - station.yaw)) < 0.05;
  };
  EXPECT_TRUE(rig.WaitFor([&](const RobotState&) { return is_learned(); }, 30)) << TextOf(file);

  const int pid = rig.With([](const RobotState& state) { return state.Pid("docking"); });
  ASSERT_TRUE(rig.Signal("docking", SIGKILL));
  ASSERT_TRUE(rig.WaitFor(
      [pid](const RobotState& state) {
        return state.ReadyPid("docking") != 0 && state.ReadyPid("docking") != pid;
      },
      60));
  ASSERT_TRUE(rig.Inject("set_battery", "", 0.95));  // it goes to work,
  ASSERT_TRUE(rig.WaitFor(
      [](const RobotState& state) { return !state.charging() && state.truth().x > -1; }, 120))
      << rig.TimelineSince(begin);
  ASSERT_TRUE(rig.Inject("set_battery", "", 0.26));  // and home again
  ASSERT_TRUE(WaitForCurrent(rig, 240)) << rig.TimelineSince(begin);
  EXPECT_TRUE(is_learned()) << TextOf(file);
  // An attempt may fail, as one in some hundred does, but nobody had to help.
  EXPECT_TRUE(rig.With([](const RobotState& state) { return state.requests().empty(); }));
}

TEST(DockingAndLocalization, KilledTogetherWhileItDocksDockAsTheyWereAsked) {
  RobotRig rig(Options("docking_killed", "0.26"));
  ASSERT_TRUE(rig.Start());
  FaultCase fault(rig, "docking and localization killed", "SIGKILL to both while it docks");
  ASSERT_TRUE(rig.WaitFor([](const RobotState& state) { return state.truth().x < -1.5; }, 120));
  fault.Begin();
  ASSERT_TRUE(rig.Signal("docking", SIGKILL));
  ASSERT_TRUE(rig.Signal("localization", SIGKILL));
  fault.ExpectRestarted("docking");
  fault.ExpectRestarted("localization");
  EXPECT_TRUE(WaitForCurrent(rig, 120)) << rig.TimelineSince(fault.begin());
  fault.ExpectRecovery("dock", "docking", RecoveryEvent::SUCCEEDED);
  fault.ExpectNominal();
  fault.ExpectNobodyAsked();
}

// The application never looks at the battery, as if its signal had got lost.
TEST(MissedChargeSignal, IsMadeUpForByTheBatteryWatchdog) {
  RigOptions options = Options("missed_charge", "0.9");
  options.variables.emplace_back("application", SourceFolder() + "/tests/system/trees/shuttle.xml");
  RobotRig rig(options);
  ASSERT_TRUE(rig.Start());
  FaultCase fault(rig, "missed charge signal", "the battery is at 12 %, the application drives on");
  ASSERT_TRUE(rig.Inject("set_battery", "", 0.12));
  fault.ExpectDetected("battery", "margin", 20);
  fault.ExpectRecovery("drive home and charge", "battery", RecoveryEvent::BEGUN);
  EXPECT_TRUE(WaitForCurrent(rig, 180));
  EXPECT_LE(rig.Now().ros - fault.begin().ros, 60 + 240) << "it took over too late";
  ASSERT_TRUE(rig.Inject("set_battery", "", 0.5));  // it would charge for hours
  fault.ExpectNominal();
  fault.ExpectOnlyRestarted(kRestWhileCharging);
  fault.ExpectNobodyAsked();
}

}  // namespace
}  // namespace coppice::robot
