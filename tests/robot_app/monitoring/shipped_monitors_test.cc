// The shipped monitors.yaml: every number of the paper's table I (Stuede et al., ECMR 2021) leaves
// its band once and is an error.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "robot_app/monitoring/localization_monitor.h"
#include "robot_app/monitoring/monitor_config.h"
#include "robot_app/monitoring/navigation_monitor.h"
#include "robot_app/monitoring/node_monitor.h"
#include "robot_app/monitoring/power/battery_monitor.h"
#include "robot_app/monitoring/publisher_monitor.h"
#include "robot_app/monitoring/system/system_gauges.h"
#include "robot_app/monitoring/system/system_monitor.h"
#include "robot_app/monitoring/topic_monitor.h"
#include "robot_app/navigation/navigation.h"
#include "tests/robot_app/monitoring/system/proc_root.h"
#include "tests/robot_app/navigation/test_floor.h"
#include "tests/support/folders.h"

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::duration_cast;
using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::IsEmpty;

Duration Lasting(double seconds) {
  return duration_cast<Duration>(std::chrono::duration<double>(seconds));
}
Time At(double second) { return Time(Lasting(second)); }

std::vector<std::string> SubjectsAt(HealthLevel level, const std::vector<Finding>& findings) {
  std::vector<std::string> subjects;
  for (const Finding& finding : findings) {
    if (finding.level == level) subjects.push_back(finding.monitor + " " + finding.subject);
  }
  return subjects;
}

class ShippedMonitorsTest : public testing::Test {
 protected:
  ShippedMonitorsTest() {
    config_ = LoadMonitorConfig(SourceFolder() + "/robot_app/config/monitors.yaml", diagnostics_);
    EXPECT_EQ(diagnostics_.ToString(), "");
  }
  const WatchList& Operating() const { return config_.ForConfiguration("operating"); }

  Diagnostics diagnostics_;
  MonitorConfig config_;
  ProcessTable processes_;
};

// What a computer does in one second.
struct Second {
  int busy = 10;              // of 100
  int available = 60;         // of 100
  long sent = 1000;           // bytes
  int errors = 0, drops = 0;  // packets
  Expected<ClockReading> clock{ClockReading{}};
  ReachDelay host{0.001};
};

// A computer with a link of any name, beside one other.
class ShippedComputerTest : public ShippedMonitorsTest {
 protected:
  ShippedComputerTest() { monitor_.Watch(config_.ForHost("any name")); }

  void Run(int count, const Second& second) {
    for (int i = 0; i < count; ++i) {
      busy_ += second.busy;
      idle_ += 100 - second.busy;
      sent_ += second.sent;
      errors_ += second.errors;
      drops_ += second.drops;
      root_.WriteCpu(busy_, idle_);
      root_.WriteMemory(100, second.available);
      root_.WriteInterface("wlp3s0", 0, sent_, errors_, drops_);
      now_ += seconds(1);
      monitor_.OnSample(LookAtSystem(root_.path(), monitor_.Question({}), now_));
      monitor_.OnClocks({second.clock}, now_);
      monitor_.OnHosts({second.host}, now_);
    }
  }
  // Without disks, which are this computer's own.
  std::vector<Finding> Report() {
    std::vector<Finding> findings;
    for (const Finding& finding : monitor_.Report({}, {now_, now_})) {
      if (finding.monitor != "disk") findings.push_back(finding);
    }
    return findings;
  }

  ProcRoot root_{"shipped_monitors_test"};
  SystemMonitor monitor_;
  Time now_{seconds(100)};
  int busy_ = 1000, idle_ = 1000, errors_ = 0, drops_ = 0;
  long sent_ = 0;
};

TEST_F(ShippedComputerTest, ProcessorMemoryNetworkAndClockAreErrorsOutsideTheirBands) {
  monitor_.OnComputers({{"jetson", "10.0.0.3"}});
  root_.Write("/sys/class/thermal/thermal_zone0/temp", "40000");
  Run(10, {});
  EXPECT_THAT(SubjectsAt(HealthLevel::kError, Report()), IsEmpty());

  Second overloaded;
  overloaded.busy = 100;
  overloaded.available = 1;
  overloaded.sent = 125 * 1000 * 1000;  // a gigabit
  overloaded.errors = 200;
  overloaded.drops = 2000;
  overloaded.clock = ClockReading{3, 0};
  overloaded.host = Problem{"no answer"};
  root_.Write("/sys/class/thermal/thermal_zone0/temp", "99000");
  Run(130, overloaded);
  EXPECT_THAT(SubjectsAt(HealthLevel::kError, Report()),
              ElementsAre("cpu load", "cpu temperature", "memory used", "network wlp3s0 load",
                          "network wlp3s0 errors", "network wlp3s0 drops", "clock jetson",
                          "network host jetson"));
}

TEST_F(ShippedComputerTest, ALoadThatDoesNotLastIsOnlyAWarning) {
  Second busy;
  busy.busy = 100;
  Run(100, busy);
  EXPECT_THAT(SubjectsAt(HealthLevel::kError, Report()), IsEmpty());
  EXPECT_THAT(SubjectsAt(HealthLevel::kWarn, Report()), ElementsAre("cpu load"));
}

TEST_F(ShippedComputerTest, AComputerOnItsOwnWithoutSensorsIsWell) {
  Run(300, {});
  for (const Finding& finding : Report()) {
    EXPECT_EQ(finding.level, HealthLevel::kOk) << finding.monitor << " " << finding.subject;
  }
}

TEST_F(ShippedComputerTest, AnotherComputerWithoutTimeServerIsNotBlamedForIt) {
  monitor_.OnComputers({{"jetson", "10.0.0.3"}});
  Second second;
  second.clock = Problem{"no answer"};
  Run(10, second);
  EXPECT_THAT(SubjectsAt(HealthLevel::kError, Report()), IsEmpty());
  Run(1, {});
  Run(10, second);
  EXPECT_THAT(SubjectsAt(HealthLevel::kError, Report()), ElementsAre("clock jetson"))
      << "but for losing it";
}

TEST_F(ShippedComputerTest, EveryNumberOfAComputerHasAWarningBeforeTheError) {
  const SystemWatch watch =
      WithNames(*config_.ForHost("any name"), {"eth0"}, {{"jetson", "10.0.0.3"}});
  for (const GaugeWatch& gauge : GaugesOf(watch)) {
    if (gauge.monitor == "process") continue;  // not of the table
    EXPECT_TRUE(gauge.band.warn.high && gauge.band.error.high) << gauge.subject;
    EXPECT_LT(gauge.band.warn.high, gauge.band.error.high) << gauge.subject;
  }
}

TEST_F(ShippedMonitorsTest, ANodeThatMissesItsPingsIsAnError) {
  for (const WatchList& list : config_.lists) {
    ASSERT_FALSE(list.nodes.empty()) << list.configuration;
    NodeMonitor monitor;
    monitor.Watch(list.nodes);
    for (const NodeWatch& node : list.nodes) {
      for (int i = 0; i < node.misses; ++i) monitor.Observe(node.node, {});
    }
    for (const Finding& finding : monitor.Report(processes_, {})) {
      EXPECT_EQ(finding.level, HealthLevel::kError) << list.configuration << finding.subject;
    }
  }
}

class ShippedTopicsTest : public ShippedMonitorsTest {
 protected:
  // What is found about a topic whose publisher does `rate` for a minute; scans and sonars measure
  // `range`.
  Finding After(const TopicWatch& watch, double rate, float range = 1) const {
    TopicMonitor monitor;
    monitor.Watch({watch});
    LaserScan scan;
    scan.ranges = {range};
    std::vector<Finding> findings;
    double next = 0;
    for (double now = 0; now < 60; now += 0.005) {
      if (rate > 0 && now >= next) {
        monitor.OnMessage(watch.topic, {At(now), At(now)});
        scan.stamp = InSeconds(At(now).time_since_epoch());
        monitor.OnScan(watch.topic, scan, {At(now), At(now)});
        monitor.OnRange(watch.topic, range, scan.stamp, {At(now), At(now)});
        next += 1 / rate;
      }
      const bool is_due = static_cast<int>(now * 200) % 100 == 0;
      if (is_due) findings = monitor.Report(processes_, {At(now), At(now)});
    }
    return findings.at(0);
  }
};

TEST_F(ShippedTopicsTest, ATopicThatIsSilentOrTooSlowOrTooFastIsAnError) {
  ASSERT_FALSE(Operating().topics.empty());
  for (const TopicWatch& watch : Operating().topics) {
    EXPECT_EQ(After(watch, 0).level, HealthLevel::kError) << watch.topic;
    const Range& error = watch.band.error;
    if (error.low) {
      EXPECT_EQ(After(watch, *error.low * 0.7).level, HealthLevel::kError) << watch.topic;
    }
    if (error.high) {
      EXPECT_EQ(After(watch, *error.high * 1.5).level, HealthLevel::kError) << watch.topic;
    }
  }
}

TEST_F(ShippedTopicsTest, AScannerOrSonarThatSeesNothingIsAnErrorThoughItsMessagesCome) {
  for (const TopicWatch& watch : Operating().topics) {
    if (watch.content == Content::kAny) continue;
    EXPECT_EQ(After(watch, 10).level, HealthLevel::kOk) << watch.topic;
    EXPECT_EQ(After(watch, 10, NAN).level, HealthLevel::kError) << watch.topic;
  }
}

TEST_F(ShippedTopicsTest, ARateBetweenTheBandsIsAWarning) {
  for (const TopicWatch& watch : Operating().topics) {
    if (!watch.band.warn.low) continue;
    ASSERT_TRUE(watch.band.error.low) << watch.topic;
    const double between = (*watch.band.warn.low + *watch.band.error.low) / 2;
    EXPECT_EQ(After(watch, between).level, HealthLevel::kWarn) << watch.topic;
  }
}

TEST_F(ShippedMonitorsTest, TheScannerIsWatchedForScansInEveryConfiguration) {
  for (const WatchList& list : config_.lists) {
    const auto is_scan = [](const TopicWatch& watch) {
      return watch.topic == "/scan" && watch.content == Content::kLaserScan && !watch.node.empty();
    };
    EXPECT_TRUE(std::any_of(list.topics.begin(), list.topics.end(), is_scan)) << list.configuration;
  }
}

TEST_F(ShippedMonitorsTest, PerceptionThatHangsIsAnErrorUnlessItIsSwitchedOff) {
  for (const char* const configuration : {"operating", "away"}) {
    const WatchList& list = config_.ForConfiguration(configuration);
    for (const std::string node : {"/people_tracker", "/camera_detector"}) {
      const auto watch = std::find_if(list.nodes.begin(), list.nodes.end(),
                                      [&](const NodeWatch& one) { return one.node == node; });
      ASSERT_NE(watch, list.nodes.end()) << configuration << node;
      NodeMonitor monitor;
      monitor.Watch({*watch});
      for (int i = 0; i < watch->misses; ++i) monitor.Observe(node, {});
      EXPECT_EQ(monitor.Report({}, {}).at(0).level, HealthLevel::kError) << node;
      ProcessTable off;
      off.by_node[node] = {};
      EXPECT_EQ(monitor.Report(off, {}).at(0).level, HealthLevel::kOk) << node;
    }
  }
}

TEST_F(ShippedMonitorsTest, EverySonarIsWatchedInEveryConfiguration) {
  for (const WatchList& list : config_.lists) {
    const auto is_sonar = [](const TopicWatch& watch) {
      return watch.topic.rfind("/sonar/", 0) == 0 && watch.content == Content::kRange;
    };
    EXPECT_EQ(std::count_if(list.topics.begin(), list.topics.end(), is_sonar), 3)
        << list.configuration;
  }
}

TEST_F(ShippedMonitorsTest, AStrangerWhoMovesTheRobotIsAnErrorInEveryConfiguration) {
  for (const WatchList& list : config_.lists) {
    PublisherMonitor monitor;
    monitor.Watch(list.publishers);
    for (const char* topic : {"/cmd_vel", "/cmd_vel/autonomous", "/cmd_vel/supervisor"}) {
      monitor.OnMessage(topic, "/stranger", {Time(seconds(1)), Time(seconds(1))});
    }
    EXPECT_THAT(
        SubjectsAt(HealthLevel::kError, monitor.Report({}, {Time(seconds(1)), Time(seconds(1))})),
        ElementsAre("publisher /cmd_vel", "publisher /cmd_vel/autonomous",
                    "publisher /cmd_vel/supervisor"))
        << list.configuration;
  }
}

TEST_F(ShippedMonitorsTest, ALocalizationThatIsNotConfirmedIsAnError) {
  LocalizationMonitor monitor;
  monitor.Watch(Operating().localization);
  LocalizationReading report;
  report.since_confirmed = 15;
  monitor.OnState(report, {Time(seconds(1)), Time(seconds(1))});
  const auto level = [&] {
    return monitor.Report(processes_, {Time(seconds(1)), Time(seconds(1))})[1].level;
  };
  EXPECT_EQ(level(), HealthLevel::kWarn);
  report.since_confirmed = 25;
  monitor.OnState(report, {Time(seconds(1)), Time(seconds(1))});
  EXPECT_EQ(level(), HealthLevel::kError);
}

TEST_F(ShippedMonitorsTest, ABatteryOutsideItsBandsOrWithoutNumbersIsAnError) {
  leaves::BatteryReading bad;
  bad.charger = leaves::ChargerState::kDischarging;
  for (const bool is_measured : {true, false}) {
    BatteryMonitor monitor;
    monitor.Watch(Operating().battery);
    if (is_measured) bad.voltage = 20, bad.current = -80, bad.level = 0.05, bad.charge = 3;
    for (int i = 0; i < 5; ++i) monitor.OnReading(bad, {Time(seconds(i)), {}});
    EXPECT_THAT(
        SubjectsAt(HealthLevel::kError, monitor.Report(processes_, {Time(seconds(4)), {}})),
        ElementsAre("battery voltage", "battery current", "battery charge", "battery margin"));
    bad = {};
    bad.charger = leaves::ChargerState::kDischarging;
  }
}

// "No global path found and MoveBase recoveries failed": the real navigation in a room in two
// halves, of which it can leave none.
class ShippedNavigationTest : public ShippedMonitorsTest {
 protected:
  ShippedNavigationTest() {
    OccupancyGrid room = navigation::EmptyRoom(12, 6);
    navigation::Fill(room, {6, 0}, {6.3, 6});
    floor_ = room;
    navigation_.SetMap(room);
    navigation_.SetGoal({10, 3, 0}, now_);
  }
  // The levels on the way until it gives up the goal.
  std::vector<HealthLevel> Drive(const NavigationWatch& watch) {
    NavigationMonitor monitor;
    monitor.Watch(watch);
    std::vector<HealthLevel> levels;
    while (navigation_.end() == navigation::Navigation::End::kNone && now_ < 1000) {
      now_ += 0.1;
      navigation_.AddScan(pose_, navigation::ScanOf(floor_, pose_, now_));
      pose_ = Advance(pose_, navigation_.Update(now_, pose_, now_), 0.1);
      monitor.OnState(State(), {At(now_), At(now_)});
      levels.push_back(monitor.Report(processes_, {At(now_), At(now_)}).at(0).level);
    }
    return levels;
  }

 private:
  NavigationReport State() const {
    NavigationReport report;
    report.phase = static_cast<NavigationPhase>(navigation_.status());
    report.in_phase = Lasting(now_ - navigation_.status_since());
    report.consecutive_failures = static_cast<std::uint32_t>(navigation_.consecutive_failures());
    return report;
  }

  OccupancyGrid floor_;
  navigation::Navigation navigation_;
  Pose2D pose_{2, 3, 0};
  double now_ = 100;
};

TEST_F(ShippedNavigationTest, TheErrorComesWhenTheNavigationsOwnRecoveriesHaveFailed) {
  const std::vector<HealthLevel> levels = Drive(*Operating().navigation);
  ASSERT_GT(levels.size(), 100U) << "it tries for longer than 10 s";
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    ASSERT_NE(levels[i], HealthLevel::kError) << "after " << 0.1 * static_cast<double>(i) << " s";
  }
  EXPECT_EQ(levels[levels.size() / 2], HealthLevel::kWarn);
  EXPECT_EQ(levels.back(), HealthLevel::kError);
}

TEST_F(ShippedNavigationTest, TheBoundsAreLongerThanItsRecoveriesCanTake) {
  const navigation::NavigationSettings settings;
  // It waits, forgets obstacles, turns for at most four times its patience, and looks after each.
  const double longest = 5 * settings.patience + 2 * settings.after_recovery;
  for (const WatchList& list : config_.lists) {
    if (!list.navigation) continue;
    EXPECT_GT(list.navigation->no_path, Lasting(longest)) << list.configuration;
    EXPECT_GT(list.navigation->blocked, Lasting(longest)) << list.configuration;
  }
}

}  // namespace
}  // namespace coppice::robot::monitoring
