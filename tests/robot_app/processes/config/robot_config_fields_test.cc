#include "robot_app/processes/config/robot_config_fields.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/robot_app/processes/temporary.h"

namespace coppice::robot::processes {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;

class RobotConfigFieldsTest : public testing::Test {
 protected:
  YamlFields Fields(const std::string& text) {
    const std::string path = Temporary("robot_config_fields_test.yaml");
    std::ofstream(path) << text;
    return YamlFields::Load(path, diagnostics_);
  }
  Diagnostics diagnostics_;
};

TEST_F(RobotConfigFieldsTest, LimitsThatAreNotGivenAreTheDefaultsOfTheFile) {
  RestartLimits defaults;
  defaults.restarts = 7;
  const RestartLimits limits = ReadRestartLimits(Fields("{window: 30, floor: 0.5}"), defaults);
  EXPECT_EQ(limits.restarts, 7);
  EXPECT_EQ(limits.window, seconds(30));
  EXPECT_EQ(limits.floor, std::chrono::milliseconds(500));
  EXPECT_EQ(diagnostics_.ToString(), "");
}

TEST_F(RobotConfigFieldsTest, UnknownKeysAndValuesOutOfRangeAreErrors) {
  ReadRestartLimits(Fields("{restart: 3, window: 0}"), {});
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("unknown key \"restart\""));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("window"));
}

TEST_F(RobotConfigFieldsTest, KnowsStrategiesAndRulesByTheirNames) {
  YamlFields group = Fields("{strategy: one_for_all, restart: never}");
  EXPECT_EQ(ReadStrategy(group), Strategy::kOneForAll);
  EXPECT_EQ(ReadRestartRule(group), RestartRule::kNever);
  YamlFields wrong = Fields("{strategy: one_for_al, restart: by_tree}");
  ReadStrategy(wrong);
  ReadRestartRule(wrong);
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("one_for_all"));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("by_tree"));
}

TEST_F(RobotConfigFieldsTest, AHeartbeatMayBeSilentForItsTimeout) {
  const HeartbeatConfig heartbeat = ReadHeartbeat(Fields("{topic: /beat, timeout: 2}"));
  EXPECT_EQ(heartbeat.topic, "/beat");
  EXPECT_EQ(heartbeat.timeout, seconds(2));
  EXPECT_EQ(diagnostics_.ToString(), "");
}

TEST_F(RobotConfigFieldsTest, AHeartbeatNeedsATopicWithSlash) {
  ReadHeartbeat(Fields("{topic: beat}"));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("expected a ROS name with slash, got \"beat\""));
}

TEST_F(RobotConfigFieldsTest, NamesThatEndAProgramOfRosAreRefused) {
  ReadHeartbeat(Fields("{topic: '/{beat}'}"));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("\"topic\": expected a ROS name with slash"));
  ReadCondition({"charging", {}}, Fields("{topic: /battery state}"));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("got \"/battery state\""));
  ProcessConfig process;
  process.node = "/node";
  YamlFields fields = Fields("{ready: topic /a b}");
  ReadReadiness(fields, process);
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("\"topic /a b\" is none of"));
}

TEST_F(RobotConfigFieldsTest, AHostNeedsACommandAndItsProgramsFolder) {
  ReadHost({"jetson", {}}, Fields("{shell: no}"));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("\"command\" is missing"));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("\"bin\" is missing"));
}

TEST_F(RobotConfigFieldsTest, ReadinessNeedsANodeToAsk) {
  ProcessConfig process;
  YamlFields fields = Fields("ready: topic /x");
  ReadReadiness(fields, process);
  EXPECT_EQ(process.ready_name, "/x");
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("topic /x needs \"node\""));
}

}  // namespace
}  // namespace coppice::robot::processes
