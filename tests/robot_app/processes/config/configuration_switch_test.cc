#include "robot_app/processes/config/configuration_switch.h"

#include <gtest/gtest.h>

namespace coppice::robot::processes {
namespace {

class ConfigurationSwitchTest : public testing::Test {
 protected:
  static RobotConfig Config() {
    RobotConfig config;
    config.configurations = {{"operating", {}, {}}, {"charging", {}, {0}}, {"safe", {}, {}}};
    config.conditions.resize(1);
    config.conditions[0].name = "confirmed";
    config.given_up.configuration = 2;
    return config;
  }
  Expected<std::string> Ask(const std::string& name, Hand hand = Hand::kTree) {
    return switch_.Request(name, hand, [this](std::size_t) { return holds_; });
  }

  const RobotConfig config_ = Config();
  ConfigurationSwitch switch_{config_};
  Outcome holds_;
};

TEST_F(ConfigurationSwitchTest, TheTreesMayChangeWhatNobodyHolds) {
  EXPECT_EQ(switch_.current(), 0u);
  EXPECT_EQ(Ask("charging").value(), "changing to configuration charging");
  EXPECT_EQ(switch_.current(), 1u);
  EXPECT_EQ(Ask("charging").value(), "configuration charging is already in force");
}

TEST_F(ConfigurationSwitchTest, AConditionThatDoesNotHoldRefusesEveryHand) {
  holds_ = Problem{"no current"};
  for (const Hand hand : {Hand::kTree, Hand::kPerson}) {
    const Expected<std::string> verdict = Ask("charging", hand);
    EXPECT_FALSE(verdict);
    EXPECT_EQ(verdict.problem(), "configuration charging requires confirmed: no current");
  }
  EXPECT_FALSE(switch_.manual());
}

TEST_F(ConfigurationSwitchTest, AConditionCountsWhenItIsEnteredNotWhileItIsInForce) {
  EXPECT_TRUE(Ask("charging"));
  holds_ = Problem{"no current"};
  EXPECT_TRUE(Ask("charging"));
}

TEST_F(ConfigurationSwitchTest, AConfigurationThatIsHeldByHandIsLeftByHandOnly) {
  EXPECT_TRUE(Ask("operating", Hand::kPerson));
  EXPECT_TRUE(switch_.manual());
  EXPECT_FALSE(Ask("charging"));
  EXPECT_TRUE(Ask("charging", Hand::kPerson));
  EXPECT_EQ(switch_.Release(), "the trees decide about the configuration again");
  EXPECT_TRUE(Ask("operating"));
  EXPECT_EQ(switch_.Release(), "no configuration is held by hand");
}

TEST_F(ConfigurationSwitchTest, ASafeStopIsStrongerThanAnyHandAndEndsWhereItBegan) {
  EXPECT_TRUE(Ask("charging"));
  switch_.SafeStop();
  switch_.SafeStop();
  EXPECT_EQ(switch_.current(), 2u);
  EXPECT_FALSE(Ask("operating", Hand::kPerson));
  EXPECT_EQ(switch_.before_safe_stop(), 1u);
  switch_.EndSafeStop();
  EXPECT_EQ(switch_.current(), 1u);
  switch_.EndSafeStop();
  EXPECT_EQ(switch_.current(), 1u);
}

TEST_F(ConfigurationSwitchTest, TakesUpWhatWasLeft) {
  switch_.Restore(1, true, true);
  EXPECT_EQ(switch_.current(), 2u);
  EXPECT_TRUE(switch_.manual());
  switch_.EndSafeStop();
  EXPECT_EQ(switch_.current(), 1u);
}

}  // namespace
}  // namespace coppice::robot::processes
