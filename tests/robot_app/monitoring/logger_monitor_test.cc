#include "robot_app/monitoring/logger_monitor.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/robot_app/processes/temporary.h"

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::seconds;

class LoggerMonitorTest : public testing::Test {
 protected:
  LoggerMonitorTest() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ + "/records/today");
    LoggerWatch file{"record", "run.log", "", "/robot", seconds(60)};
    LoggerWatch folder{"database", "records", "", "", seconds(60)};
    LoggerWatch topic{"rosbag", "", "/recorder/status", "/recorder", seconds(60)};
    monitor_.Watch({file, folder, topic});
  }
  void Append(const std::string& file) { std::ofstream(folder_ + file, std::ios::app) << "line\n"; }
  std::vector<Finding> At(Time now) { return monitor_.Report(processes_, {Time(seconds(9)), now}); }

  const std::string folder_ = processes::Temporary("logger_monitor_test");
  LoggerMonitor monitor_{folder_};
  ProcessTable processes_;
};

TEST_F(LoggerMonitorTest, AFileOrFolderThatGrowsAndATopicThatReportsAreWell) {
  Append("/run.log");
  Append("/records/today/1.log");
  At(Time(seconds(1)));
  for (int minute = 1; minute < 10; ++minute) {
    const Time now{seconds(1) + seconds(59) * minute};
    Append("/run.log");
    Append(minute % 2 ? "/records/today/1.log" : "/records/2.log");
    monitor_.OnMessage("/recorder/status", now);
    for (const Finding& finding : At(now)) {
      EXPECT_EQ(finding.level, HealthLevel::kOk) << finding.subject << finding.message;
      EXPECT_EQ(finding.monitor, "logger");
      EXPECT_EQ(finding.value, 0);
    }
  }
}

TEST_F(LoggerMonitorTest, ALoggerThatIsDownIsAnError) {
  Append("/run.log");
  At(Time(seconds(1)));
  EXPECT_EQ(At(Time(seconds(61))).at(0).level, HealthLevel::kOk);
  const auto findings = At(Time(seconds(62)));
  ASSERT_EQ(findings.size(), 3u);
  EXPECT_EQ(findings[0].level, HealthLevel::kError);
  EXPECT_EQ(findings[0].message, "nothing written for 61 s");
  EXPECT_EQ(findings[0].node, "/robot");
  EXPECT_EQ(findings[1].message, "nothing written for 61 s");
  EXPECT_EQ(findings[2].message, "no report for 61 s");
  EXPECT_EQ(findings[2].node, "/recorder");
  Append("/run.log");
  EXPECT_EQ(At(Time(seconds(63))).at(0).level, HealthLevel::kOk);
}

TEST_F(LoggerMonitorTest, OneOfTheFilesOfAPatternMustGrow) {
  monitor_.Watch({{"runs", "run*.log", "", "", seconds(60)}});
  EXPECT_EQ(At(Time(seconds(1))).at(0).level, HealthLevel::kOk);
  EXPECT_EQ(At(Time(seconds(62))).at(0).message, "run*.log is missing");
  Append("/run.log");
  EXPECT_EQ(At(Time(seconds(63))).at(0).level, HealthLevel::kOk);
  Append("/run.2.log");  // of the program that was restarted
  EXPECT_EQ(At(Time(seconds(124))).at(0).level, HealthLevel::kOk);
  EXPECT_EQ(At(Time(seconds(184))).at(0).level, HealthLevel::kOk);
  EXPECT_EQ(At(Time(seconds(185))).at(0).message, "nothing written for 61 s");
}

TEST_F(LoggerMonitorTest, AFileThatIsGoneIsNamed) {
  At(Time(seconds(1)));
  EXPECT_EQ(At(Time(seconds(62))).at(0).message, "run.log is missing");
}

TEST_F(LoggerMonitorTest, ALoggerThatStartsHasItsTime) {
  At(Time(seconds(1)));
  processes_.by_node["/robot"].phase = ProcessPhase::kStarting;
  EXPECT_EQ(At(Time(seconds(100))).at(0).level, HealthLevel::kOk);
  processes_.by_node["/robot"].phase = ProcessPhase::kReady;
  EXPECT_EQ(At(Time(seconds(160))).at(0).level, HealthLevel::kOk);
  EXPECT_EQ(At(Time(seconds(161))).at(0).level, HealthLevel::kError);
}

TEST_F(LoggerMonitorTest, AChangeOfTheListKeepsWhatWasSeen) {
  At(Time(seconds(1)));
  monitor_.Watch({{"rosbag", "", "/recorder/status", "/recorder", seconds(30)}});
  EXPECT_EQ(At(Time(seconds(32))).at(0).level, HealthLevel::kError);
}

TEST_F(LoggerMonitorTest, AnEmptyFolderHasAFootprintAndNothingHasNone) {
  EXPECT_TRUE(ReadFootprint(folder_ + "/records").has_value());
  EXPECT_FALSE(ReadFootprint(folder_ + "/nothing").has_value());
  const auto before = ReadFootprint(folder_);
  Append("/records/3.log");
  EXPECT_FALSE(ReadFootprint(folder_) == before);
}

}  // namespace
}  // namespace coppice::robot::monitoring
