#include "robot_app/monitoring/power/power_fields.h"

#include <gmock/gmock.h>

#include "robot_app/monitoring/gauges/band_fields.h"
#include "tests/robot_app/monitoring/fields_fixture.h"
#include "tests/support/folders.h"

namespace coppice::robot::monitoring {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;

class PowerFieldsTest : public FieldsTest {};

TEST_F(PowerFieldsTest, ABatteryNeedsItsTopicAndNodeOnly) {
  YamlFields fields = Open("{topic: /battery_state, node: /base}");
  const BatteryLimits watch = ReadBatteryLimits(fields);
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(watch.staleness, seconds(5));
  EXPECT_EQ(watch.voltage, Band()) << "depends on the cells";
  EXPECT_EQ(watch.charge, AtLeast(0.25, 0.15, 3, 0.01));
  EXPECT_EQ(watch.model.capacity, leaves::BatteryModel().capacity);
  EXPECT_FALSE(watch.dock);
}

TEST_F(PowerFieldsTest, TheModelAndTheDockAreOfTheRobot) {
  YamlFields fields = Open(R"(
topic: /battery_state
node: /base
voltage: {error: [23, none]}
model: {capacity: 40, driving_speed: 0.5, docking_attempts: 2}
dock: {x: -2.4, y: 1, base_frame: base, detour: 2})");
  const BatteryLimits watch = ReadBatteryLimits(fields);
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(watch.voltage.error, (Range{23, std::nullopt}));
  EXPECT_EQ(watch.model.capacity, 40);
  EXPECT_EQ(watch.model.driving_speed, 0.5);
  EXPECT_EQ(watch.model.docking_attempts, 2);
  ASSERT_TRUE(watch.dock);
  EXPECT_EQ(watch.dock->x, -2.4);
  EXPECT_EQ(watch.dock->map_frame, "map");
  EXPECT_EQ(watch.dock->base_frame, "base");
  EXPECT_EQ(watch.dock->detour, 2);
}

TEST_F(PowerFieldsTest, TheDockIsTheStationOfTheFileOfPlaces) {
  const std::string places = SourceFolder() + "/robot_app/config/sites/institute/places.yaml";
  YamlFields fields = Open("{topic: /battery_state, node: /base, dock: {places: " + places + "}}");
  const BatteryLimits watch = ReadBatteryLimits(fields);
  EXPECT_EQ(Errors(), "");
  ASSERT_TRUE(watch.dock);
  EXPECT_EQ(watch.dock->x, -2.4);
  EXPECT_EQ(watch.dock->y, 0);
}

TEST_F(PowerFieldsTest, AFileOfPlacesThatIsMissingIsAnError) {
  YamlFields fields = Open("{topic: /battery_state, node: /base, dock: {places: nowhere.yaml}}");
  ReadBatteryLimits(fields);
  EXPECT_THAT(Errors(), HasSubstr("nowhere.yaml"));
}

TEST_F(PowerFieldsTest, AWayThatIsShorterThanTheStraightLineIsAnError) {
  YamlFields fields = Open("{topic: /battery_state, node: /base, dock: {detour: 0.5}}");
  ReadBatteryLimits(fields);
  EXPECT_THAT(Errors(), HasSubstr("detour"));
}

TEST_F(PowerFieldsTest, ChargingAndDockingHaveDefaults) {
  YamlFields charging = Open("within: 20");
  const ChargingWatch current = ReadChargingWatch(charging);
  EXPECT_EQ(current.within, seconds(20));
  EXPECT_EQ(current.interruption, seconds(5));
  EXPECT_EQ(current.full, 0.95);
  YamlFields docking = Open("{action: /docking, node: /docking}");
  const DockingWatch attempts = ReadDockingWatch(docking);
  EXPECT_EQ(attempts.failures, AtMost(0, 2));
  EXPECT_EQ(attempts.forget, seconds(600));
  EXPECT_EQ(Errors(), "");
}

TEST_F(PowerFieldsTest, AnEmergencyStopMayBeSilent) {
  YamlFields fields = Open("topic: /emergency_stop");
  EXPECT_EQ(ReadEmergencyStopWatch(fields).staleness, Duration::zero());
  EXPECT_EQ(Errors(), "");
  YamlFields wrong = Open("topic: emergency_stop");
  ReadEmergencyStopWatch(wrong);
  EXPECT_THAT(Errors(), HasSubstr("topic")) << "a ROS name begins with a slash";
}

}  // namespace
}  // namespace coppice::robot::monitoring
