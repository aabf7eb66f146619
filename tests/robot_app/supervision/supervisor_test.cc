#include "robot_app/supervision/supervisor.h"

#include <gmock/gmock.h>

#include <csignal>
#include <map>

#include "tests/robot_app/supervision/simulated_machine.h"

namespace coppice::robot {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;

// Wait statuses as waitpid gives them.
constexpr int kExit0 = 0;
constexpr int kExit3 = 3 << 8;
constexpr int kKilled = SIGKILL;

// Notes what happens; a signalled process lives on until the test says that it ended.
class NotingLauncher : public ProcessLauncher {
 public:
  int Start(const ProcessConfig& config, std::string& error) override {
    log.push_back("start " + config.name);
    if (config.name == broken) {
      error = "cannot run it";
      return 0;
    }
    names[++last_pid] = config.name;
    return last_pid;
  }
  void Signal(int pid, int signal) override {
    log.push_back((signal == SIGKILL ? "kill " : "end ") + names.at(pid));
  }
  std::string ClearState(const ProcessConfig& config) override {
    log.push_back("clear " + config.name);
    return "";
  }
  bool IsConnected(int) const override { return connected; }

  std::vector<std::string> TakeLog() { return std::exchange(log, {}); }

  std::vector<std::string> log;
  std::map<int, std::string> names;
  std::string broken;
  bool connected = true;
  int last_pid = 100;
};

// base <- nav <- app; base <- dock. "operating" has all, "charging" has base and dock.
RobotConfig FourProcesses() {
  RobotConfig config;
  config.processes = {MakeProcess("base"), MakeProcess("nav", {0}), MakeProcess("app", {1}),
                      MakeProcess("dock", {0})};
  AddOwnGroups(config);
  config.configurations = {{"operating", {0, 1, 2, 3}, {}}, {"charging", {0, 3}, {}}};
  return config;
}

class SupervisorTest : public testing::Test {
 protected:
  static constexpr std::size_t kBase = 0, kNav = 1, kApp = 2, kDock = 3;

  explicit SupervisorTest(RobotConfig config = FourProcesses())
      : supervisor_(std::move(config), launcher_) {}

  int Pid(std::size_t process) { return supervisor_.status(process).pid; }
  ProcessPhase Phase(std::size_t process) { return supervisor_.status(process).phase; }
  std::string Message(std::size_t process) { return supervisor_.status(process).message; }

  void Step() { supervisor_.Step(now_); }
  void Ready(std::size_t process) { supervisor_.OnReady(process, Pid(process), now_); }
  void Ended(std::size_t process, int wait_status) {
    supervisor_.OnExit(Pid(process), wait_status, now_);
    Step();
  }
  Verdict Restart(const std::string& name) {
    const Verdict verdict = supervisor_.Restart(name, now_);
    Step();
    return verdict;
  }
  Verdict Configure(const std::string& name) {
    return supervisor_.SetConfiguration(name, Hand::kTree, kNoConditions);
  }
  // Ready, and up for longer than the shortest time between two starts.
  void StartAll() {
    for (int i = 0; i < 3; ++i) {
      Step();
      for (std::size_t p = 0; p < supervisor_.config().processes.size(); ++p) Ready(p);
    }
    now_ += seconds(10);
    launcher_.TakeLog();
  }

  NotingLauncher launcher_;
  Supervisor supervisor_;
  Time now_ = seconds(1000);
};

TEST_F(SupervisorTest, StartsEachProcessWhenItsDependenciesAreReady) {
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start base"));
  EXPECT_EQ(Phase(kNav), ProcessPhase::kStarting);
  EXPECT_EQ(Message(kNav), "waits for base");
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre());
  EXPECT_TRUE(supervisor_.IsChanging());
  Ready(kBase);
  EXPECT_EQ(Phase(kBase), ProcessPhase::kReady);
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start nav", "start dock"));
  Ready(kNav);
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start app"));
  Ready(kApp);
  Ready(kDock);
  EXPECT_FALSE(supervisor_.IsChanging());
}

TEST_F(SupervisorTest, ReadinessOfAnEarlierPidDoesNotCount) {
  Step();
  supervisor_.OnReady(kBase, Pid(kBase) - 1, now_);
  EXPECT_EQ(Phase(kBase), ProcessPhase::kStarting);
}

TEST_F(SupervisorTest, RestartsAtOnceWhatEndedByItselfAndLeavesItsDependentsUp) {
  StartAll();
  Ended(kNav, kKilled);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start nav"));
  EXPECT_EQ(Phase(kNav), ProcessPhase::kStarting);
  EXPECT_EQ(supervisor_.status(kNav).restarts, 1u);
  EXPECT_EQ(supervisor_.RestartsUsed(kNav, now_), 1);
  EXPECT_EQ(Phase(kApp), ProcessPhase::kReady);
}

TEST_F(SupervisorTest, WaitsBetweenTwoStartsAndLongerEachTime) {
  StartAll();
  Ended(kNav, kKilled);
  launcher_.TakeLog();
  for (const Duration delay : {seconds(5), seconds(10)}) {
    Ready(kNav);
    now_ += seconds(20);
    Ended(kNav, kExit3);
    EXPECT_EQ(Phase(kNav), ProcessPhase::kBackingOff);
    EXPECT_EQ(Message(kNav), "ended with exit status 3");
    EXPECT_EQ(supervisor_.status(kNav).back_off_until, now_ + delay);
    now_ += delay - milliseconds(1);
    Step();
    EXPECT_THAT(launcher_.TakeLog(), ElementsAre());
    now_ += milliseconds(1);
    Step();
    EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start nav"));
  }
}

TEST_F(SupervisorTest, ACrashRightAfterTheStartWaitsForTheFloor) {
  Step();
  now_ += seconds(1);
  Ended(kBase, kExit3);
  EXPECT_EQ(Phase(kBase), ProcessPhase::kBackingOff);
  EXPECT_EQ(supervisor_.status(kBase).back_off_until, seconds(1005));
}

TEST_F(SupervisorTest, WhatEndsBecauseSomethingItNeedsIsDownIsNotToBlame) {
  StartAll();
  supervisor_.OnExit(Pid(kBase), kKilled, now_);
  Ended(kNav, kExit3);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start base"));
  EXPECT_EQ(Message(kNav), "waits for base");
  EXPECT_EQ(supervisor_.RestartsUsed(kNav, now_), 0);
  Ready(kBase);
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start nav"));
}

TEST_F(SupervisorTest, KillsWhatDoesNotEndInTimeExactlyOnce) {
  StartAll();
  Restart("nav");
  now_ += supervisor_.config().stop_timeout - milliseconds(1);
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end nav"));
  now_ += milliseconds(1);
  Step();
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("kill nav"));
  Ended(kNav, kKilled);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start nav"));
}

TEST_F(SupervisorTest, AConfigurationEndsInReverseOrderBeforeItStarts) {
  StartAll();
  EXPECT_TRUE(Configure("charging").ok);
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end app"));
  EXPECT_EQ(supervisor_.configuration(), "charging");
  EXPECT_TRUE(supervisor_.IsChanging());
  Ended(kApp, kExit0);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end nav"));
  Ended(kNav, kExit0);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre());
  EXPECT_EQ(Phase(kDock), ProcessPhase::kReady);
  EXPECT_FALSE(supervisor_.IsChanging());
}

TEST_F(SupervisorTest, AProcessThatWasEndingStartsAgainWhenItIsWantedAgain) {
  StartAll();
  Configure("charging");
  Step();
  Ended(kApp, kExit0);
  Configure("operating");
  Step();
  EXPECT_EQ(Message(kApp), "waits for nav");
  Ended(kNav, kExit0);
  EXPECT_EQ(Phase(kNav), ProcessPhase::kStarting);
  EXPECT_NE(Pid(kNav), 0);
  EXPECT_EQ(supervisor_.status(kNav).restarts, 0u);  // a change of mind is no failure
}

TEST_F(SupervisorTest, AProcessThatIsNotReadyInTimeHasFailed) {
  Step();
  now_ += seconds(20);
  Step();
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start base", "end base"));
  EXPECT_EQ(Message(kBase), "was not ready within 20 s");
  Ended(kBase, kExit0);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start base"));
  EXPECT_EQ(supervisor_.RestartsUsed(kBase, now_), 1);
}

TEST_F(SupervisorTest, AProgramThatCannotRunIsReportedAndTriedAgainLater) {
  launcher_.broken = "base";
  Step();
  Step();
  EXPECT_EQ(Phase(kBase), ProcessPhase::kBackingOff);
  EXPECT_EQ(Message(kBase), "cannot run it");
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start base"));
  launcher_.broken.clear();
  now_ += seconds(5);
  Step();
  EXPECT_NE(Pid(kBase), 0);
}

TEST_F(SupervisorTest, StopAllEndsInReverseOrder) {
  StartAll();
  supervisor_.StopAll();
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end app", "end dock"));
  Ended(kDock, kExit0);
  Ended(kApp, kExit0);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end nav"));
  Ended(kNav, kKilled);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end base"));
  EXPECT_FALSE(supervisor_.AllStopped(now_));
  EXPECT_FALSE(Restart("base").ok);
  Ended(kBase, kExit0);
  EXPECT_TRUE(supervisor_.AllStopped(now_));
  EXPECT_EQ(Phase(kBase), ProcessPhase::kStopped);
}

TEST_F(SupervisorTest, WhatCannotEvenBeKilledDoesNotHoldUpTheOthersForEver) {
  StartAll();
  Configure("charging");
  Step();
  now_ += seconds(3);
  Step();  // app is killed, and stays
  Configure("operating");
  Ended(kNav, kKilled);
  EXPECT_NE(Pid(kNav), 0);
}

TEST_F(SupervisorTest, TheRevisionGrowsOnlyWithChanges) {
  Step();
  const auto revision = supervisor_.revision();
  Step();
  EXPECT_EQ(supervisor_.revision(), revision);
  Ready(kBase);
  EXPECT_GT(supervisor_.revision(), revision);
}

TEST_F(SupervisorTest, TheEndOfTheMasterRestartsTheWholeStackOnce) {
  StartAll();
  supervisor_.OnMasterEnded(now_);
  EXPECT_FALSE(supervisor_.NeedsNewStack(now_));
  Step();
  Ended(kApp, kExit0);
  Ended(kDock, kExit0);
  Ended(kNav, kExit0);
  Ended(kBase, kExit0);
  EXPECT_TRUE(supervisor_.NeedsNewStack(now_));
  EXPECT_TRUE(supervisor_.Remember().new_stack);
  EXPECT_EQ(supervisor_.stack_reason(), "the ROS master ended");
}

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
  EXPECT_TRUE(Restart("nav").ok);
  EXPECT_NE(Pid(kNav), 0);
  Ended(kNav, kExit0);
  Configure("charging");
  Step();
  Ended(kApp, kExit0);
  Configure("operating");
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
  EXPECT_TRUE(Restart("abc").ok);
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
  Configure("charging");
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
}  // namespace coppice::robot
