#include "robot_app/processes/config/supervisor_settings.h"

#include <gtest/gtest.h>

namespace coppice::robot::processes {
namespace {

TEST(SupervisorSettingsTest, KnowsDefaults) {
  const auto settings =
      ReadSupervisorSettings({"--config", "/etc/robot.yaml", "--logs", "/l"}, "/b");
  ASSERT_FALSE(settings.exit);
  EXPECT_EQ(settings.port, 11311);
  EXPECT_EQ(settings.address, "");
  EXPECT_EQ(settings.state, "/l/supervisor.json");
  EXPECT_EQ(settings.variables, (Variables{{"bin", "/b"}, {"config", "/etc"}, {"record", "/l"}}));
}

TEST(SupervisorSettingsTest, TheLastPortCounts) {
  const auto settings =
      ReadSupervisorSettings({"--config", "x", "--port", "0", "--port", "1234"}, "/b");
  ASSERT_FALSE(settings.exit);
  EXPECT_EQ(settings.port, 1234);
}

TEST(SupervisorSettingsTest, VariablesMayBeSetAndReplaced) {
  const auto settings = ReadSupervisorSettings(
      {"--set", "speed=8", "--config", "x", "--set", "record=/r", "--set", "empty="}, "/b");
  ASSERT_FALSE(settings.exit);
  EXPECT_EQ(settings.variables.at("speed"), "8");
  EXPECT_EQ(settings.variables.at("record"), "/r");
  EXPECT_EQ(settings.variables.at("empty"), "");
}

TEST(SupervisorSettingsTest, RefusesWhatMakesNoSense) {
  EXPECT_EQ(ReadSupervisorSettings({}, "/b").exit, 2);
  EXPECT_EQ(ReadSupervisorSettings({"--config", "x", "--port", "none"}, "/b").exit, 2);
  EXPECT_EQ(ReadSupervisorSettings({"--config", "x", "--port", "70000"}, "/b").exit, 2);
  EXPECT_EQ(ReadSupervisorSettings({"--config", "x", "more"}, "/b").exit, 2);
  EXPECT_EQ(ReadSupervisorSettings({"--config", "x", "--set", "=1"}, "/b").exit, 2);
  EXPECT_EQ(ReadSupervisorSettings({"--config", "x", "--set"}, "/b").exit, 2);
  EXPECT_EQ(ReadSupervisorSettings({"--config", ""}, "/b").exit, 2);
  EXPECT_EQ(ReadSupervisorSettings({"--config", "x", "--logs", ""}, "/b").exit, 2);
  EXPECT_EQ(ReadSupervisorSettings({"--config", "x", "--state", ""}, "/b").exit, 2);
}

}  // namespace
}  // namespace coppice::robot::processes
