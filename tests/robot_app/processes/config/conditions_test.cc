#include "robot_app/processes/config/conditions.h"

#include <gtest/gtest.h>

namespace coppice::robot::processes {
namespace {

using std::chrono::seconds;

ConditionConfig Charging() {
  ConditionConfig config;
  config.name = "charging_confirmed";
  config.topic = "/battery_state";
  config.current = 0.5;
  config.lasting = seconds(5);
  config.staleness = seconds(3);
  return config;
}

TEST(ConditionTest, DoesNotHoldBeforeAnythingWasHeard) {
  EXPECT_EQ(TopicCondition(Charging()).Check(Time(seconds(100))).problem(),
            "nothing was heard on /battery_state");
}

TEST(ConditionTest, ACurrentMustFlowForSomeTime) {
  TopicCondition condition(Charging());
  for (int t = 0; t < 5; ++t) {
    condition.Observe(0.5, Time(seconds(t)));
    EXPECT_EQ(condition.Check(Time(seconds(t))).problem(),
              "true for " + std::to_string(t) + " s only, it must last 5 s");
  }
  condition.Observe(0.5, Time(seconds(5)));
  EXPECT_EQ(condition.Check(Time(seconds(5))).problem(), "");
}

TEST(ConditionTest, ContactWithoutCurrentIsNoCharging) {
  TopicCondition condition(Charging());
  for (int t = 0; t < 10; ++t) condition.Observe(0.1, Time(seconds(t)));
  EXPECT_EQ(condition.Check(Time(seconds(9))).problem(), "only 0.1 A flow, 0.5 A are needed");
}

TEST(ConditionTest, AnInterruptionBeginsTheTimeAnew) {
  TopicCondition condition(Charging());
  for (int t = 0; t < 8; ++t) condition.Observe(t == 6 ? 0 : 1, Time(seconds(t)));
  EXPECT_EQ(condition.Check(Time(seconds(7))).problem(), "true for 0 s only, it must last 5 s");
}

TEST(ConditionTest, SilenceIsNoConfirmationNorDoesItLast) {
  TopicCondition condition(Charging());
  condition.Observe(1, Time(seconds(0)));
  EXPECT_EQ(condition.Check(Time(seconds(4))).problem(), "/battery_state is silent for 4 s");
  condition.Observe(1, Time(seconds(10)));
  EXPECT_EQ(condition.Check(Time(seconds(10))).problem(), "true for 0 s only, it must last 5 s");
}

TEST(ConditionTest, AFlagIsTrueOrFalse) {
  ConditionConfig config = Charging();
  config.current.reset();
  config.lasting = seconds(0);
  TopicCondition condition(config);
  condition.Observe(0, Time(seconds(1)));
  EXPECT_EQ(condition.Check(Time(seconds(1))).problem(), "/battery_state says no");
  condition.Observe(1, Time(seconds(1)));
  EXPECT_EQ(condition.Check(Time(seconds(1))).problem(), "");
}

}  // namespace
}  // namespace coppice::robot::processes
