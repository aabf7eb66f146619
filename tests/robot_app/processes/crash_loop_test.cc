// The restart loop that stopped the robot of Stuede et al. ("Sobi", ECMR 2021) for good: the filter
// of the odometry starts in an unclean state and crashes 5 to 15 s after every start, what depends
// on it crashes after it. Played in simulated time with the whole supervisor.
#include <gmock/gmock.h>

#include <random>

#include "tests/robot_app/processes/simulated_machine.h"
#include "tests/support/folders.h"

namespace coppice::robot::processes {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// base <- ekf <- localization <- navigation; base <- speech, which nobody needs.
RobotConfig Robot() {
  RobotConfig config;
  config.processes = {MakeProcess("base"), MakeProcess("ekf", {0}),
                      MakeProcess("localization", {1}), MakeProcess("navigation", {2}),
                      MakeProcess("speech", {0})};
  AddOwnGroups(config);
  config.groups[4].essential = false;
  config.configurations = {{"operating", {0, 1, 2, 3, 4}, {}}, {"safe", {0, 4}, {}}};
  config.given_up.configuration = 1;
  return config;
}

enum class HealedBy { kClosure, kStack, kNothing };

// Parameter: seed of the times of the crashes.
class CrashLoopTest : public testing::TestWithParam<unsigned> {
 protected:
  CrashLoopTest() : random_(GetParam()) {
    robot_.machine.programs["ekf"].crashes = [this]() -> std::optional<Duration> {
      if (!unclean_) return std::nullopt;
      return milliseconds(std::uniform_int_distribution<>(5000, 15000)(random_));
    };
    for (const char* name : {"localization", "navigation"}) {
      robot_.machine.programs[name].crashes = [this]() -> std::optional<Duration> {
        // Without a filter it lasts as long as the filter, and a little longer.
        if (!unclean_) return std::nullopt;
        return milliseconds(std::uniform_int_distribution<>(5000, 16000)(random_));
      };
    }
  }

  void HealsBy(HealedBy what) {
    if (what == HealedBy::kClosure) {
      robot_.machine.on_clear = [this](const std::string& name) {
        if (name == "ekf") unclean_ = false;
      };
    }
    if (what == HealedBy::kStack) robot_.on_new_stack = [this] { unclean_ = false; };
  }

  // Runs it healthy for a while, then lets the loop begin. Its first crash is the time zero.
  void Begin() {
    ASSERT_TRUE(robot_.RunUntil([this] { return robot_.AllReady(); }, seconds(30)));
    robot_.RunFor(seconds(120));
    unclean_ = true;
    starts_before_ = robot_.machine.Starts("ekf");
    robot_.machine.Crash("ekf");
    robot_.machine.Crash("localization");
    begin_ = robot_.machine.now;
  }

  Duration Since() const { return robot_.machine.now - begin_; }
  int Restarts() const { return robot_.machine.Starts("ekf") - starts_before_; }

  std::mt19937 random_;
  bool unclean_ = false;
  int starts_before_ = 0;
  Time begin_{};
  SimulatedRobot robot_{Robot()};
};

TEST_P(CrashLoopTest, IsRecognisedInThreeRestartsAndEscalatedWithinAMinute) {
  HealsBy(HealedBy::kNothing);
  Begin();
  const std::size_t ekf = robot_.Index("ekf");
  ASSERT_TRUE(robot_.RunUntil(
      [&] { return robot_.supervisor().escalation(ekf) != EscalationStep::kGroup; }, seconds(120)));
  EXPECT_LE(Restarts(), 3);
  EXPECT_LE(Since(), seconds(60));
}

TEST_P(CrashLoopTest, HealsWhenTheRootIsRestartedFromAClearedStateWithItsDependents) {
  HealsBy(HealedBy::kClosure);
  Begin();
  ASSERT_TRUE(robot_.RunUntil([&] { return !unclean_; }, seconds(120)));
  ASSERT_TRUE(robot_.RunUntil([&] { return robot_.AllReady(); }, seconds(30)));
  robot_.RunFor(seconds(300));
  EXPECT_TRUE(robot_.AllReady());
  EXPECT_EQ(robot_.stacks, 0);
  EXPECT_THAT(robot_.calls, IsEmpty());
  EXPECT_LE(Restarts(), 4);
  EXPECT_EQ(robot_.machine.Starts("base"), 1);    // nothing else was disturbed
  EXPECT_EQ(robot_.machine.Starts("speech"), 1);  // (what needs it was not its fault)
  EXPECT_EQ(robot_.supervisor().escalation(robot_.Index("ekf")), EscalationStep::kGroup);
}

TEST_P(CrashLoopTest, HealsWhenOnlyTheWholeStackHelps) {
  HealsBy(HealedBy::kStack);
  Begin();
  ASSERT_TRUE(robot_.RunUntil([&] { return robot_.stacks == 1; }, seconds(240)));
  ASSERT_TRUE(robot_.RunUntil([&] { return robot_.AllReady(); }, seconds(30)));
  robot_.RunFor(seconds(300));
  EXPECT_TRUE(robot_.AllReady());
  EXPECT_EQ(robot_.stacks, 1);
  EXPECT_THAT(robot_.calls, IsEmpty());
  EXPECT_LE(Restarts(), 5);
}

TEST_P(CrashLoopTest, AsksAPersonInTimeAndStopsTheRobotWhenNothingHelps) {
  HealsBy(HealedBy::kNothing);
  Begin();
  ASSERT_TRUE(robot_.RunUntil([&] { return !robot_.calls.empty(); }, seconds(600)));
  EXPECT_LT(Since(), seconds(300));
  EXPECT_THAT(robot_.calls.front(), HasSubstr("The robot has given up ekf: "));
  robot_.RunFor(seconds(3600));
  EXPECT_THAT(robot_.calls, SizeIs(1));
  EXPECT_LE(Restarts(), 5);
  EXPECT_EQ(robot_.Phase("ekf"), ProcessPhase::kGivenUp);
  EXPECT_EQ(robot_.supervisor().configuration(), "safe");
  EXPECT_FALSE(robot_.machine.Runs("navigation"));
  EXPECT_EQ(robot_.Phase("base"), ProcessPhase::kReady);
  EXPECT_EQ(robot_.Phase("speech"), ProcessPhase::kReady);

  // A person repairs it.
  unclean_ = false;
  EXPECT_TRUE(robot_.supervisor().Reset("ekf", robot_.machine.now));
  EXPECT_TRUE(robot_.RunUntil([&] { return robot_.AllReady(); }, seconds(30)));
  EXPECT_EQ(robot_.supervisor().configuration(), "operating");
}

TEST_P(CrashLoopTest, ASupervisorThatDiesInBetweenDoesNotPutItOff) {
  HealsBy(HealedBy::kNothing);
  Begin();
  std::uniform_int_distribution<> until_killed(8000, 40000);
  while (robot_.calls.empty() && Since() < seconds(600)) {
    robot_.RunFor(milliseconds(until_killed(random_)));
    if (!robot_.calls.empty()) break;
    const SupervisorMemory memory = robot_.supervisor().Remember();
    robot_.supervisor().StopAll();  // its children end with it
    while (!robot_.supervisor().AllStopped(robot_.machine.now)) robot_.RunFor(milliseconds(20));
    robot_.Begin(memory);
  }
  EXPECT_THAT(robot_.calls, SizeIs(1));
  EXPECT_LT(Since(), seconds(600));
}

INSTANTIATE_TEST_SUITE_P(Seeds, CrashLoopTest, testing::Range(1u, 51u));

// The programs, groups and limits that are shipped.
RobotConfig ShippedRobot() {
  Diagnostics diagnostics;
  RobotConfig config = LoadRobotConfig(
      SourceFolder() + "/robot_app/config/robot.yaml",
      {{"bin", "/bin"}, {"config", SourceFolder() + "/robot_app/config"}, {"record", "/tmp/run"}},
      diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.ToString();
  return config;
}

TEST(ShippedRobotInACrashLoop, ClimbsToASafeStopAndAPersonAndStaysThereQuietly) {
  SimulatedRobot robot{ShippedRobot()};
  ASSERT_TRUE(robot.RunUntil([&] { return robot.AllReady(); }, seconds(60)));
  robot.RunFor(seconds(120));
  const int before = robot.machine.Starts("odometry_filter");
  robot.machine.programs["odometry_filter"].crashes = [] { return milliseconds(2000); };
  robot.machine.Crash("odometry_filter");
  const Time begin = robot.machine.now;
  const std::size_t victim = robot.Index("odometry_filter");
  const auto climbs_to = [&](EscalationStep step, Duration at_most) {
    return robot.RunUntil([&] { return robot.supervisor().escalation(victim) == step; }, at_most);
  };
  EXPECT_TRUE(climbs_to(EscalationStep::kClosure, seconds(60)));
  EXPECT_LE(robot.machine.Starts("odometry_filter") - before, 4);
  EXPECT_TRUE(climbs_to(EscalationStep::kStack, seconds(240)));
  ASSERT_TRUE(robot.RunUntil([&] { return !robot.calls.empty(); }, seconds(600)));
  EXPECT_EQ(robot.stacks, 1);
  EXPECT_LT(robot.machine.now - begin, std::chrono::minutes(10));
  EXPECT_THAT(robot.calls.front(), HasSubstr("has given up odometry_filter"));

  ASSERT_TRUE(robot.RunUntil([&] { return robot.AllReady(); }, seconds(60)));
  EXPECT_EQ(robot.supervisor().configuration(), "safe_stop");
  const std::size_t starts = robot.machine.starts.size();
  robot.RunFor(std::chrono::hours(3));
  EXPECT_EQ(robot.machine.starts.size(), starts);
  EXPECT_THAT(robot.calls, SizeIs(1));
  EXPECT_EQ(robot.stacks, 1);
  for (const char* moves : {"navigation", "docking", "localization", "odometry_filter"}) {
    EXPECT_FALSE(robot.machine.Runs(moves)) << moves;
  }
}

class SlowLoopTest : public testing::Test {
 protected:
  void CrashEach(const std::string& name, Duration after) {
    robot_.machine.programs[name].crashes = [after] { return std::optional<Duration>(after); };
  }
  bool IsAskedWithin(Duration duration) {
    return robot_.RunUntil([this] { return !robot_.calls.empty(); }, duration);
  }
  SimulatedRobot robot_{Robot()};
};

TEST_F(SlowLoopTest, CrashesTooSlowForTheWindowStillEscalate) {
  CrashEach("ekf", seconds(50));
  EXPECT_TRUE(IsAskedWithin(seconds(600)));
}

TEST_F(SlowLoopTest, CrashesAfterGoodHealthEscalateByTheHourlyLimit) {
  CrashEach("ekf", seconds(100));
  EXPECT_TRUE(IsAskedWithin(std::chrono::hours(1)));
}

TEST_F(SlowLoopTest, AProgramThatNeverGetsReadyIsHandedToAPersonInTime) {
  robot_.machine.programs["ekf"].loads = std::chrono::hours(100);
  robot_.machine.programs["ekf"].ignores_term = true;
  EXPECT_TRUE(IsAskedWithin(seconds(600)));
  EXPECT_LE(robot_.machine.Starts("ekf"), 6);
}

TEST_F(SlowLoopTest, AProgramThatNobodyNeedsNeverRestartsTheStackNorStopsTheRobot) {
  CrashEach("speech", seconds(5));
  EXPECT_TRUE(IsAskedWithin(seconds(600)));
  EXPECT_EQ(robot_.stacks, 0);
  EXPECT_EQ(robot_.supervisor().configuration(), "operating");
  EXPECT_EQ(robot_.Phase("navigation"), ProcessPhase::kReady);
  EXPECT_EQ(robot_.machine.Starts("navigation"), 1);
}

TEST_F(SlowLoopTest, FailuresWithGoodHealthInBetweenDoNotEscalate) {
  robot_.RunFor(seconds(30));
  for (int i = 0; i < 20; ++i) {
    robot_.machine.Crash("ekf");
    robot_.RunFor(seconds(500));
    EXPECT_TRUE(robot_.AllReady());
  }
  EXPECT_THAT(robot_.calls, IsEmpty());
  EXPECT_EQ(robot_.machine.Starts("ekf"), 21);
  EXPECT_EQ(robot_.machine.Starts("navigation"), 1);
}

TEST_F(SlowLoopTest, RecoveryBeginsAtOnce) {
  robot_.RunFor(seconds(100));
  robot_.machine.Crash("navigation");
  robot_.RunFor(milliseconds(40));
  EXPECT_EQ(robot_.machine.Starts("navigation"), 2);
}

TEST(HangLoopTest, WhatHangsAfterEveryStartIsGivenUpAndAPersonIsCalled) {
  RobotConfig config = Robot();
  config.processes[3].heartbeat = HeartbeatConfig{"/beat", seconds(5)};
  SimulatedRobot robot(config);
  robot.machine.programs[config.processes[3].name].hangs = true;
  const auto given_up = [&] { return robot.Phase("navigation") == ProcessPhase::kGivenUp; };
  EXPECT_TRUE(robot.RunUntil(given_up, seconds(540)));
  EXPECT_EQ(robot.stacks, 1);
  EXPECT_THAT(robot.calls, ElementsAre(HasSubstr("navigation gave no sign of life for 5 s")));
}

}  // namespace
}  // namespace coppice::robot::processes
