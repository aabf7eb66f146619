#include "robot_app/ros/feeds.h"

#include <coppice_msgs/Health.h>
#include <coppice_msgs/ProcessStates.h>
#include <gtest/gtest.h>
#include <sensor_msgs/BatteryState.h>

#include <cmath>
#include <limits>

#include "bt_core/engine/executor.h"
#include "bt_nodes/monitoring/monitoring_leaves.h"
#include "bt_nodes/power/power_leaves.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"

namespace coppice::robot::adapters {
namespace {

using leaves::BatteryReading;
using leaves::Health;

constexpr char kTree[] = R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>
  <IsCharging charging="{charging}"/>
  <IsDocked docked="{docked}"/>
  <IsBatteryLow level="{battery_level}" threshold="0.5"/>
  <ReadHealth monitoring="{monitoring}" health="{health}" errors="{errors}"/>
  <ChargeDue battery="{battery}"/>
  <WasEntryUpdated entry="{processes}"/>
  <WasEntryUpdated entry="{configuration}"/>
</Sequence></BehaviorTree></root>)";

class FeedsTest : public testing::Test {
 protected:
  FeedsTest() {
    auto registry = std::make_shared<Registry>();
    registry->Register<leaves::IsCharging>("IsCharging");
    registry->Register<leaves::IsDocked>("IsDocked");
    registry->Register<leaves::IsBatteryLow>("IsBatteryLow");
    registry->Register<leaves::ReadHealth>("ReadHealth");
    registry->Register<leaves::ChargeDue>("ChargeDue");
    Diagnostics diagnostics;
    auto project = Project::FromText(kTree, "feeds", diagnostics);
    auto program = Compile(std::make_shared<Project>(*std::move(project)), registry, diagnostics);
    executor_ = std::make_unique<Executor>(program, clock_);
    subscribers_ = SubscribeFeeds(
        node_,
        {{executor_->Writer<double>("battery_level"), executor_->Writer<bool>("charging"),
          executor_->Writer<bool>("docked"), executor_->Writer<Health>("monitoring"),
          executor_->Writer<std::string>("configuration"), executor_->Writer<std::string>("site"),
          executor_->Writer<bool>("manual"), executor_->Writer<std::string>("processes"),
          executor_->Writer<BatteryReading>("battery")}},
        clock_);
  }

  template <class Message>
  void Publish(const std::string& topic, const Message& message) {
    publishers_.push_back(node_.advertise<Message>(topic, 1, true));
    publishers_.back().publish(message);
  }

  const Value& Key(const std::string& key) {
    executor_->Tick();
    return executor_->blackboard()[executor_->program().layout.Find(kMainScope, key)].value;
  }

  SimulatedClock clock_{std::chrono::seconds(7)};
  ros::NodeHandle node_;
  std::unique_ptr<Executor> executor_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::Publisher> publishers_;
};

TEST_F(FeedsTest, BringTheBatteryToTheTree) {
  sensor_msgs::BatteryState battery;
  battery.percentage = 0.25f;
  battery.power_supply_status = sensor_msgs::BatteryState::POWER_SUPPLY_STATUS_CHARGING;
  Publish("/battery_state", battery);
  ASSERT_TRUE(Eventually([this] { return Key("battery_level").has_value(); }));
  EXPECT_DOUBLE_EQ(Key("battery_level").Get<double>(), 0.25);
  EXPECT_TRUE(Key("charging").Get<bool>());
}

TEST_F(FeedsTest, BringTheRawReadingAndSayWhatIsNotMeasured) {
  sensor_msgs::BatteryState battery;
  battery.voltage = 24.5f;
  battery.current = -15;
  battery.percentage = std::numeric_limits<float>::quiet_NaN();
  Publish("/battery_state", battery);
  ASSERT_TRUE(Eventually([this] { return Key("battery").has_value(); }));
  const BatteryReading reading = Key("battery").Get<BatteryReading>();
  EXPECT_EQ(reading.stamp, Time(std::chrono::seconds(7)));
  EXPECT_DOUBLE_EQ(reading.voltage, 24.5);
  EXPECT_DOUBLE_EQ(reading.current, -15);
  EXPECT_TRUE(std::isnan(reading.level));
}

TEST_F(FeedsTest, AFullBatteryOnTheStationIsDockedAlthoughNoCurrentFlows) {
  sensor_msgs::BatteryState battery;
  battery.percentage = 0.97f;
  battery.power_supply_status = sensor_msgs::BatteryState::POWER_SUPPLY_STATUS_FULL;
  Publish("/battery_state", battery);
  ASSERT_TRUE(Eventually([this] { return Key("docked").has_value(); }));
  EXPECT_TRUE(Key("docked").Get<bool>());
  EXPECT_FALSE(Key("charging").Get<bool>());
  EXPECT_EQ(Key("battery_level").Get<double>(), 1);
}

TEST_F(FeedsTest, ALevelThatIsNotMeasuredHoldsForTenSecondsAndThenIsUnknown) {
  sensor_msgs::BatteryState battery;
  battery.percentage = 0.75f;
  Publish("/battery_state", battery);
  ASSERT_TRUE(Eventually([this] { return Key("battery_level").has_value(); }));
  battery.percentage = std::numeric_limits<float>::quiet_NaN();
  const auto is_heard = [this] {
    return Key("battery").Get<BatteryReading>().stamp == clock_.Now();
  };
  clock_.Advance(std::chrono::milliseconds(9900));
  publishers_.back().publish(battery);
  ASSERT_TRUE(Eventually(is_heard));
  EXPECT_EQ(Key("battery_level").Get<double>(), 0.75);
  clock_.Advance(std::chrono::milliseconds(100));
  publishers_.back().publish(battery);
  ASSERT_TRUE(Eventually(is_heard));
  EXPECT_LT(Key("battery_level").Get<double>(), 0);
}

TEST_F(FeedsTest, WhatTheBatteryDoesNotTellIsNotMadeUp) {
  sensor_msgs::BatteryState battery;
  battery.current = std::numeric_limits<float>::quiet_NaN();
  Publish("/battery_state", battery);
  ASSERT_TRUE(Eventually([this] { return Key("battery").has_value(); }));
  EXPECT_FALSE(Key("docked").has_value());
  EXPECT_FALSE(Key("charging").has_value());
}

TEST_F(FeedsTest, StampTheHealthReportOnArrival) {
  coppice_msgs::Health report;
  report.entries.resize(1);
  report.entries[0].monitor = "node";
  report.entries[0].node = "/a";
  report.entries[0].level = coppice_msgs::HealthEntry::ERROR;
  Publish("/monitoring", report);
  ASSERT_TRUE(Eventually([this] { return Key("monitoring").has_value(); }));
  const Health health = Key("monitoring").Get<Health>();
  EXPECT_EQ(health.stamp, Time(std::chrono::seconds(7)));
  ASSERT_NE(health.FirstError("node"), nullptr);
  EXPECT_EQ(health.FirstError("node")->node, "/a");
}

TEST_F(FeedsTest, ALevelThatThereIsNotIsTheWorst) {
  coppice_msgs::Health report;
  report.entries.resize(1);
  report.entries[0].level = 200;
  Publish("/monitoring", report);
  ASSERT_TRUE(Eventually([this] { return Key("monitoring").has_value(); }));
  EXPECT_EQ(Key("monitoring").Get<Health>().entries[0].level, leaves::HealthLevel::kStale);
}

TEST_F(FeedsTest, BringTheProcessesAsRowsAndOnlyWhenTheyHaveChanged) {
  coppice_msgs::ProcessStates states;
  states.processes.resize(1);
  states.processes[0].name = "ekf";
  states.processes[0].state = coppice_msgs::ProcessState::BACKING_OFF;
  Publish("/processes", states);
  ASSERT_TRUE(Eventually([this] { return Key("processes").has_value(); }));
  const auto rows = [this] { return Key("processes").Get<std::string>(); };
  EXPECT_NE(rows().find("\"state\":\"BACKING_OFF\""), std::string::npos) << rows();

  const SlotIndex slot = executor_->program().layout.Find(kMainScope, "processes");
  const auto writes = [&] { return executor_->blackboard()[slot].writes; };
  const auto before = writes();
  publishers_.back().publish(states);  // the same again
  states.processes[0].state = coppice_msgs::ProcessState::READY;
  publishers_.back().publish(states);
  ASSERT_TRUE(Eventually([&] { return rows().find("READY") != std::string::npos; }));
  EXPECT_EQ(writes(), before + 1);
}

TEST_F(FeedsTest, TheConfigurationIsEmptyUntilItIsKnown) {
  ASSERT_TRUE(Key("configuration").has_value());
  EXPECT_EQ(Key("configuration").Get<std::string>(), "");
  coppice_msgs::ProcessStates states;
  states.configuration = "mapping";
  Publish("/processes", states);
  EXPECT_TRUE(Eventually([this] { return Key("configuration").Get<std::string>() == "mapping"; }));
}

TEST_F(FeedsTest, TakeNoHarmFromKeysThatTheTreeDoesNotUse) {
  coppice_msgs::ProcessStates states;
  states.configuration = "operating";
  Publish("/processes", states);
  sensor_msgs::BatteryState battery;
  Publish("/battery_state", battery);
  EXPECT_TRUE(Eventually([this] { return Key("charging").has_value(); }));
}

}  // namespace
}  // namespace coppice::robot::adapters
