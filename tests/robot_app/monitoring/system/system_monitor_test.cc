#include "robot_app/monitoring/system/system_monitor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot_app/monitoring/system/system_fields.h"
#include "tests/robot_app/monitoring/system/proc_root.h"

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;
using std::chrono::seconds;

Band AtMost(double bound, int consecutive = 1) {
  return {{}, {std::nullopt, bound}, consecutive, Duration::zero(), 0};
}

class SystemMonitorTest : public testing::Test {
 protected:
  SystemMonitorTest() {
    watch_.window = seconds(5);
    watch_.cpu_load = AtMost(0.9, 3);
    watch_.cpu_temperature = AtMost(90);
    watch_.memory_used = AtMost(0.9);
    watch_.disks = {{testing::TempDir(), AtMost(1.1)}, {"/nowhere", AtMost(0.9)}};
    watch_.interfaces = {{"eth0", 100, AtMost(0.8), AtMost(10), AtMost(10)}};
    watch_.clocks = {{"jetson", "10.0.0.2", 123, {{-0.1, 0.1}, {-1, 1}, 2, Duration::zero(), 0}}};
    watch_.hosts = {{"jetson", "10.0.0.2", 22, AtMost(1, 2)}};
    watch_.processes = {{"/navigation", AtMost(0.9), AtMost(500), AtMost(50), AtMost(2)}};
    monitor_.Watch(&watch_);
  }

  // One measurement a second; ticks since the last one.
  void Second(int busy_ticks, int idle_ticks) {
    busy_ += busy_ticks;
    idle_ += idle_ticks;
    root_.WriteCpu(busy_, idle_);
    monitor_.OnSample(LookAtSystem(root_.path(), monitor_.Question(pids_), now_ += seconds(1)));
  }
  Finding About(const std::string& monitor, const std::string& subject) {
    for (const Finding& finding : monitor_.Report({}, {Time(seconds(9)), now_})) {
      if (finding.monitor == monitor && finding.subject == subject) return finding;
    }
    ADD_FAILURE() << "nothing about " << monitor << " " << subject;
    return {};
  }

  ProcRoot root_{"system_monitor_test"};
  SystemMonitor monitor_;
  SystemWatch watch_;
  std::map<std::string, int> pids_;
  Time now_{seconds(100)};
  int busy_ = 1000, idle_ = 1000;
};

TEST_F(SystemMonitorTest, TheLoadIsThatOfTheWindow) {
  Second(0, 0);
  EXPECT_TRUE(std::isnan(About("cpu", "load").value));
  for (int i = 0; i < 5; ++i) Second(30, 70);
  EXPECT_NEAR(About("cpu", "load").value, 0.3, 1e-9);
  for (int i = 0; i < 5; ++i) Second(100, 0);
  EXPECT_NEAR(About("cpu", "load").value, 1, 1e-9);
  EXPECT_EQ(About("cpu", "load").level, HealthLevel::kWarn);  // not three times in a row yet
  for (int i = 0; i < 2; ++i) Second(100, 0);
  EXPECT_EQ(About("cpu", "load").level, HealthLevel::kError);
  EXPECT_EQ(About("cpu", "load").message, "1, expected at most 0.9");
}

TEST_F(SystemMonitorTest, MemoryTemperatureAndDisksAreJudged) {
  root_.WriteMemory(1000, 50);
  root_.Write("/sys/class/thermal/thermal_zone0/temp", "91000");
  Second(0, 100);
  EXPECT_EQ(About("memory", "used").level, HealthLevel::kError);
  EXPECT_NEAR(About("memory", "used").value, 0.95, 1e-9);
  EXPECT_EQ(About("cpu", "temperature").message, "91 °C, expected at most 90 °C");
  EXPECT_EQ(About("disk", testing::TempDir()).level, HealthLevel::kOk);
  EXPECT_EQ(About("disk", "/nowhere").level, HealthLevel::kError);
  EXPECT_EQ(About("disk", "/nowhere").message, "no such disk");
}

TEST_F(SystemMonitorTest, TheLoadOfALinkIsThatOfItsBusierDirection) {
  root_.WriteInterface("eth0", 0, 0, 0, 0);
  Second(0, 100);
  root_.WriteInterface("eth0", 1000000, 11000000, 5, 30);  // 88 Mbit/s of 100
  Second(0, 100);
  EXPECT_NEAR(About("network", "eth0 load").value, 0.88, 1e-9);
  EXPECT_EQ(About("network", "eth0 load").level, HealthLevel::kError);
  EXPECT_EQ(About("network", "eth0 errors").value, 5);
  EXPECT_EQ(About("network", "eth0 errors").level, HealthLevel::kOk);
  EXPECT_EQ(About("network", "eth0 drops").level, HealthLevel::kError);
}

TEST_F(SystemMonitorTest, AnInterfaceThatIsGoneIsAnError) {
  Second(0, 100);
  EXPECT_EQ(About("network", "eth0 load").message, "no such interface");
  EXPECT_EQ(About("network", "eth0 load").level, HealthLevel::kError);
}

TEST_F(SystemMonitorTest, ProcessesAreJudgedByTheirPids) {
  pids_["/navigation"] = 77;
  root_.WriteProcess(77, 100, 0, 60, 100);
  Second(0, 100);
  root_.WriteProcess(77, 150, 48, 60, 100);
  Second(0, 100);
  EXPECT_NEAR(About("process", "/navigation cpu").value, 0.98, 1e-9);
  EXPECT_EQ(About("process", "/navigation cpu").level, HealthLevel::kError);
  EXPECT_EQ(About("process", "/navigation memory").level, HealthLevel::kOk);
  EXPECT_EQ(About("process", "/navigation threads").level, HealthLevel::kError);
  EXPECT_EQ(About("process", "/navigation files").level, HealthLevel::kError);
}

TEST_F(SystemMonitorTest, ARestartedProcessIsMeasuredAnew) {
  pids_["/navigation"] = 77;
  root_.WriteProcess(77, 1000, 0, 1, 1);
  Second(0, 100);
  pids_["/navigation"] = 78;
  root_.WriteProcess(78, 5000, 0, 1, 1);
  Second(0, 100);
  EXPECT_TRUE(std::isnan(About("process", "/navigation cpu").value));
}

TEST_F(SystemMonitorTest, AProcessThatDoesNotRunIsForOthersToJudge) {
  Second(0, 100);
  pids_["/navigation"] = 0;
  Second(0, 100);
  pids_["/navigation"] = 4711;  // just ended
  Second(0, 100);
  EXPECT_EQ(About("process", "/navigation cpu").level, HealthLevel::kOk);
}

TEST_F(SystemMonitorTest, AClockThatIsOffTwiceIsAnError) {
  ClockReading reading;
  reading.offset = -3;
  monitor_.OnClocks({reading}, now_);
  EXPECT_EQ(About("clock", "jetson").level, HealthLevel::kWarn);
  monitor_.OnClocks({reading}, now_);
  EXPECT_EQ(About("clock", "jetson").level, HealthLevel::kError);
  EXPECT_EQ(About("clock", "jetson").message, "-3 s, expected -1 to 1 s");
  reading.offset = 0.01;
  monitor_.OnClocks({reading}, now_);
  EXPECT_EQ(About("clock", "jetson").level, HealthLevel::kOk);
  const Problem silent{"no answer"};
  monitor_.OnClocks({silent}, now_);
  monitor_.OnClocks({silent}, now_);
  EXPECT_EQ(About("clock", "jetson").level, HealthLevel::kError);
  EXPECT_EQ(About("clock", "jetson").message, "no answer");
}

TEST_F(SystemMonitorTest, AComputerThatDoesNotAnswerTwiceIsAnError) {
  const Problem silent{"no answer"};
  monitor_.OnHosts({silent}, now_);
  monitor_.OnHosts({silent}, now_);
  EXPECT_EQ(About("network", "host jetson").level, HealthLevel::kError);
  monitor_.OnHosts({0.002}, now_);
  EXPECT_EQ(About("network", "host jetson").level, HealthLevel::kOk);
}

TEST_F(SystemMonitorTest, ASystemThatDoesNotAnswerIsTold) {
  root_.WriteMemory(1000, 900);
  Second(0, 100);
  now_ += seconds(10);
  EXPECT_EQ(About("memory", "used").level, HealthLevel::kOk);
  now_ += seconds(1);
  EXPECT_EQ(About("memory", "used").level, HealthLevel::kError);
  EXPECT_EQ(About("disk", testing::TempDir()).message,
            "the system has not answered for 11 s: does a disk hang?");
  Second(0, 100);
  EXPECT_EQ(About("memory", "used").level, HealthLevel::kOk);
}

TEST_F(SystemMonitorTest, ASystemThatHasNeverAnsweredIsTold) {
  EXPECT_NE(About("memory", "used").level, HealthLevel::kError);
  now_ += seconds(11);
  EXPECT_EQ(About("memory", "used").level, HealthLevel::kError);
}

TEST_F(SystemMonitorTest, WithoutAWatchThereIsNothingToSay) {
  monitor_.Watch(nullptr);
  Second(0, 100);
  monitor_.OnClocks({{}}, now_);
  EXPECT_TRUE(monitor_.Report({}, {Time(seconds(9)), now_}).empty());
}

TEST_F(SystemMonitorTest, ALinkThatIsNamedAndDownIsAnError) {
  root_.WriteInterface("eth0", 0, 0, 0, 0);
  root_.Write("/sys/class/net/eth0/operstate", "down\n");
  Second(0, 100);
  EXPECT_EQ(About("network", "eth0 load").message, "the link is down");
}

TEST_F(SystemMonitorTest, TheLoadIsAShareOfTheSpeedThatTheLinkTells) {
  root_.Write("/sys/class/net/eth0/speed", "10\n");  // not 100
  for (int i = 0; i < 3; ++i) {
    root_.WriteInterface("eth0", 1250000L * i, 0, 0, 0);
    Second(0, 100);
  }
  EXPECT_NEAR(About("network", "eth0 load").value, 1, 1e-9);
}

TEST_F(SystemMonitorTest, LinksThatComeAndGoAreWatchedWhileTheyAreThere) {
  watch_.interfaces[0].interface = "wl*";
  monitor_.Watch(&watch_);
  const auto is_told = [this] {
    for (const Finding& finding : monitor_.Report({}, {Time(seconds(9)), now_})) {
      if (finding.subject == "wlan0 load") return true;
    }
    return false;
  };
  EXPECT_FALSE(is_told());
  root_.WriteInterface("wlan0", 0, 0, 0, 0);
  Second(0, 100);
  EXPECT_TRUE(is_told());
  root_.WriteInterface("eth0", 0, 0, 0, 0);
  Second(0, 100);
  EXPECT_FALSE(is_told());
}

}  // namespace
}  // namespace coppice::robot::monitoring
