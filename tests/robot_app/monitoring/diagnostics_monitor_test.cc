#include "robot_app/monitoring/diagnostics_monitor.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::seconds;

class DiagnosticsMonitorTest : public testing::Test {
 protected:
  DiagnosticsMonitorTest() { monitor_.Watch(DiagnosticsWatch{seconds(5)}, Time(seconds(1))); }
  std::vector<Finding> At(Time wall) { return monitor_.Report({}, {Time(seconds(9)), wall}); }
  DiagnosticsMonitor monitor_;
};

TEST_F(DiagnosticsMonitorTest, LevelsAreMapped) {
  const struct {
    int level;
    HealthLevel expected;
  } kRows[] = {{0, HealthLevel::kOk},    {1, HealthLevel::kWarn},   {2, HealthLevel::kError},
               {3, HealthLevel::kStale}, {17, HealthLevel::kStale}, {-1, HealthLevel::kStale}};
  for (const auto& row : kRows) {
    monitor_.OnStatus("lidar: motor", row.level, "hot", Time(seconds(1)));
    const auto findings = At(Time(seconds(1)));
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].level, row.expected) << row.level;
    EXPECT_EQ(findings[0].monitor, "diagnostics");
    EXPECT_EQ(findings[0].subject, "lidar: motor");
    EXPECT_EQ(findings[0].message, "hot");
    EXPECT_EQ(findings[0].stamp, Time(seconds(9)));
  }
}

TEST_F(DiagnosticsMonitorTest, OurOwnAreNotReadBack) {
  monitor_.OnStatus("coppice: node /navigation", 2, "dead", Time(seconds(1)));
  EXPECT_TRUE(At(Time(seconds(1))).empty());
}

TEST_F(DiagnosticsMonitorTest, SilenceIsStaleUntilItIsHeardAgain) {
  monitor_.OnStatus("lidar", 0, "", Time(seconds(1)));
  EXPECT_EQ(At(Time(seconds(6))).at(0).level, HealthLevel::kOk);
  EXPECT_EQ(At(Time(seconds(7))).at(0).level, HealthLevel::kStale);
  EXPECT_EQ(At(Time(seconds(7))).at(0).message, "not repeated for 6 s");
  EXPECT_EQ(At(Time(seconds(7000))).at(0).level, HealthLevel::kStale);
  monitor_.OnStatus("lidar", 0, "", Time(seconds(7001)));
  EXPECT_EQ(At(Time(seconds(7001))).at(0).level, HealthLevel::kOk);
}

TEST_F(DiagnosticsMonitorTest, AnotherConfigurationForgetsWhoIsSilent) {
  monitor_.OnStatus("gone", 0, "", Time(seconds(1)));
  monitor_.OnStatus("here", 0, "", Time(seconds(9)));
  monitor_.Watch(DiagnosticsWatch{seconds(5)}, Time(seconds(10)));
  ASSERT_EQ(At(Time(seconds(10))).size(), 1u);
  EXPECT_EQ(At(Time(seconds(10)))[0].subject, "here");
  monitor_.Watch(std::nullopt, Time(seconds(11)));
  monitor_.OnStatus("here", 0, "", Time(seconds(11)));
  EXPECT_TRUE(At(Time(seconds(11))).empty());
}

TEST_F(DiagnosticsMonitorTest, WhoIsNotHeardAnyMoreInAnotherConfigurationIsNotMissed) {
  monitor_.OnStatus("mapping", 0, "", Time(seconds(9)));
  monitor_.OnStatus("lidar", 0, "", Time(seconds(9)));
  monitor_.Watch(DiagnosticsWatch{seconds(5)}, Time(seconds(10)));
  monitor_.OnStatus("lidar", 0, "", Time(seconds(11)));
  EXPECT_EQ(At(Time(seconds(14))).size(), 2u);
  const auto findings = At(Time(seconds(20)));
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].subject, "lidar");
  EXPECT_EQ(findings[0].level, HealthLevel::kStale);
}

TEST_F(DiagnosticsMonitorTest, AProgramThatInventsNamesIsBounded) {
  for (int i = 0; i < 5000; ++i) monitor_.OnStatus(std::to_string(i), 0, "", Time(seconds(1)));
  ASSERT_EQ(At(Time(seconds(1))).size(), 2001u);
  EXPECT_EQ(At(Time(seconds(1))).back().level, HealthLevel::kWarn);
  EXPECT_EQ(At(Time(seconds(1))).back().message,
            "more than 2000 names: not all that is said is heard");
  EXPECT_EQ(At(Time(seconds(100))).size(), 2000u);
}

TEST_F(DiagnosticsMonitorTest, WithNamesThatAreInventedNobodyHidesAFaultForEver) {
  for (int i = 0; i < 3000; ++i) monitor_.OnStatus(std::to_string(i), 0, "", Time(seconds(1)));
  monitor_.OnStatus("lidar", 2, "broken", Time(seconds(10)));
  const auto findings = At(Time(seconds(10)));
  EXPECT_EQ(std::count_if(findings.begin(), findings.end(),
                          [](const Finding& one) {
                            return one.subject == "lidar" && one.level == HealthLevel::kError;
                          }),
            1);
}

TEST_F(DiagnosticsMonitorTest, AProgramThatSaysMegabytesIsNotToldOn) {
  monitor_.OnStatus(std::string(1 << 20, 'n'), 2, std::string(1 << 20, 'm'), Time(seconds(1)));
  const auto findings = At(Time(seconds(1)));
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_LE(findings[0].subject.size(), 203u);
  EXPECT_LE(findings[0].message.size(), 1003u);
}

}  // namespace
}  // namespace coppice::robot::monitoring
