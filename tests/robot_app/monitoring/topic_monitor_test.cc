#include "robot_app/monitoring/topic_monitor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::milliseconds;
using std::chrono::seconds;

// Within [8, 12] Hz well, outside [5, 15] Hz an error; window 2 s, staleness 1 s.
TopicWatch Scan() {
  TopicWatch watch;
  watch.topic = "/scan";
  watch.node = "/scanner";
  watch.band = {{8, 12}, {5, 15}, 1, seconds(1), 0};
  watch.window = seconds(2);
  return watch;
}

// `count` messages, evenly over the window of 2 s that ends at the returned assessment.
Finding AtCount(int count) {
  RateWatch watch(Scan());
  const Time begin = Time(seconds(100));
  const Duration window = seconds(2);
  watch.Assess(begin);
  for (int i = 1; i <= count; ++i) watch.OnMessage(begin + window * i / count);
  return watch.Assess(begin + window);
}

TEST(RateWatch, JudgesBothSidesOfTheBandWithExactEdges) {
  EXPECT_EQ(AtCount(9).level, HealthLevel::kError);  // 4.5 Hz
  EXPECT_EQ(AtCount(10).level, HealthLevel::kWarn);  // 5 Hz: on the edge of error
  EXPECT_EQ(AtCount(15).level, HealthLevel::kWarn);  // 7.5 Hz
  EXPECT_EQ(AtCount(16).level, HealthLevel::kOk);    // 8 Hz: on the edge of warn
  EXPECT_EQ(AtCount(20).level, HealthLevel::kOk);
  EXPECT_EQ(AtCount(24).level, HealthLevel::kOk);     // 12 Hz: on the edge of warn
  EXPECT_EQ(AtCount(25).level, HealthLevel::kWarn);   // 12.5 Hz
  EXPECT_EQ(AtCount(30).level, HealthLevel::kWarn);   // 15 Hz: on the edge of error
  EXPECT_EQ(AtCount(31).level, HealthLevel::kError);  // 15.5 Hz
}

TEST(RateWatch, SaysWhatItMeasuredAndWhatItExpected) {
  const Finding finding = AtCount(9);
  EXPECT_EQ(finding.monitor, "topic");
  EXPECT_EQ(finding.subject, "/scan");
  EXPECT_EQ(finding.node, "/scanner");
  EXPECT_EQ(finding.value, 4.5);
  EXPECT_EQ(finding.unit, "Hz");
  EXPECT_EQ(finding.message, "4.5 Hz, expected 5 to 15 Hz");
}

TEST(RateWatch, DoesNotJudgeTheRateBeforeTheWindowIsFull) {
  RateWatch watch(Scan());
  watch.Assess(Time(seconds(100)));
  watch.OnMessage(Time(seconds(101)));
  EXPECT_EQ(watch.Assess(Time(seconds(102) - Duration(1))).level, HealthLevel::kOk);
  EXPECT_EQ(watch.Assess(Time(seconds(102))).level, HealthLevel::kError);
}

TEST(RateWatch, SilenceIsAnErrorBeforeTheFirstWindowIsFull) {
  RateWatch watch(Scan());
  watch.Assess(Time(seconds(100)));
  EXPECT_EQ(watch.Assess(Time(seconds(101))).level, HealthLevel::kOk);  // exactly the limit
  const Finding finding = watch.Assess(Time(seconds(101) + milliseconds(500)));
  EXPECT_EQ(finding.level, HealthLevel::kError);
  EXPECT_EQ(finding.message, "no message for 1.5 s");
}

TEST(RateWatch, ALongSilenceStaysOne) {
  RateWatch watch(Scan());
  watch.Assess(Time(seconds(100)));
  watch.OnMessage(Time(seconds(100)));
  const Finding finding = watch.Assess(Time(seconds(500)));
  EXPECT_EQ(finding.message, "no message for 400 s");
  EXPECT_EQ(finding.value, 0);
}

TEST(RateWatch, WithoutABandOnlySilenceCounts) {
  TopicWatch only_staleness = Scan();
  only_staleness.band.warn = only_staleness.band.error = {};
  RateWatch watch(only_staleness);
  watch.Assess(Time(seconds(100)));
  watch.OnMessage(Time(seconds(102)));
  EXPECT_EQ(watch.Assess(Time(seconds(102))).level, HealthLevel::kOk);
}

TEST(RateWatch, ABadRateMustBeSeenSoManyTimesInARow) {
  TopicWatch twice = Scan();
  twice.band.consecutive = 2;
  twice.band.staleness = Duration::zero();
  RateWatch watch(twice);
  watch.Assess(Time(seconds(100)));
  EXPECT_EQ(watch.Assess(Time(seconds(102))).level, HealthLevel::kWarn);
  EXPECT_EQ(watch.Assess(Time(seconds(103))).level, HealthLevel::kError);
}

TEST(RateWatch, TimeThatJumpsBackStartsAnew) {
  RateWatch watch(Scan());
  watch.Assess(Time(seconds(100)));
  watch.OnMessage(Time(seconds(101)));
  EXPECT_EQ(watch.Assess(Time(seconds(50))).message, "measuring");
  EXPECT_EQ(watch.Assess(Time(seconds(51) + milliseconds(1))).level, HealthLevel::kError);
}

class TopicMonitorTest : public testing::Test {
 protected:
  TopicMonitorTest() { monitor_.Watch({Scan()}); }
  Finding Report(Time ros, Time wall = Time{}) {
    return monitor_.Report(processes_, {ros, wall}).at(0);
  }
  TopicMonitor monitor_;
  ProcessTable processes_;
};

TEST_F(TopicMonitorTest, CountsInRosTimeHoweverFastItRuns) {
  Report(Time(seconds(100)));
  for (int i = 1; i <= 20; ++i) {
    monitor_.OnMessage("/scan",
                       {Time(seconds(100) + milliseconds(100) * i), Time(milliseconds(i))});
  }
  EXPECT_EQ(Report(Time(seconds(102)), Time(milliseconds(20))).value, 10);
}

TEST_F(TopicMonitorTest, CountsInWallTimeIfToldSo) {
  TopicWatch clock = Scan();
  clock.wall_time = true;
  monitor_.Watch({clock});
  Report(Time(seconds(100)), Time(seconds(7)));
  const Finding finding = Report(Time(seconds(100)), Time(seconds(9)));  // ROS time stands still
  EXPECT_EQ(finding.level, HealthLevel::kError);
  EXPECT_EQ(finding.stamp, Time(seconds(100)));
}

TEST_F(TopicMonitorTest, ATopicWatchedByStatisticsNeedsNoMessages) {
  TopicWatch camera = Scan();
  camera.by_statistics = true;
  monitor_.Watch({camera});
  Report(Time(seconds(100)));
  monitor_.OnStatistics({"/scan", "/scanner", "/reader", 10}, {Time(seconds(101)), Time{}});
  monitor_.OnStatistics({"/other", "/scanner", "/reader", 99}, {Time(seconds(101)), Time{}});
  EXPECT_EQ(Report(Time(seconds(102))).value, 10);
  EXPECT_EQ(Report(Time(seconds(103))).level, HealthLevel::kError);
}

TEST_F(TopicMonitorTest, APublisherThatStartsHasItsTime) {
  Report(Time(seconds(100)));
  processes_.by_node["/scanner"].phase = ProcessPhase::kStarting;
  EXPECT_EQ(Report(Time(seconds(110))).message, "starting");
  processes_.by_node["/scanner"].phase = ProcessPhase::kReady;
  EXPECT_EQ(Report(Time(seconds(111))).level, HealthLevel::kOk);  // counts from the last "starting"
  EXPECT_EQ(Report(Time(seconds(111) + milliseconds(1))).level, HealthLevel::kError);
}

TEST_F(TopicMonitorTest, APublisherThatWasRestartedBetweenTwoReportsIsJudgedAnew) {
  processes_.by_node["/scanner"].phase = ProcessPhase::kReady;
  processes_.by_node["/scanner"].pid = 7;
  EXPECT_EQ(Report(Time(seconds(100))).level, HealthLevel::kOk);
  EXPECT_EQ(Report(Time(seconds(110))).level, HealthLevel::kError);
  processes_.by_node["/scanner"].pid = 8;
  EXPECT_EQ(Report(Time(seconds(110))).level, HealthLevel::kOk);
  EXPECT_EQ(Report(Time(seconds(115))).level, HealthLevel::kError);
}

TEST_F(TopicMonitorTest, AnErrorMustLastInWallTimeToo) {
  TopicMonitor patient(milliseconds(400));
  patient.Watch({Scan()});
  const auto level = [&](Time ros, Time wall) {
    return patient.Report(processes_, {ros, wall}).at(0).level;
  };
  EXPECT_EQ(level(Time(seconds(100)), Time(seconds(1))), HealthLevel::kOk);
  EXPECT_EQ(level(Time(seconds(102)), Time(seconds(2))), HealthLevel::kWarn);
  EXPECT_EQ(level(Time(seconds(103)), Time(seconds(2) + milliseconds(399))), HealthLevel::kWarn);
  EXPECT_EQ(level(Time(seconds(104)), Time(seconds(2) + milliseconds(400))), HealthLevel::kError);
  patient.OnMessage("/scan", {Time(seconds(105)), Time(seconds(3))});
  EXPECT_EQ(level(Time(seconds(105)), Time(seconds(3))),
            HealthLevel::kError);  // 0.5 Hz: still an error
  for (int i = 0; i < 20; ++i) patient.OnMessage("/scan", {Time(seconds(105)), Time(seconds(3))});
  EXPECT_EQ(level(Time(seconds(105)), Time(seconds(3))), HealthLevel::kOk);
  EXPECT_EQ(level(Time(seconds(107)), Time(seconds(4))),
            HealthLevel::kWarn);  // patience begins anew
}

TEST_F(TopicMonitorTest, AChangeOfTheListKeepsWhatWasSeen) {
  Report(Time(seconds(100)));
  for (int i = 1; i <= 20; ++i) {
    monitor_.OnMessage("/scan", {Time(seconds(100) + milliseconds(100) * i), Time{}});
  }
  TopicWatch other = Scan();
  other.topic = "/other";
  monitor_.Watch({Scan(), other});
  monitor_.OnMessage("/unwatched", {Time(seconds(102)), Time{}});
  EXPECT_EQ(Report(Time(seconds(102))).value, 10);
}

// The newest finding about scans that have come for two seconds, each so old [s].
Finding AfterScans(float range, double age = 0) {
  TopicWatch watch = Scan();
  watch.content = Content::kLaserScan;
  TopicMonitor monitor;
  monitor.Watch({watch});
  LaserScan scan;
  scan.ranges.assign(541, range);
  Finding finding;
  for (int i = 0; i <= 20; ++i) {
    const Time now{seconds(100) + milliseconds(100) * i};
    scan.stamp = 100 + 0.1 * i - age;
    monitor.OnScan("/scan", scan, {now, now});
    finding = monitor.Report({}, {now, now}).at(0);
  }
  return finding;
}

TEST(TopicMonitor, ScansThatSeeAreWell) { EXPECT_EQ(AfterScans(3).level, HealthLevel::kOk); }

TEST(TopicMonitor, ScansInWhichNoBeamTellsAnythingAreNone) {
  const Finding finding = AfterScans(NAN);
  EXPECT_EQ(finding.level, HealthLevel::kError);
  EXPECT_EQ(finding.monitor, "topic");
  EXPECT_EQ(finding.node, "/scanner");
  EXPECT_EQ(finding.message, "no usable message for 2 s: 0 of 541 beams tell something");
}

// By a clock that stands elsewhere: navigation does not move by them.
TEST(TopicMonitor, ScansOfAnotherTimeAreNone) {
  const Finding old = AfterScans(3, 30);
  EXPECT_EQ(old.level, HealthLevel::kError);
  EXPECT_EQ(old.message, "no usable message for 2 s: its stamp is 30 s old");
  EXPECT_EQ(AfterScans(3, -20).message, "no usable message for 2 s: its stamp is 20 s ahead");
  EXPECT_EQ(AfterScans(3, 2).level, HealthLevel::kOk);
}

TEST(TopicMonitor, ASonarOfAnotherTimeIsNone) {
  TopicWatch watch = Scan();
  watch.content = Content::kRange;
  TopicMonitor monitor;
  monitor.Watch({watch});
  for (const int second : {100, 102}) {
    const Times now{Time(seconds(second)), Time(seconds(second))};
    monitor.OnRange("/scan", 1, 0, now);
    monitor.Report({}, now);
  }
  const Times now{Time(seconds(102)), Time(seconds(102))};
  EXPECT_EQ(monitor.Report({}, now).at(0).message,
            "no usable message for 2 s: its stamp is 102 s old");
}

TEST(TopicMonitor, OneBlindScanIsForgivenAndSaid) {
  TopicWatch watch = Scan();
  watch.content = Content::kLaserScan;
  TopicMonitor monitor;
  monitor.Watch({watch});
  const Times now{Time(seconds(100)), Time(seconds(100))};
  monitor.OnScan("/scan", LaserScan(), now);
  const Finding finding = monitor.Report({}, now).at(0);
  EXPECT_EQ(finding.level, HealthLevel::kOk);
  EXPECT_EQ(finding.message, "measuring: 0 of 0 beams tell something");
}

TEST(TopicMonitor, ASonarThatTellsNoDistanceIsNone) {
  TopicWatch watch = Scan();
  watch.content = Content::kRange;
  TopicMonitor monitor;
  monitor.Watch({watch});
  Finding finding;
  for (int i = 0; i <= 20; ++i) {
    const Time now{seconds(100) + milliseconds(100) * i};
    monitor.OnRange("/scan", NAN, 100, {now, now});
    finding = monitor.Report({}, {now, now}).at(0);
  }
  EXPECT_EQ(finding.level, HealthLevel::kError);
  EXPECT_EQ(finding.message, "no usable message for 2 s: it tells no distance");
}

TEST(TopicMonitor, WhatIsOptionalIsNoFaultWhileItIsSwitchedOffAndIsGivenTimeAfterwards) {
  TopicWatch watch = Scan();
  watch.is_optional = true;
  TopicMonitor monitor;
  monitor.Watch({watch});
  ProcessTable off;
  off.by_node["/scanner"] = {};
  const auto at = [](int second) {
    const Time now{seconds(second)};
    return Times{now, now};
  };
  monitor.Report(off, at(100));
  const Finding finding = monitor.Report(off, at(200)).at(0);
  EXPECT_EQ(finding.level, HealthLevel::kOk);
  EXPECT_EQ(finding.message, "switched off");
  EXPECT_EQ(monitor.Report({}, at(201)).at(0).level, HealthLevel::kOk);
  EXPECT_EQ(monitor.Report({}, at(210)).at(0).level, HealthLevel::kError);
}

TEST(TopicMonitor, AScanTopicIsNotCountedUnread) {
  TopicWatch watch = Scan();
  watch.content = Content::kLaserScan;
  TopicMonitor monitor;
  monitor.Watch({watch});
  for (int i = 0; i < 20; ++i) {
    const Time now{seconds(100) + milliseconds(100) * i};
    monitor.OnMessage("/scan", {now, now});
    monitor.Report({}, {now, now});
  }
  const Times now{Time(seconds(102)), Time(seconds(102))};
  EXPECT_EQ(monitor.Report({}, now).at(0).message, "no message for 2 s");
}

}  // namespace
}  // namespace coppice::robot::monitoring
