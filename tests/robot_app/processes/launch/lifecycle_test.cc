#include "robot_app/processes/launch/lifecycle.h"

#include <gmock/gmock.h>

#include "tests/robot_app/processes/simulated_machine.h"

namespace coppice::robot::processes {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;

class LifecycleTest : public testing::Test {
 protected:
  static RobotConfig Config() {
    RobotConfig config;
    config.processes = {MakeProcess("one")};
    return config;
  }
  const RobotConfig config_ = Config();
  SimulatedMachine machine_;
  Lifecycle lifecycle_{config_, machine_};
  Time now_{seconds(1000)};
};

TEST_F(LifecycleTest, AStartAwaitsReadinessUntilItsTimeout) {
  EXPECT_EQ(lifecycle_.Launch(0, {}, now_).problem(), "");
  EXPECT_TRUE(lifecycle_.IsUp(0));
  EXPECT_TRUE(lifecycle_.AwaitsReadiness(0));
  EXPECT_FALSE(lifecycle_.IsLate(0, now_ + seconds(19)));
  EXPECT_TRUE(lifecycle_.IsLate(0, now_ + seconds(20)));
  EXPECT_EQ(lifecycle_.started_at(0), now_);
  EXPECT_EQ(lifecycle_.status(0).restarts, 0u);
}

TEST_F(LifecycleTest, ARestartCountsAndMayClearTheStateFirst) {
  Lifecycle::Start start;
  start.counts = start.cleared = true;
  EXPECT_TRUE(lifecycle_.Launch(0, start, now_));
  EXPECT_EQ(lifecycle_.status(0).restarts, 1u);
  EXPECT_THAT(machine_.log, ElementsAre("clear one"));
}

TEST_F(LifecycleTest, AnEndIsKilledWhenItsTimeIsUpAndAtLastNobodyWaits) {
  EXPECT_TRUE(lifecycle_.Launch(0, {}, now_));
  lifecycle_.End(0, ProcessPhase::kStopped, "is ended", now_);
  lifecycle_.End(0, ProcessPhase::kStopped, "is ended", now_);
  EXPECT_FALSE(lifecycle_.AwaitsReadiness(0));
  lifecycle_.KillOverdue(now_ + seconds(2));
  EXPECT_THAT(machine_.log, ElementsAre("end one"));
  lifecycle_.KillOverdue(now_ + seconds(3));
  lifecycle_.KillOverdue(now_ + seconds(4));
  EXPECT_THAT(machine_.log, ElementsAre("end one", "kill one"));
  EXPECT_FALSE(lifecycle_.IsStuck(0, now_ + seconds(5)));
  EXPECT_TRUE(lifecycle_.AnyUp(now_ + seconds(5)));
  EXPECT_TRUE(lifecycle_.IsStuck(0, now_ + seconds(6)));
  EXPECT_FALSE(lifecycle_.AnyUp(now_ + seconds(6)));
}

TEST_F(LifecycleTest, TellsWhetherAnEndWasAskedFor) {
  EXPECT_FALSE(lifecycle_.OnExit(0));
  EXPECT_FALSE(lifecycle_.OnExit(7));
  EXPECT_TRUE(lifecycle_.Launch(0, {}, now_));
  const auto crashed = lifecycle_.OnExit(lifecycle_.status(0).pid);
  ASSERT_TRUE(crashed);
  EXPECT_FALSE(crashed->asked);
  EXPECT_FALSE(lifecycle_.IsUp(0));
}

TEST_F(LifecycleTest, TheTimeOfAPhaseBeginsWithThePhaseNotWithItsMessage) {
  lifecycle_.SetPhase(0, ProcessPhase::kStarting, "waits", now_);
  lifecycle_.SetPhase(0, ProcessPhase::kStarting, "", now_ + seconds(1));
  EXPECT_EQ(lifecycle_.status(0).since, now_);
  const auto revision = lifecycle_.revision();
  lifecycle_.SetPhase(0, ProcessPhase::kStarting, "", now_ + seconds(2));
  EXPECT_EQ(lifecycle_.revision(), revision);
}

}  // namespace
}  // namespace coppice::robot::processes
