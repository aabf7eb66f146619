#include "robot_app/processes/switch_off.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "tests/robot_app/processes/simulated_machine.h"
#include "tests/robot_app/processes/temporary.h"

namespace coppice::robot::processes {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::HasSubstr;

RobotConfig Robot(bool has_safe_stop = true) {
  RobotConfig config;
  config.processes = {MakeProcess("base"), MakeProcess("nav", {0})};
  AddOwnGroups(config);
  config.configurations = {{"operating", {0, 1}, {}}, {"safe", {0}, {}}};
  if (has_safe_stop) config.given_up.configuration = 1;
  return config;
}

class SwitchOffTest : public testing::Test {
 protected:
  SwitchOffTest() {
    EXPECT_TRUE(robot_.RunUntil([this] { return robot_.AllReady(); }, seconds(30)));
  }
  Expected<std::string> Ask(const std::string& token, SimulatedRobot& robot) {
    return switch_off_.Ask("empty", token, robot.supervisor(), robot.machine.now);
  }
  bool TakeStop() { return switch_off_.TakeStop(robot_.supervisor(), robot_.machine.now); }

  SimulatedRobot robot_{Robot()};
  PowerDown switch_off_{true, "secret"};
};

TEST_F(SwitchOffTest, CutsThePowerOnlyWhenTheRobotStands) {
  EXPECT_FALSE(TakeStop());
  EXPECT_TRUE(Ask("secret", robot_));
  EXPECT_FALSE(TakeStop()) << "navigation still runs";
  EXPECT_FALSE(switch_off_.may_cut());
  ASSERT_TRUE(robot_.RunUntil([this] { return TakeStop(); }, seconds(10)));
  EXPECT_EQ(robot_.Phase("nav"), ProcessPhase::kStopped);
  EXPECT_TRUE(switch_off_.may_cut());
  EXPECT_FALSE(TakeStop()) << "once";
}

TEST_F(SwitchOffTest, WithoutTheTokenTheRobotStandsWithThePowerOn) {
  EXPECT_THAT(Ask("guess", robot_).value(), HasSubstr("COPPICE_SWITCH_OFF_TOKEN"));
  ASSERT_TRUE(robot_.RunUntil([this] { return TakeStop(); }, seconds(10)));
  EXPECT_FALSE(switch_off_.may_cut());
  EXPECT_THAT(Ask("secret", robot_).value(), HasSubstr("the power goes off"));
  EXPECT_TRUE(switch_off_.may_cut());
}

TEST_F(SwitchOffTest, AnEmptyTokenOpensNothing) {
  PowerDown nobody(true, "");
  EXPECT_TRUE(nobody.Ask("empty", "", robot_.supervisor(), robot_.machine.now));
  ASSERT_TRUE(robot_.RunUntil(
      [&] { return nobody.TakeStop(robot_.supervisor(), robot_.machine.now); }, seconds(10)));
  EXPECT_FALSE(nobody.may_cut());
}

TEST_F(SwitchOffTest, APersonEndsIt) {
  EXPECT_TRUE(Ask("secret", robot_));
  EXPECT_TRUE(robot_.supervisor().Reset("all", robot_.machine.now));
  robot_.RunFor(seconds(40));
  EXPECT_FALSE(TakeStop());
  EXPECT_FALSE(switch_off_.may_cut());
  EXPECT_EQ(robot_.Phase("nav"), ProcessPhase::kReady);
}

TEST_F(SwitchOffTest, IsRefusedWithoutAConfigurationForTheSafeStop) {
  SimulatedRobot other(Robot(false));
  EXPECT_FALSE(Ask("secret", other));
}

TEST(CutPower, RunsTheCommandAndTellsWhenItFails) {
  const std::string folder = Temporary("switch_off_test");
  std::filesystem::remove_all(folder);
  PosixLauncher launcher(folder);
  EXPECT_TRUE(CutPower({"touch", folder + "/off"}, launcher, seconds(30)));
  EXPECT_TRUE(std::filesystem::exists(folder + "/off"));
  EXPECT_FALSE(CutPower({"false"}, launcher, seconds(30)));
  EXPECT_FALSE(CutPower({"/no/such/program"}, launcher, seconds(30)));
  EXPECT_FALSE(CutPower({"sleep", "1000"}, launcher, milliseconds(100)));
}

}  // namespace
}  // namespace coppice::robot::processes
