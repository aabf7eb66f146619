// What is restarted with what, and what is not: kinds of processes, strategies of groups, other
// hosts.
#include "tests/robot_app/processes/supervisor_fixture.h"

namespace coppice::robot::processes {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;

class TransientProcessTest : public SupervisorTest {
 protected:
  static RobotConfig Config(RestartRule rule) {
    RobotConfig config = FourProcesses();
    config.processes[kNav].restart = rule;
    return config;
  }
  explicit TransientProcessTest(RestartRule rule = RestartRule::kOnFailure)
      : SupervisorTest(Config(rule)) {
    StartAll();
  }
};

TEST_F(TransientProcessTest, IsRestartedAfterAFailureButNotAfterAGoodEnd) {
  Ended(kNav, kExit3);
  EXPECT_NE(Pid(kNav), 0);
  Ended(kNav, kExit0);
  EXPECT_EQ(Phase(kNav), ProcessPhase::kStopped);
  now_ += seconds(100);
  Step();
  EXPECT_EQ(Pid(kNav), 0);
  EXPECT_FALSE(supervisor_.IsChanging());
}

TEST_F(TransientProcessTest, WhatNeedsItMayStartWhenItHasDoneItsWork) {
  Ended(kNav, kExit0);
  launcher_.TakeLog();
  Ended(kApp, kKilled);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start app"));
}

TEST_F(TransientProcessTest, StartsAgainOnRequestAndWithTheNextChangeOfConfiguration) {
  Ended(kNav, kExit0);
  EXPECT_TRUE(Restart("nav"));
  EXPECT_NE(Pid(kNav), 0);
  Ended(kNav, kExit0);
  EXPECT_TRUE(Configure("charging"));
  Step();
  Ended(kApp, kExit0);
  EXPECT_TRUE(Configure("operating"));
  Step();
  EXPECT_NE(Pid(kNav), 0);
}

class TemporaryProcessTest : public TransientProcessTest {
 protected:
  TemporaryProcessTest() : TransientProcessTest(RestartRule::kNever) {}
};

TEST_F(TemporaryProcessTest, IsNotRestartedEvenAfterAFailure) {
  Ended(kNav, kKilled);
  EXPECT_EQ(Phase(kNav), ProcessPhase::kStopped);
  EXPECT_EQ(Message(kNav), "ended by signal 9");
}

// Three processes in one group: a, b, c.
class StrategyTest : public SupervisorTest {
 protected:
  static RobotConfig Config(Strategy strategy) {
    RobotConfig config;
    config.processes = {MakeProcess("a"), MakeProcess("b"), MakeProcess("c")};
    config.groups.resize(1);
    config.groups[0].name = "abc";
    config.groups[0].strategy = strategy;
    config.groups[0].processes = {0, 1, 2};
    if (strategy == Strategy::kRestForOne) {
      config.processes[1].after = {0};
      config.processes[2].after = {1};
    }
    config.configurations = {{"all", {0, 1, 2}, {}}};
    return config;
  }
  explicit StrategyTest(Strategy strategy = Strategy::kOneForOne)
      : SupervisorTest(Config(strategy)) {
    StartAll();
  }
};

TEST_F(StrategyTest, OneForOneRestartsTheFailedOneOnly) {
  Ended(1, kKilled);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start b"));
  EXPECT_EQ(supervisor_.RestartsUsed(0, now_), 1);  // the budget is the group's
}

class RestForOneTest : public StrategyTest {
 protected:
  RestForOneTest() : StrategyTest(Strategy::kRestForOne) {}
};

TEST_F(RestForOneTest, RestartsTheFailedOneAndThoseAfterItInOrder) {
  Ended(1, kKilled);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end c"));
  Ended(2, kExit0);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start b"));
  Ready(1);
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start c"));
}

class OneForAllTest : public StrategyTest {
 protected:
  OneForAllTest() : StrategyTest(Strategy::kOneForAll) {}
};

TEST_F(OneForAllTest, EndsAllBeforeItStartsAny) {
  Ended(1, kKilled);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end a", "end c"));
  Ended(2, kExit0);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre());
  EXPECT_EQ(Message(1), "waits for others to end");
  Ended(0, kExit0);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start a", "start b", "start c"));
}

TEST_F(StrategyTest, ARestartOfTheGroupRestartsAllOfItAndCountsOnce) {
  EXPECT_TRUE(Restart("abc"));
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end a", "end b", "end c"));
  EXPECT_EQ(supervisor_.RestartsUsed(0, now_), 1);
}

RobotConfig Ordered() {
  RobotConfig config;
  config.processes = {MakeProcess("nav"), MakeProcess("robot")};
  config.processes[1].after = {0};
  AddOwnGroups(config);
  config.configurations = {{"operating", {0, 1}, {}}, {"charging", {1}, {}}};
  return config;
}

class OrderedSupervisorTest : public SupervisorTest {
 protected:
  OrderedSupervisorTest() : SupervisorTest(Ordered()) {}
};

TEST_F(OrderedSupervisorTest, WaitsForWhatComesBeforeOnlyIfItIsToCome) {
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start nav"));
  EXPECT_EQ(Message(1), "waits for nav");
  Ended(0, kKilled);  // it backs off: no reason to wait any longer
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start robot"));
}

TEST_F(OrderedSupervisorTest, StaysUpWhenWhatCameBeforeIsNoLongerNeeded) {
  StartAll();
  EXPECT_TRUE(Configure("charging"));
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end nav"));
}

class RemoteProcessTest : public SupervisorTest {
 protected:
  static RobotConfig Config() {
    RobotConfig config = FourProcesses();
    config.hosts.resize(1);
    config.hosts[0].name = "jetson";
    config.processes[kNav].host = 0;
    return config;
  }
  RemoteProcessTest() : SupervisorTest(Config()) {}
};

TEST_F(RemoteProcessTest, IsUnreachableWhileItsHostDoesNotAnswerAndNothingElseIsDisturbed) {
  StartAll();
  launcher_.connected = false;
  Ended(kNav, 255 << 8);
  EXPECT_EQ(Phase(kNav), ProcessPhase::kUnreachable);
  EXPECT_EQ(Message(kNav), "host jetson cannot be reached");
  for (int i = 0; i < 300; ++i) {  // an hour
    now_ += seconds(12);
    Step();
    if (Pid(kNav) != 0) supervisor_.OnExit(Pid(kNav), i % 2 ? 255 << 8 : kKilled, now_);
    EXPECT_EQ(Phase(kNav), ProcessPhase::kUnreachable);
  }
  EXPECT_EQ(Phase(kApp), ProcessPhase::kReady);
  EXPECT_EQ(Phase(kBase), ProcessPhase::kReady);
  EXPECT_EQ(supervisor_.escalation(kNav), EscalationStep::kGroup);
  EXPECT_EQ(supervisor_.RestartsUsed(kNav, now_), 0);

  launcher_.connected = true;
  now_ += seconds(10);
  Step();
  Step();
  EXPECT_EQ(Phase(kNav), ProcessPhase::kStarting);
  Ready(kNav);
  EXPECT_EQ(Phase(kNav), ProcessPhase::kReady);
}

TEST_F(RemoteProcessTest, AConnectionThatHangsIsGivenUpAndTriedAgain) {
  launcher_.connected = false;
  Step();
  Ready(kBase);
  Step();
  Ready(kDock);
  EXPECT_EQ(Phase(kNav), ProcessPhase::kStarting);
  now_ += seconds(20);
  Step();
  EXPECT_EQ(Phase(kNav), ProcessPhase::kUnreachable);
  Step();
  EXPECT_THAT(launcher_.TakeLog(), testing::Contains("end nav"));
  Ended(kNav, kKilled);
  EXPECT_EQ(Phase(kNav), ProcessPhase::kUnreachable);
  now_ += seconds(5);
  Step();
  EXPECT_THAT(launcher_.TakeLog(), testing::Contains("start nav"));
}

}  // namespace
}  // namespace coppice::robot::processes
