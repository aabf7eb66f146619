#include "robot_app/processes/escalation.h"

#include <gtest/gtest.h>

#include "tests/robot_app/processes/simulated_machine.h"

namespace coppice::robot::processes {
namespace {

using std::chrono::seconds;

// root <- middle <- leaf; other. `other` is not essential.
RobotConfig FourGroups() {
  RobotConfig config;
  config.processes = {MakeProcess("root"), MakeProcess("middle", {0}), MakeProcess("leaf", {1}),
                      MakeProcess("other")};
  AddOwnGroups(config);
  config.groups[3].essential = false;
  config.configurations = {{"all", {0, 1, 2, 3}, {}}};
  return config;
}

class EscalationTest : public testing::Test {
 protected:
  static constexpr std::size_t kRoot = 0, kMiddle = 1, kLeaf = 2, kOther = 3;

  EscalationStep Fail(std::size_t group) {
    now_ += seconds(10);
    last_ = escalation_.OnFailure(group, cause_, now_);
    return last_.step;
  }
  void UseUp(std::size_t group) {
    for (int i = 0; i < 3; ++i) EXPECT_EQ(Fail(group), EscalationStep::kGroup);
  }
  void BeHealthy(std::size_t group) {
    escalation_.SetReady(group, true, now_);
    now_ += seconds(60);
    escalation_.SetReady(group, true, now_);
    escalation_.SetReady(group, false, now_);
  }

  const RobotConfig config_ = FourGroups();
  const GroupOrder order_{config_};
  Escalation escalation_{config_, order_};
  Cause cause_ = Cause::kEnd;
  Decision last_;
  Time now_{seconds(1000)};
};

TEST_F(EscalationTest, ClimbsOneStepWithEachFailureAfterTheBudgetIsUsedUp) {
  UseUp(kRoot);
  EXPECT_EQ(Fail(kRoot), EscalationStep::kClosure);
  EXPECT_EQ(Fail(kRoot), EscalationStep::kStack);
  EXPECT_EQ(Fail(kRoot), EscalationStep::kPerson);
  EXPECT_EQ(last_.reason, "failed again after a restart of the stack");
}

TEST_F(EscalationTest, ARequestNeverBringsDownTheWholeRobot) {
  cause_ = Cause::kRequest;
  UseUp(kRoot);
  EXPECT_EQ(Fail(kRoot), EscalationStep::kClosure);
  for (int i = 0; i < 10; ++i) {
    Fail(kRoot);
    EXPECT_TRUE(last_.refused);
    EXPECT_EQ(escalation_.step(kRoot), EscalationStep::kClosure);
  }
  cause_ = Cause::kEnd;  // but when it really ends ...
  EXPECT_EQ(Fail(kRoot), EscalationStep::kStack);
}

TEST_F(EscalationTest, TheRootOfTheTroubleIsTheFirstThatFailed) {
  Fail(kRoot);
  UseUp(kLeaf);
  EXPECT_EQ(Fail(kLeaf), EscalationStep::kClosure);
  EXPECT_EQ(last_.root, kRoot);
  EXPECT_EQ(escalation_.step(kRoot), EscalationStep::kClosure);
  EXPECT_EQ(escalation_.step(kMiddle), EscalationStep::kGroup);  // had no trouble
  EXPECT_EQ(Fail(kRoot), EscalationStep::kStack);
}

TEST_F(EscalationTest, AHealthyDependencyIsNotTheRoot) {
  Fail(kRoot);
  BeHealthy(kRoot);
  UseUp(kLeaf);
  Fail(kLeaf);
  EXPECT_EQ(last_.root, kLeaf);
}

TEST_F(EscalationTest, GoodHealthLeadsBackToTheFirstStep) {
  UseUp(kRoot);
  Fail(kRoot);
  EXPECT_EQ(escalation_.step(kRoot), EscalationStep::kClosure);
  BeHealthy(kRoot);
  EXPECT_EQ(escalation_.step(kRoot), EscalationStep::kGroup);
  EXPECT_EQ(Fail(kRoot), EscalationStep::kGroup);
  EXPECT_EQ(last_.delay, Duration::zero());
}

TEST_F(EscalationTest, TheStackIsNotRestartedForWhatNobodyNeeds) {
  UseUp(kOther);
  EXPECT_EQ(Fail(kOther), EscalationStep::kClosure);
  EXPECT_EQ(Fail(kOther), EscalationStep::kPerson);
}

TEST_F(EscalationTest, TheStackIsRestartedOnceForAllGroupsTogether) {
  UseUp(kRoot);
  Fail(kRoot);
  EXPECT_EQ(Fail(kRoot), EscalationStep::kStack);
  BeHealthy(kRoot);
  UseUp(kLeaf);
  EXPECT_EQ(Fail(kLeaf), EscalationStep::kClosure);
  EXPECT_EQ(Fail(kLeaf), EscalationStep::kPerson);
}

TEST_F(EscalationTest, HowEverSlowTheFailuresAreAPersonIsAskedInTime) {
  Fail(kRoot);
  EXPECT_FALSE(escalation_.IsOverdue(kRoot, now_ + seconds(539)));
  EXPECT_TRUE(escalation_.IsOverdue(kRoot, now_ + seconds(540)));
  now_ += seconds(540);
  EXPECT_EQ(Fail(kRoot), EscalationStep::kPerson);
}

TEST_F(EscalationTest, TimeSpentWaitingForOthersIsExcused) {
  Fail(kLeaf);
  escalation_.Excuse(kLeaf, now_ + seconds(500));
  EXPECT_FALSE(escalation_.IsOverdue(kLeaf, now_ + seconds(600)));
}

TEST_F(EscalationTest, IsGivenUpUntilReset) {
  escalation_.GiveUp(kRoot, "it is broken");
  EXPECT_TRUE(escalation_.IsGivenUp(kRoot));
  EXPECT_TRUE(escalation_.AnyGivenUp());
  EXPECT_EQ(escalation_.given_up(kRoot), "it is broken");
  BeHealthy(kRoot);
  EXPECT_TRUE(escalation_.IsGivenUp(kRoot));
  escalation_.Reset(kRoot);
  EXPECT_FALSE(escalation_.AnyGivenUp());
  EXPECT_EQ(Fail(kRoot), EscalationStep::kGroup);
}

TEST_F(EscalationTest, AnotherOneTakesUpWhereThisOneWas) {
  UseUp(kRoot);
  Fail(kRoot);
  Escalation other(config_, order_);
  other.Restore(kRoot, escalation_.Remember(kRoot));
  EXPECT_EQ(other.OnFailure(kRoot, Cause::kEnd, now_).step, EscalationStep::kStack);
}

}  // namespace
}  // namespace coppice::robot::processes
