// Faults of charging, in a robot at six times real time. Times are ROS time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <sstream>

#include "tests/system/fault_case.h"

namespace coppice::robot {
namespace {

using coppice_msgs::HealthEntry;

RigOptions Options(const std::string& name, const std::string& charge) {
  RigOptions options;
  options.name = name;
  options.start = "20 0 3.14159";
  options.variables = {{"speed", "6"}, {"seed", "4"}, {"state_of_charge", charge}};
  return options;
}

std::string TextOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

bool WaitForCurrent(RobotRig& rig, double seconds) {
  const bool flows = rig.WaitFor([](const RobotState& state) { return state.charging(); }, seconds);
  EXPECT_TRUE(flows) << "no current";
  return flows;
}

// Its battery is low, so it drives home at once.
class DockingFaults : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    rig_ = std::make_unique<RobotRig>(Options("docking_faults", "0.22"));
    ASSERT_TRUE(rig_->Start());
  }
  static void TearDownTestSuite() { rig_.reset(); }

  static std::unique_ptr<RobotRig> rig_;
};

std::unique_ptr<RobotRig> DockingFaults::rig_;

TEST_F(DockingFaults, AStationThatWasMovedIsFoundByAnotherAttempt) {
  FaultCase fault(*rig_, "docking miss", "the station stands 5 cm aside");
  ASSERT_TRUE(rig_->Inject("docking_offset", "", 0.05));
  // It has to drive there first, 22 m. An attempt that is followed by a better one is no fault of
  // the robot's health; the docking program tells of it.
  WaitForCurrent(*rig_, 120);
  EXPECT_THAT(TextOf(rig_->log("docking")), testing::HasSubstr("1 attempts failed"));
  fault.ExpectNominal();
  fault.ExpectNobodyAsked();
  fault.set_recovery("another attempt, a little aside");
}

TEST_F(DockingFaults, ContactWithoutCurrentIsNoCharging) {
  ASSERT_TRUE(WaitForCurrent(*rig_, 120));
  FaultCase fault(*rig_, "contact without current", "the charger is off for 60 s");
  ASSERT_TRUE(rig_->Inject("contact_without_current", "", 0, 60));
  fault.ExpectDetected("charging", "current", 20);
  ASSERT_TRUE(rig_->WaitFor([](const RobotState& state) { return !state.charging(); }, 30));
  WaitForCurrent(*rig_, 120);
  fault.ExpectNominal();
  fault.ExpectNobodyAsked();
  fault.set_recovery("press on, dock anew");
}

// The application never looks at the battery, as if its signal had got lost.
TEST(MissedChargeSignal, IsMadeUpForByTheBatteryWatchdog) {
  RigOptions options = Options("missed_charge", "0.9");
  options.variables.emplace_back(
      "application", std::string(COPPICE_SOURCE_DIR) + "/tests/system/trees/shuttle.xml");
  RobotRig rig(options);
  ASSERT_TRUE(rig.Start());
  FaultCase fault(rig, "missed charge signal", "the battery is at 20 %, the application drives on");
  ASSERT_TRUE(rig.Inject("set_battery", "", 0.2));
  fault.ExpectLevel("battery", "charge", HealthEntry::WARN, 10);
  EXPECT_TRUE(WaitForCurrent(rig, 180));
  EXPECT_LE(rig.Now().ros - fault.begin().ros, 60 + 240) << "it took over too late";
  fault.ExpectNominal();
  fault.ExpectNobodyAsked();
  fault.set_recovery("after 60 s the battery watchdog halts the application and docks");
}

}  // namespace
}  // namespace coppice::robot
