#include "robot_app/monitoring/aggregator/diagnostics_messages.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot_app/monitoring/diagnostics_monitor.h"

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using Status = diagnostic_msgs::DiagnosticStatus;

class DiagnosticsMessagesTest : public testing::Test {
 protected:
  DiagnosticsMessagesTest() { ros::Time::init(); }
};

TEST_F(DiagnosticsMessagesTest, AFindingIsAStatusWithItsHostAndValues) {
  const auto array = ToDiagnostics({{"battery", "voltage", "/base", HealthLevel::kError, 22.5, "V",
                                     "22.5 V, expected at least 23 V", Time{}, "robot"}});
  ASSERT_EQ(array.status.size(), 1u);
  const Status& status = array.status[0];
  EXPECT_FALSE(array.header.stamp.isZero());
  EXPECT_EQ(status.name, "coppice: battery voltage");
  EXPECT_EQ(+status.level, +Status::ERROR);
  EXPECT_EQ(status.message, "22.5 V, expected at least 23 V");
  EXPECT_EQ(status.hardware_id, "robot");
  ASSERT_EQ(status.values.size(), 3u);
  EXPECT_EQ(status.values[0].key, "value");
  EXPECT_EQ(status.values[0].value, "22.5");
  EXPECT_EQ(status.values[1].value, "V");
  EXPECT_EQ(status.values[2].value, "/base");
}

TEST_F(DiagnosticsMessagesTest, TheLevelsHaveTheSameNumbers) {
  EXPECT_EQ(static_cast<int>(HealthLevel::kOk), +Status::OK);
  EXPECT_EQ(static_cast<int>(HealthLevel::kWarn), +Status::WARN);
  EXPECT_EQ(static_cast<int>(HealthLevel::kError), +Status::ERROR);
  EXPECT_EQ(static_cast<int>(HealthLevel::kStale), +Status::STALE);
}

TEST_F(DiagnosticsMessagesTest, WhatIsNotKnownIsLeftOut) {
  const auto array = ToDiagnostics(
      {{"cpu", "temperature", "", HealthLevel::kOk, std::nan(""), "", "", Time{}, ""}});
  EXPECT_TRUE(array.status.at(0).values.empty());
  EXPECT_EQ(array.status[0].message, "OK");
}

// From us to /diagnostics and back, and from /diagnostics through us: neither comes round again.
TEST_F(DiagnosticsMessagesTest, NothingGoesInCircles) {
  const Finding own{"node", "/a", "/a", HealthLevel::kError, 0, "", "dead", Time{}, ""};
  DiagnosticsMonitor monitor;
  monitor.Watch(DiagnosticsWatch{std::chrono::seconds(5)}, Time{});
  for (const Status& status : ToDiagnostics({own}).status) {
    monitor.OnStatus(status.name, status.level, status.message, Time{});
  }
  EXPECT_TRUE(monitor.Report({}, {}).empty());
  monitor.OnStatus("lidar", Status::WARN, "dirty", Time{});
  ASSERT_EQ(monitor.Report({}, {}).size(), 1u);
  EXPECT_TRUE(ToDiagnostics(monitor.Report({}, {})).status.empty());
}

}  // namespace
}  // namespace coppice::robot::monitoring
