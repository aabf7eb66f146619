#include "robot_app/processes/restart_budget.h"

#include <gmock/gmock.h>

namespace coppice::robot::processes {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;
using testing::HasSubstr;

TEST(RestartBudgetTest, AllowsSoManyRestartsAndSaysWhyNotOneMore) {
  RestartBudget budget({});
  Time now{seconds(1000)};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(budget.Check(now).problem(), "");
    budget.Add(now += seconds(10));
  }
  EXPECT_EQ(budget.Check(now).problem(),
            "restarted 3 times without being healthy for 60 s in between");
}

TEST(RestartBudgetTest, TimeAloneForgetsNothing) {
  RestartBudget budget({});
  budget.Add(Time(seconds(1000)));
  EXPECT_EQ(budget.Used(Time(seconds(3000))), 1);
}

TEST(RestartBudgetTest, HealthForgetsWhatIsOlderThanTheWindow) {
  RestartBudget budget({});
  budget.Add(Time(seconds(1000)));
  budget.SetReady(true, Time(seconds(1002)));
  EXPECT_FALSE(budget.IsHealthy(Time(seconds(1061))));
  EXPECT_EQ(budget.Used(Time(seconds(1061))), 1);
  EXPECT_TRUE(budget.IsHealthy(Time(seconds(1062))));
  EXPECT_EQ(budget.Used(Time(seconds(1062))), 0);
}

TEST(RestartBudgetTest, AShortHealthDoesNotForgetTheWindow) {
  RestartLimits limits;
  limits.healthy_after = seconds(5);
  RestartBudget budget(limits);
  budget.Add(Time(seconds(1000)));
  budget.SetReady(true, Time(seconds(1002)));
  EXPECT_TRUE(budget.IsHealthy(Time(seconds(1010))));
  EXPECT_EQ(budget.Used(Time(seconds(1059))), 1);
  EXPECT_EQ(budget.Used(Time(seconds(1060))), 0);
}

TEST(RestartBudgetTest, APauseInReadinessBeginsTheTimeOfHealthAnew) {
  RestartBudget budget({});
  budget.Add(Time(seconds(1000)));
  budget.SetReady(true, Time(seconds(1002)));
  budget.SetReady(false, Time(seconds(1050)));
  budget.SetReady(true, Time(seconds(1051)));
  EXPECT_EQ(budget.Used(Time(seconds(1100))), 1);
  EXPECT_EQ(budget.Used(Time(seconds(1111))), 0);
}

TEST(RestartBudgetTest, HealthUntilTheNextFailureCounts) {
  RestartBudget budget({});
  budget.Add(Time(seconds(1000)));
  budget.SetReady(true, Time(seconds(1002)));
  budget.SetReady(false, Time(seconds(1100)));
  EXPECT_EQ(budget.Used(Time(seconds(1100))), 0);
}

TEST(RestartBudgetTest, WaitsLongerEachTime) {
  RestartLimits limits;
  limits.restarts = 100;
  RestartBudget budget(limits);
  const BackOff back_off;
  Time now{seconds(1000)};
  for (const int expected : {0, 5, 10, 20, 40, 80, 160, 300, 300}) {
    EXPECT_EQ(budget.Delay(back_off, now), seconds(expected));
    budget.Add(now);
  }
}

TEST(RestartBudgetTest, TheHourlyLimitHoldsInGoodHealthToo) {
  RestartBudget budget({});
  Time now{seconds(10000)};
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(budget.Check(now).problem(), "");
    budget.Add(now);
    budget.SetReady(true, now);
    now += minutes(2);
    budget.SetReady(false, now);
  }
  EXPECT_EQ(budget.Used(now), 0);
  EXPECT_THAT(budget.Check(now).problem(), HasSubstr("restarted 10 times within an hour"));
  EXPECT_EQ(budget.Check(Time(seconds(10000) + minutes(60))).problem(), "");
}

TEST(RestartBudgetTest, WhatIsRestoredCountsAsBefore) {
  RestartBudget budget({});
  Time now{seconds(1000)};
  budget.Add(now);
  budget.SetReady(true, now);
  now += seconds(100);
  budget.SetReady(false, now);
  budget.Add(now);
  RestartBudget restored({});
  restored.Restore(budget.times(), budget.counting());
  EXPECT_EQ(restored.Used(now), 1);
  EXPECT_EQ(restored.times().size(), 2u);
  restored.Clear();
  EXPECT_EQ(restored.Used(now), 0);
}

}  // namespace
}  // namespace coppice::robot::processes
