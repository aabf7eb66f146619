#include "robot_app/monitoring/system/proc_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/robot_app/monitoring/system/proc_root.h"

namespace coppice::robot::monitoring {
namespace {

class ProcFilesTest : public testing::Test {
 protected:
  ProcRoot root_{"proc_files_test"};
};

TEST_F(ProcFilesTest, IdleAndWaitingForDisksIsNoWork) {
  root_.Write("/proc/stat", "cpu  10 20 30 400 50 6 7 8 900 1000\ncpu0 1 1 1 1\n");
  const auto times = ReadCpuTimes(root_.path());
  ASSERT_TRUE(times.has_value());
  EXPECT_EQ(times->total, 10u + 20 + 30 + 400 + 50 + 6 + 7 + 8);  // guests are counted in user
  EXPECT_EQ(times->busy, 10u + 20 + 30 + 6 + 7 + 8);
}

TEST_F(ProcFilesTest, TheHottestSensorCounts) {
  EXPECT_FALSE(ReadTemperature(root_.path()).has_value());
  root_.Write("/sys/class/thermal/thermal_zone0/temp", "45000\n");
  root_.Write("/sys/class/thermal/cooling_device0/temp", "99000\n");
  root_.Write("/sys/class/hwmon/hwmon0/temp1_input", "71500\n");
  root_.Write("/sys/class/hwmon/hwmon0/temp1_crit", "100000\n");
  root_.Write("/sys/class/hwmon/hwmon0/temp2_input", "-274000\n");  // a sensor that is not there
  root_.Write("/sys/class/hwmon/hwmon0/temp3_input", "nonsense\n");
  EXPECT_EQ(ReadTemperature(root_.path()), 71.5);
}

TEST_F(ProcFilesTest, MemoryIsUsedIfItIsNotAvailable) {
  root_.WriteMemory(1000, 250);
  EXPECT_EQ(ReadMemoryUsed(root_.path()), 0.75);
  root_.Write("/proc/meminfo", "MemTotal: 1000 kB\nMemFree: 250 kB\n");
  EXPECT_FALSE(ReadMemoryUsed(root_.path()).has_value());
}

TEST_F(ProcFilesTest, AnInterfaceIsFoundByItsWholeName) {
  root_.WriteInterface("eth0", 1000, 2000, 3, 4);
  const auto counters = ReadInterface(root_.path(), "eth0");
  ASSERT_TRUE(counters.has_value());
  EXPECT_EQ(counters->received, 1000u);
  EXPECT_EQ(counters->sent, 2000u);
  EXPECT_EQ(counters->errors, 3u);
  EXPECT_EQ(counters->drops, 4u);
  EXPECT_EQ(ReadInterface(root_.path(), "lo")->sent, 100u);
  EXPECT_FALSE(ReadInterface(root_.path(), "eth").has_value());
}

TEST_F(ProcFilesTest, AProcessMayHaveAnyName) {
  root_.WriteProcess(77, 150, 50, 5, 1000);
  const auto usage = ReadProcessUsage(root_.path(), 77);
  ASSERT_TRUE(usage.has_value());
  EXPECT_EQ(usage->cpu_time, 200.0 / static_cast<double>(sysconf(_SC_CLK_TCK)));
  EXPECT_EQ(usage->threads, 5);
  EXPECT_EQ(usage->memory, 1000 * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6);
  EXPECT_EQ(usage->files, 3);
}

TEST_F(ProcFilesTest, WhatIsMissingOrNonsenseIsNothing) {
  EXPECT_FALSE(ReadCpuTimes(root_.path()).has_value());
  EXPECT_FALSE(ReadMemoryUsed(root_.path()).has_value());
  EXPECT_FALSE(ReadInterface(root_.path(), "eth0").has_value());
  EXPECT_FALSE(ReadProcessUsage(root_.path(), 77).has_value());
  root_.Write("/proc/stat", "cpu  1 2 three");
  root_.Write("/proc/net/dev", "eth0: 1 2 3\n");
  root_.Write("/proc/77/stat", "77 (x) S 1 2");
  root_.Write("/proc/78/stat", "");
  EXPECT_FALSE(ReadCpuTimes(root_.path()).has_value());
  EXPECT_FALSE(ReadInterface(root_.path(), "eth0").has_value());
  EXPECT_FALSE(ReadProcessUsage(root_.path(), 77).has_value());
  EXPECT_FALSE(ReadProcessUsage(root_.path(), 78).has_value());
}

TEST_F(ProcFilesTest, ThisComputerIsUnderstood) {
  ASSERT_TRUE(ReadCpuTimes("").has_value());
  EXPECT_GT(ReadCpuTimes("")->total, ReadCpuTimes("")->busy);
  ASSERT_TRUE(ReadMemoryUsed("").has_value());
  EXPECT_GT(*ReadMemoryUsed(""), 0);
  EXPECT_TRUE(ReadInterface("", "lo").has_value());
  const auto usage = ReadProcessUsage("", getpid());
  ASSERT_TRUE(usage.has_value());
  EXPECT_GE(usage->threads, 1);
  EXPECT_GT(usage->memory, 0.5);
  EXPECT_GE(usage->files.value_or(0), 3);
  const auto disk = ReadDiskUsed(testing::TempDir());
  ASSERT_TRUE(disk.has_value());
  EXPECT_GE(*disk, 0);
  EXPECT_LE(*disk, 1);
  EXPECT_FALSE(ReadDiskUsed("/nowhere").has_value());
}

TEST(ProcFiles, TheLinksAreThoseThatAreUpButForLoopback) {
  const ProcRoot root("proc_files_links");
  root.WriteInterface("wlp3s0", 1, 2, 0, 0);
  EXPECT_EQ(ReadLinks(root.path()), std::vector<std::string>{"wlp3s0"});
  root.Write("/sys/class/net/wlp3s0/operstate", "down\n");
  EXPECT_TRUE(IsLinkDown(root.path(), "wlp3s0"));
  EXPECT_TRUE(ReadLinks(root.path()).empty());
}

TEST(ProcFiles, ALinkWithoutAFixedSpeedHasNone) {
  const ProcRoot root("proc_files_speed");
  EXPECT_FALSE(ReadLinkSpeed(root.path(), "eth0"));
  root.Write("/sys/class/net/eth0/speed", "-1\n");
  EXPECT_FALSE(ReadLinkSpeed(root.path(), "eth0"));
  root.Write("/sys/class/net/eth0/speed", "100\n");
  EXPECT_EQ(ReadLinkSpeed(root.path(), "eth0"), 100);
}

}  // namespace
}  // namespace coppice::robot::monitoring
