#include "robot_app/monitoring/gauges/statistics_watch.h"

#include <gtest/gtest.h>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::seconds;

TopicWatch Camera() {
  TopicWatch watch;
  watch.topic = "/camera";
  watch.node = "/driver";
  watch.band = {{25, 35}, {10, 60}, 1, seconds(5), 0};
  return watch;
}

class StatisticsWatchTest : public testing::Test {
 protected:
  void Tell(const std::string& publisher, const std::string& subscriber, double rate, Time now) {
    watch_.OnStatistics({"/camera", publisher, subscriber, rate}, now);
  }
  StatisticsWatch watch_{Camera()};
};

TEST_F(StatisticsWatchTest, JudgesTheReportedRate) {
  EXPECT_EQ(watch_.Assess(Time(seconds(1))).message, "measuring");
  Tell("/driver", "/viewer", 30, Time(seconds(2)));
  EXPECT_EQ(watch_.Assess(Time(seconds(2))).level, HealthLevel::kOk);
  Tell("/driver", "/viewer", 20, Time(seconds(3)));
  EXPECT_EQ(watch_.Assess(Time(seconds(3))).level, HealthLevel::kWarn);
  Tell("/driver", "/viewer", 90, Time(seconds(4)));
  const Finding finding = watch_.Assess(Time(seconds(4)));
  EXPECT_EQ(finding.level, HealthLevel::kError);
  EXPECT_EQ(finding.message, "90 Hz, expected 10 to 60 Hz");
  EXPECT_EQ(finding.monitor, "topic");
  EXPECT_EQ(finding.node, "/driver");
}

TEST_F(StatisticsWatchTest, TheFastestSubscriberCountsWithAllItsPublishers) {
  Tell("/left", "/recorder", 15, Time(seconds(1)));
  Tell("/right", "/recorder", 15, Time(seconds(1)));
  Tell("/left", "/slow_viewer", 2, Time(seconds(1)));
  EXPECT_EQ(watch_.Assess(Time(seconds(1))).value, 30);
}

TEST_F(StatisticsWatchTest, ATopicThatNobodyReportsIsAnErrorAfterTheStaleness) {
  watch_.Assess(Time(seconds(1)));
  EXPECT_EQ(watch_.Assess(Time(seconds(6))).level, HealthLevel::kOk);
  EXPECT_EQ(watch_.Assess(Time(seconds(7))).level, HealthLevel::kError);
  Tell("/driver", "/viewer", 30, Time(seconds(8)));
  EXPECT_EQ(watch_.Assess(Time(seconds(8))).level, HealthLevel::kOk);
  const Finding finding = watch_.Assess(Time(seconds(14)));
  EXPECT_EQ(finding.level, HealthLevel::kError);
  EXPECT_EQ(finding.value, 0);
  EXPECT_EQ(finding.message, "no subscriber reports it on /statistics");
  EXPECT_EQ(watch_.Assess(Time(seconds(15))).level, HealthLevel::kError);
}

TEST_F(StatisticsWatchTest, ASubscriberThatLeftNoLongerCounts) {
  Tell("/driver", "/gone", 90, Time(seconds(1)));
  Tell("/driver", "/viewer", 30, Time(seconds(6)));
  EXPECT_EQ(watch_.Assess(Time(seconds(7))).value, 30);
}

TEST_F(StatisticsWatchTest, ContinuesAndForgets) {
  Tell("/driver", "/viewer", 30, Time(seconds(1)));
  watch_.Assess(Time(seconds(1)));
  StatisticsWatch next(Camera());
  next.Continue(watch_);
  EXPECT_EQ(next.Assess(Time(seconds(2))).value, 30);
  next.Reset();
  EXPECT_EQ(next.Assess(Time(seconds(100))).message, "measuring");
  EXPECT_EQ(watch_.Assess(Time(seconds(0))).message, "measuring");  // time jumped back
}

}  // namespace
}  // namespace coppice::robot::monitoring
