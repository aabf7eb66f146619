#include "robot_app/metrics/robot_metrics.h"

#include <gmock/gmock.h>

namespace coppice::robot::metrics {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string TextOf(const RobotMetrics& metrics) {
  MetricTable table;
  metrics.Collect(table);
  return table.Text();
}

TEST(RobotMetrics, SaysNothingOfWhatItHasNotHeard) { EXPECT_EQ(TextOf(RobotMetrics()), ""); }

TEST(RobotMetrics, TellsTheWorstLevelOfEachSubject) {
  RobotMetrics metrics;
  metrics.SetHealth({{"cpu", "load", "", leaves::HealthLevel::kOk, ""},
                     {"cpu", "load", "", leaves::HealthLevel::kError, ""}});
  EXPECT_THAT(TextOf(metrics),
              HasSubstr("coppice_health_level{monitor=\"cpu\",subject=\"load\"} 2\n"));
}

TEST(RobotMetrics, LeavesOutWhatIsNotMeasured) {
  RobotMetrics metrics;
  leaves::BatteryReading battery;
  battery.level = 0.5;
  metrics.SetBattery(battery);
  EXPECT_THAT(TextOf(metrics), HasSubstr("coppice_battery_charge_ratio 0.5\n"));
  EXPECT_THAT(TextOf(metrics), Not(HasSubstr("coppice_battery_volts")));
  EXPECT_THAT(TextOf(metrics), Not(HasSubstr("coppice_docked")));
}

TEST(RobotMetrics, TellsStateAndRestartsOfPrograms) {
  RobotMetrics metrics;
  metrics.SetProcesses({"operating", true, {{"navigation", 4, 7}}});
  const std::string text = TextOf(metrics);
  EXPECT_THAT(text, HasSubstr("coppice_configuration{configuration=\"operating\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("coppice_safe_stop 1\n"));
  EXPECT_THAT(text, HasSubstr("coppice_process_state{process=\"navigation\"} 4\n"));
  EXPECT_THAT(text, HasSubstr("coppice_process_restarts_total{process=\"navigation\"} 7\n"));
}

TEST(RobotMetrics, CountsRecoveriesByWhatCameOfThem) {
  RobotMetrics metrics;
  metrics.CountRecovery("wait", "begun");
  metrics.CountRecovery("wait", "begun");
  metrics.CountRecovery("wait", "helped");
  EXPECT_THAT(TextOf(metrics),
              HasSubstr("coppice_recoveries_total{recovery=\"wait\",phase=\"begun\"} 2\n"));
}

TEST(RobotMetrics, TellsWhatWaitsInTheStoreAndWhoWaitsForAPerson) {
  RobotMetrics metrics;
  metrics.SetStore({{"documents", 12}, {"lost", 3}, {"unheard of", 1}});
  metrics.SetOpenRequests(2);
  const std::string text = TextOf(metrics);
  EXPECT_THAT(text, HasSubstr("coppice_store_waiting_messages 12\n"));
  EXPECT_THAT(text, HasSubstr("coppice_store_lost_messages_total 3\n"));
  EXPECT_THAT(text, HasSubstr("coppice_open_requests 2\n"));
}

}  // namespace
}  // namespace coppice::robot::metrics
