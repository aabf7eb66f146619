#include "robot_app/metrics/robot_metrics.h"

#include <gmock/gmock.h>

#include "bt_core/model/utf8.h"

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

TEST(RobotMetrics, NamesOfStrangersLeaveThePageReadable) {
  RobotMetrics metrics;
  metrics.CountRecovery("a\xff\n\x1b[2J\xe2\x82", "begun");
  metrics.SetHealth({{"\xfe", "load", "", leaves::HealthLevel::kError, ""}});
  metrics.SetProcesses({"\x80up", false, {{"navi\xc0gation", 4, 7}}});
  const std::string text = TextOf(metrics);
  EXPECT_EQ(FindInvalidUtf8(text), text.size());
  EXPECT_THAT(text, HasSubstr("recovery=\"a[2J\""));
  EXPECT_THAT(text, HasSubstr("coppice_process_state{process=\"navigation\"} 4\n"));
}

TEST(RobotMetrics, NamesWithoutEndTakeNoMoreMemoryThanSome) {
  RobotMetrics metrics;
  std::vector<leaves::HealthEntry> entries;
  std::map<std::string, double> figures{{"lost", 1}};
  for (int i = 0; i < 5000; ++i) {
    const std::string name = std::to_string(i) + std::string(10000, 'x');
    metrics.CountRecovery(name, "begun");
    entries.push_back({name, name, "", leaves::HealthLevel::kOk, ""});
    figures[name] = i;
  }
  metrics.SetHealth(entries);
  metrics.SetStore(figures);
  metrics.SetProcesses({"c", false, std::vector<ProcessFigures>(5000, {"p", 1, 1})});
  EXPECT_LT(TextOf(metrics).size(), 1U << 20);
}

}  // namespace
}  // namespace coppice::robot::metrics
