#include "robot_app/processes/supervisor.h"

#include "tests/robot_app/processes/supervisor_fixture.h"

namespace coppice::robot::processes {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ElementsAre;

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
  EXPECT_EQ(supervisor_.status(kBase).back_off_until, Time(seconds(1005)));
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
  EXPECT_TRUE(Restart("nav"));
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
  EXPECT_TRUE(Configure("charging"));
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
  EXPECT_TRUE(Configure("charging"));
  Step();
  Ended(kApp, kExit0);
  EXPECT_TRUE(Configure("operating"));
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
  EXPECT_FALSE(Restart("base"));
  Ended(kBase, kExit0);
  EXPECT_TRUE(supervisor_.AllStopped(now_));
  EXPECT_EQ(Phase(kBase), ProcessPhase::kStopped);
}

TEST_F(SupervisorTest, WhatCannotEvenBeKilledDoesNotHoldUpTheOthersForEver) {
  StartAll();
  EXPECT_TRUE(Configure("charging"));
  Step();
  now_ += seconds(3);
  Step();  // app is killed, and stays
  EXPECT_TRUE(Configure("operating"));
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
  EXPECT_FALSE(supervisor_.Remember().clear_stack) << "no program has failed";
  EXPECT_EQ(supervisor_.stack_reason(), "the ROS master ended");
}

// nav must show that it works.
class HeartbeatTest : public SupervisorTest {
 protected:
  HeartbeatTest() : SupervisorTest(WithHeartbeat()) { StartAll(); }

  static RobotConfig WithHeartbeat() {
    RobotConfig config = FourProcesses();
    config.processes[kNav].heartbeat = HeartbeatConfig{"/beat", seconds(5)};
    return config;
  }

  // In steps as short as those of the program.
  void StepFor(Duration duration) {
    for (const Time end = now_ + duration; now_ < end;) {
      now_ += milliseconds(20);
      Step();
    }
  }
};

TEST_F(HeartbeatTest, SilentForLongerThanItMayItIsRestarted) {
  StepFor(seconds(2));
  supervisor_.OnHeartbeat(kNav, now_);
  StepFor(seconds(5));
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre());
  StepFor(milliseconds(40));
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end nav"));
  EXPECT_EQ(Message(kNav), "gave no sign of life for 5 s");
  Ended(kNav, kExit0);
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("start nav"));
  EXPECT_EQ(supervisor_.RestartsUsed(kNav, now_), 1);
}

TEST_F(HeartbeatTest, BeforeItIsReadyNothingIsExpectedOfIt) {
  Ended(kNav, kKilled);
  launcher_.TakeLog();
  StepFor(seconds(6));
  Ready(kNav);
  StepFor(seconds(5));
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre());
}

TEST_F(HeartbeatTest, WhatTheSupervisorMissedWhileItStoodStillItselfCountsForNothing) {
  StepFor(seconds(2));
  now_ += seconds(60);
  StepFor(seconds(5));
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre());
  StepFor(milliseconds(100));
  EXPECT_THAT(launcher_.TakeLog(), ElementsAre("end nav"));
}

}  // namespace
}  // namespace coppice::robot::processes
