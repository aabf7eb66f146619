#include "robot_app/supervision/robot_config.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/robot_app/supervision/temporary.h"

namespace coppice::robot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class RobotConfigTest : public testing::Test {
 protected:
  RobotConfig Read(const std::string& text, const Variables& variables = {}) {
    const std::string path = Temporary("robot_config_test.yaml");
    std::ofstream(path) << text;
    return LoadRobotConfig(path, variables, diagnostics_);
  }
  std::string Errors() const { return diagnostics_.ToString(); }
  Diagnostics diagnostics_;
};

TEST_F(RobotConfigTest, ReadsProcessesAndConfigurations) {
  const RobotConfig config = Read(R"(
restart_intensity: {restarts: 5, window: 30}
stop_timeout: 1.5
parameters: {use_sim_time: true}
processes:
  - {name: a, command: ["${bin}/a", "x=${x:-1}"], node: /a, ready: topic /clock}
  - {name: b, command: [b], depends: [a], restart: always, start_timeout: 7, log: other.log}
  - {name: c, command: [c], node: /c, after: [b], restart: on_failure}
initial: second
configurations:
  first: [a]
  second: [a, b, c]
)",
                                  {{"bin", "/opt"}});
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(config.intensity.restarts, 5);
  EXPECT_EQ(config.intensity.window, std::chrono::seconds(30));
  EXPECT_EQ(config.stop_timeout, std::chrono::milliseconds(1500));
  EXPECT_EQ(config.parameters.at("use_sim_time"), "true");
  ASSERT_EQ(config.processes.size(), 3u);
  EXPECT_THAT(config.processes[0].command, ElementsAre("/opt/a", "x=1"));
  EXPECT_EQ(config.processes[0].ready, Readiness::kTopic);
  EXPECT_EQ(config.processes[0].ready_topic, "/clock");
  EXPECT_EQ(config.processes[0].log, "a.log");
  EXPECT_EQ(config.processes[1].ready, Readiness::kNone);  // it has no node
  EXPECT_EQ(config.processes[1].restart, RestartRule::kAlways);
  EXPECT_EQ(config.processes[1].start_timeout, std::chrono::seconds(7));
  EXPECT_EQ(config.processes[1].log, "other.log");
  EXPECT_THAT(config.processes[1].depends, ElementsAre(0u));
  EXPECT_EQ(config.processes[2].ready, Readiness::kNode);
  EXPECT_THAT(config.processes[2].after, ElementsAre(1u));
  EXPECT_EQ(config.configurations[config.initial].name, "second");
  EXPECT_THAT(config.configurations[1].processes, ElementsAre(0u, 1u, 2u));
}

TEST_F(RobotConfigTest, VariablesMayStandInDefaults) {
  const RobotConfig config = Read(
      "processes: [{name: a, command: ['${floor:-${config}/x}', '${rounds:--1}']}]\n"
      "configurations: {all: [a]}\n",
      {{"config", "/etc"}});
  EXPECT_EQ(Errors(), "");
  EXPECT_THAT(config.processes[0].command, ElementsAre("/etc/x", "-1"));
}

TEST_F(RobotConfigTest, ReportsEverythingAtOnceWithPlaceAndHint) {
  Read(
      "processes:\n"
      "  - {name: planner, command: ['${speeed}'], nod: /a}\n"
      "  - {name: planner, command: [x], depends: [planer]}\n"
      "  - {name: mapper, command: [], node: mapper, ready: nodes}\n"
      "configurations: {all: [planner, maper]}\n"
      "initial: al\n",
      {{"speed", "1"}});
  EXPECT_THAT(Errors(), HasSubstr("test.yaml:2:31: error: variable \"speeed\" has no value (did "
                                  "you mean \"speed\"?)"));
  EXPECT_THAT(Errors(), HasSubstr("unknown key \"nod\" (did you mean \"node\"?)"));
  EXPECT_THAT(Errors(), HasSubstr("test.yaml:3:12: error: duplicate process \"planner\""));
  EXPECT_THAT(Errors(), HasSubstr("unknown process \"planer\" (did you mean \"planner\"?)"));
  EXPECT_THAT(Errors(), HasSubstr("\"command\" is missing"));
  EXPECT_THAT(Errors(), HasSubstr("expected a ROS name with slash, got \"mapper\""));
  EXPECT_THAT(Errors(), HasSubstr("\"nodes\" is none of node, none, topic /NAME"));
  EXPECT_THAT(Errors(), HasSubstr("unknown process \"maper\" (did you mean \"mapper\"?)"));
  EXPECT_THAT(Errors(), HasSubstr("unknown configuration \"al\" (did you mean \"all\"?)"));
}

TEST_F(RobotConfigTest, FindsProcessesThatWaitForThemselves) {
  Read(
      "processes:\n"
      "  - {name: a, command: [x], depends: [b]}\n"
      "  - {name: b, command: [x], after: [c]}\n"
      "  - {name: c, command: [x], depends: [a]}\n"
      "  - {name: d, command: [x], depends: [a]}\n"
      "configurations: {all: [a, b, c, d]}\n");
  EXPECT_THAT(Errors(), HasSubstr(":2:5: error: process \"a\" waits for itself"));
  EXPECT_EQ(diagnostics_.all().size(), 3u);  // d waits for them, but not for itself
}

TEST_F(RobotConfigTest, AConfigurationMustHoldWhatItsProcessesDependOn) {
  Read(
      "processes:\n"
      "  - {name: a, command: [x]}\n"
      "  - {name: b, command: [x], depends: [a]}\n"
      "  - {name: c, command: [x], after: [a]}\n"
      "configurations: {all: [b, c]}\n");
  EXPECT_THAT(Errors(), HasSubstr("has \"b\" but not \"a\", which it depends on"));
  EXPECT_EQ(diagnostics_.all().size(), 1u);
}

TEST_F(RobotConfigTest, TheShippedFileIsRight) {
  const RobotConfig config =
      LoadRobotConfig(std::string(COPPICE_SOURCE_DIR) + "/robot_app/config/robot.yaml",
                      {{"bin", "/b"}, {"config", "/c"}, {"record", "/r"}}, diagnostics_);
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(config.configurations[config.initial].name, "operating");
}

}  // namespace
}  // namespace coppice::robot
