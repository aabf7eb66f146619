// The last step of the battery watchdog: the robot switches itself off, or stands and waits.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/trees/tree_scenario.h"

namespace coppice {
namespace {

using leaves::BatteryReading;
using leaves::RecoveryPhase;

constexpr double kEmpty = 0.015;

// Nobody comes, and what is to switch the robot off cannot.
class SwitchOffThatFails : public testing::Test {
 protected:
  SwitchOffThatFails() {
    scenario_.Set("charging", false);
    scenario_.Set("docked", false);
    scenario_.Set("going_home", false);
    scenario_.Set("battery_level", kEmpty);
    scenario_.Set("distance", 30.0);
  }

  void Live(int seconds, double current = -2) {
    for (; seconds > 0; --seconds) {
      scenario_.Advance(1);
      scenario_.Set("battery",
                    BatteryReading{scenario_.now(), 23, current, kEmpty, leaves::kNotMeasured, {}});
      if (scenario_.Tick() == Status::kRunning && scenario_.LastCall().rfind("SwitchOff", 0) == 0) {
        scenario_.Answer(false);
      }
    }
  }
  void Exhaust() { Live(300); }
  void ChargeForAMoment() { Live(10, 12); }

  long Count(RecoveryPhase phase) const {
    const auto& events = scenario_.robot.events;
    return std::count_if(events.begin(), events.end(), [phase](const auto& event) {
      return event.recovery == "switch off" && event.phase == phase;
    });
  }
  bool Stands() const {
    return scenario_.Runs("stands") &&
           scenario_.CallsOf("Suspend") == scenario_.CallsOf("Resume") + 1;
  }

  TreeScenario scenario_{"monitor/battery_watchdog.xml"};
};

TEST_F(SwitchOffThatFails, LeavesTheRobotStandingUntilSomebodyComes) {
  Exhaust();
  ASSERT_EQ(Count(RecoveryPhase::kFailed), 1);
  Live(3600);
  EXPECT_TRUE(Stands());
  EXPECT_EQ(scenario_.CallsBeginning("SwitchOff"), 1);
  EXPECT_EQ(scenario_.CallsBeginning("NavigateTo"), 0);
}

TEST_F(SwitchOffThatFails, IsRefusedOnceAfterThreeTimesInADay) {
  for (int i = 0; i < 4; ++i) {
    Exhaust();
    EXPECT_TRUE(Stands()) << i;
    ChargeForAMoment();
  }
  Exhaust();
  EXPECT_EQ(scenario_.CallsBeginning("SwitchOff"), 3);
  EXPECT_EQ(Count(RecoveryPhase::kRefused), 1);
  EXPECT_TRUE(Stands());
}

}  // namespace
}  // namespace coppice
