#include "robot_app/supervision/supervisor.h"

#include <gmock/gmock.h>

#include <csignal>
#include <map>

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

  std::vector<std::string> TakeLog() { return std::exchange(log, {}); }

  std::vector<std::string> log;
  std::map<int, std::string> names;
  std::string broken;
  int last_pid = 100;
};

ProcessConfig Process(const std::string& name, std::vector<std::size_t> depends = {}) {
  ProcessConfig process;
  process.name = name;
  process.command = {name};
  process.node = "/" + name + "_node";
  process.depends = std::move(depends);
  return process;
}

// base <- nav <- app; base <- dock. "operating" has all, "charging" has base and dock.
RobotConfig FourProcesses() {
  RobotConfig config;
  config.processes = {Process("base"), Process("nav", {0}), Process("app", {1}),
                      Process("dock", {0})};
  config.configurations = {{"operating", {0, 1, 2, 3}}, {"charging", {0, 3}}};
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
  // Ends a process as Restart asked it to, and lets it become ready again.
  void ComeBack(std::size_t process) {
    Ended(process, kExit0);
    Ready(process);
  }
  void StartAll() {
    for (int i = 0; i < 3; ++i) {
      Step();
      for (std::size_t process = 0; process < 4; ++process) Ready(process);
    }
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
  Ready(kBase);
  EXPECT_EQ(Phase(kBase), ProcessPhase::kReady);
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start nav", "start dock"));
  Ready(kNav);
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start app"));
}

TEST_F(SupervisorTest, ReadinessOfAnEarlierPidDoesNotCount) {
  Step();
  supervisor_.OnReady(kBase, Pid(kBase) - 1, now_);
  EXPECT_EQ(Phase(kBase), ProcessPhase::kStarting);
}

TEST_F(SupervisorTest, OnlyReportsAnUnexpectedEndWhenTheTreeDecides) {
  StartAll();
  Ended(kNav, kKilled);
  EXPECT_EQ(Phase(kNav), ProcessPhase::kStopped);
  EXPECT_EQ(Message(kNav), "ended by signal 9");
  EXPECT_EQ(Pid(kNav), 0);
  now_ += seconds(100);
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre());
  EXPECT_EQ(Phase(kApp), ProcessPhase::kReady);  // a dependent stays up
}

TEST_F(SupervisorTest, StartsADeadProcessOnRequestByItsNodeName) {
  StartAll();
  Ended(kNav, kExit3);
  EXPECT_EQ(Message(kNav), "ended with exit status 3");
  EXPECT_TRUE(Restart("/nav_node").ok);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start nav"));
  EXPECT_EQ(Phase(kNav), ProcessPhase::kStarting);
  EXPECT_EQ(supervisor_.status(kNav).restarts, 1u);
}

TEST_F(SupervisorTest, EndsALivingProcessBeforeItStartsItAgain) {
  StartAll();
  EXPECT_TRUE(Restart("nav").ok);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end nav"));
  EXPECT_EQ(Phase(kNav), ProcessPhase::kStarting);  // grace begins with the request
  EXPECT_TRUE(Restart("nav").ok);                   // under way already: not counted
  Ended(kNav, kExit0);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start nav"));
  EXPECT_EQ(supervisor_.status(kNav).restarts, 1u);
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

TEST_F(SupervisorTest, RefusesOneRestartTooManyAndGivesUp) {
  StartAll();
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(Restart("nav").ok);
    ComeBack(kNav);
  }
  launcher_.TakeLog();
  const Verdict verdict = Restart("nav");
  EXPECT_FALSE(verdict.ok);
  EXPECT_EQ(verdict.message, "nav is given up: restarted 3 times within 60 s");
  EXPECT_EQ(Phase(kNav), ProcessPhase::kGivenUp);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end nav"));
  Ended(kNav, kExit0);
  now_ += seconds(1000);
  Step();
  EXPECT_FALSE(Restart("nav").ok);  // time alone does not repair it
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre());
  EXPECT_EQ(Phase(kNav), ProcessPhase::kGivenUp);
}

TEST_F(SupervisorTest, ARestartLeavesTheWindowExactlyAtItsEnd) {
  StartAll();
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(Restart("nav").ok);
    ComeBack(kNav);
  }
  now_ += seconds(60);
  EXPECT_TRUE(Restart("nav").ok);
}

TEST_F(SupervisorTest, ResetStartsAGivenUpProcessAndForgetsItsRestarts) {
  StartAll();
  for (int i = 0; i < 3; ++i) {
    Restart("nav");
    ComeBack(kNav);
  }
  Restart("nav");
  Ended(kNav, kExit0);
  launcher_.TakeLog();
  EXPECT_TRUE(supervisor_.Reset("nav", now_).ok);
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start nav"));
  Ready(kNav);
  EXPECT_TRUE(Restart("nav").ok);
}

TEST_F(SupervisorTest, RefusesUnknownAndUnwantedProcesses) {
  EXPECT_THAT(Restart("navv").message, HasSubstr("did you mean \"nav\"?"));
  supervisor_.SetConfiguration("charging");
  EXPECT_EQ(Restart("nav").message, "nav is not part of configuration charging");
  EXPECT_THAT(supervisor_.SetConfiguration("chraging").message,
              HasSubstr("did you mean \"charging\"?"));
}

TEST_F(SupervisorTest, AConfigurationEndsInReverseOrderBeforeItStarts) {
  StartAll();
  EXPECT_TRUE(supervisor_.SetConfiguration("charging").ok);
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end app"));
  EXPECT_EQ(supervisor_.configuration(), "charging");
  Ended(kApp, kExit0);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end nav"));
  Ended(kNav, kExit0);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre());
  EXPECT_EQ(Phase(kDock), ProcessPhase::kReady);
}

TEST_F(SupervisorTest, AProcessThatWasEndingStartsAgainWhenItIsWantedAgain) {
  StartAll();
  supervisor_.SetConfiguration("charging");
  Step();
  Ended(kApp, kExit0);
  supervisor_.SetConfiguration("operating");
  Step();
  EXPECT_EQ(Message(kApp), "waits for nav");
  Ended(kNav, kExit0);
  EXPECT_EQ(Phase(kNav), ProcessPhase::kStarting);
  EXPECT_NE(Pid(kNav), 0);
}

TEST_F(SupervisorTest, AProcessThatIsNotReadyInTimeIsEndedAndReported) {
  Step();
  now_ += seconds(20);
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start base", "end base"));
  Ended(kBase, kExit0);
  EXPECT_EQ(Phase(kBase), ProcessPhase::kStopped);
  EXPECT_EQ(Message(kBase), "was not ready within 20 s");
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre());
}

TEST_F(SupervisorTest, AProgramThatCannotRunIsReported) {
  launcher_.broken = "base";
  Step();
  Step();
  EXPECT_EQ(Phase(kBase), ProcessPhase::kStopped);
  EXPECT_EQ(Message(kBase), "cannot run it");
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start base"));
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
  EXPECT_FALSE(supervisor_.AllStopped());
  EXPECT_FALSE(Restart("base").ok);
  Ended(kBase, kExit0);
  EXPECT_TRUE(supervisor_.AllStopped());
  EXPECT_EQ(Phase(kBase), ProcessPhase::kStopped);
}

TEST_F(SupervisorTest, TheRevisionGrowsOnlyWithChanges) {
  Step();
  const auto revision = supervisor_.revision();
  Step();
  EXPECT_EQ(supervisor_.revision(), revision);
  Ready(kBase);
  EXPECT_GT(supervisor_.revision(), revision);
}

RobotConfig OneProcess(RestartRule rule) {
  RobotConfig config;
  config.processes = {Process("robot")};
  config.processes[0].restart = rule;
  config.configurations = {{"all", {0}}};
  return config;
}

class RestartingSupervisorTest : public SupervisorTest {
 protected:
  RestartingSupervisorTest() : SupervisorTest(OneProcess(RestartRule::kAlways)) { Step(); }
};

TEST_F(RestartingSupervisorTest, BacksOffLongerEachTimeAndGivesUp) {
  Ended(0, kExit3);  // the first restart is immediate
  EXPECT_EQ(launcher_.TakeLog().size(), 2u);
  for (const Duration delay : {seconds(1), seconds(2)}) {
    Ended(0, kKilled);
    EXPECT_EQ(Phase(0), ProcessPhase::kBackingOff);
    now_ += delay - milliseconds(1);
    Step();
    EXPECT_THAT(launcher_.TakeLog(), ElementsAre());
    now_ += milliseconds(1);
    Step();
    EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start robot"));
  }
  Ended(0, kKilled);
  EXPECT_EQ(Phase(0), ProcessPhase::kGivenUp);
  EXPECT_EQ(supervisor_.status(0).restarts, 3u);
}

class OnFailureSupervisorTest : public SupervisorTest {
 protected:
  OnFailureSupervisorTest() : SupervisorTest(OneProcess(RestartRule::kOnFailure)) { Step(); }
};

TEST_F(OnFailureSupervisorTest, RestartsAfterAFailureButNotAfterAGoodEnd) {
  Ended(0, kExit3);
  EXPECT_NE(Pid(0), 0);
  Ended(0, kExit0);
  EXPECT_EQ(Phase(0), ProcessPhase::kStopped);
  now_ += seconds(100);
  Step();
  EXPECT_EQ(Pid(0), 0);
}

RobotConfig Ordered() {
  RobotConfig config;
  config.processes = {Process("nav"), Process("robot")};
  config.processes[1].after = {0};
  config.configurations = {{"operating", {0, 1}}, {"charging", {1}}};
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
  Ended(0, kKilled);  // it failed: no reason to wait any longer
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start robot"));
}

TEST_F(OrderedSupervisorTest, StaysUpWhenWhatCameBeforeIsNoLongerNeeded) {
  Step();
  Ready(0);
  Step();
  Ready(1);
  launcher_.TakeLog();
  supervisor_.SetConfiguration("charging");
  Step();
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end nav"));
}

}  // namespace
}  // namespace coppice::robot
