#include "robot_app/monitoring/gauges/gauge_board.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::seconds;

GaugeWatch AtMost(const std::string& subject, double bound) {
  GaugeWatch watch{"memory", subject, "/hog", "%", {}};
  watch.band.error.high = bound;
  return watch;
}

TEST(GaugeBoard, JudgesEachNumberByItsBand) {
  GaugeBoard board;
  board.Watch({AtMost("used", 90), AtMost("swap", 10)});
  board.OnValue("memory", "used", 20, Time(seconds(1)));
  board.OnValue("memory", "swap", 20, Time(seconds(1)));
  const auto findings = board.Report(Time(seconds(1)), Time(seconds(7)));
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].subject, "used");
  EXPECT_EQ(findings[0].level, HealthLevel::kOk);
  EXPECT_EQ(findings[0].value, 20);
  EXPECT_EQ(findings[1].level, HealthLevel::kError);
  EXPECT_EQ(findings[1].message, "20 %, expected at most 10 %");
  EXPECT_EQ(findings[1].node, "/hog");
  EXPECT_EQ(findings[1].stamp, Time(seconds(7)));
}

TEST(GaugeBoard, ANumberWithoutValueIsNotANumber) {
  GaugeBoard board;
  board.Watch({AtMost("used", 90)});
  const Finding finding = board.Report(Time(seconds(1)), Time{}).at(0);
  EXPECT_TRUE(std::isnan(finding.value));
  EXPECT_EQ(finding.level, HealthLevel::kOk);
}

TEST(GaugeBoard, AFailureAndAnUnknownNumberHarmNoOther) {
  GaugeBoard board;
  board.Watch({AtMost("used", 90), AtMost("swap", 10)});
  board.OnValue("cpu", "used", 99, Time(seconds(1)));
  board.OnFailure("memory", "nothing", "lost", Time(seconds(1)));
  board.OnFailure("memory", "swap", "cannot read", Time(seconds(1)));
  const auto findings = board.Report(Time(seconds(1)), Time{});
  EXPECT_EQ(findings[0].level, HealthLevel::kOk);
  EXPECT_EQ(findings[1].level, HealthLevel::kError);
  EXPECT_EQ(findings[1].message, "cannot read");
}

TEST(GaugeBoard, ANewListKeepsWhatIsKnownOfTheSameBand) {
  GaugeBoard board;
  board.Watch({AtMost("used", 90), AtMost("swap", 10)});
  board.OnValue("memory", "used", 20, Time(seconds(1)));
  board.OnValue("memory", "swap", 5, Time(seconds(1)));
  board.Watch({AtMost("swap", 20), AtMost("used", 90)});
  const auto findings = board.Report(Time(seconds(1)), Time{});
  EXPECT_TRUE(std::isnan(findings.at(0).value));
  EXPECT_EQ(findings.at(1).value, 20);
  board.Reset();
  EXPECT_TRUE(std::isnan(board.Report(Time(seconds(1)), Time{}).at(1).value));
}

}  // namespace
}  // namespace coppice::robot::monitoring
