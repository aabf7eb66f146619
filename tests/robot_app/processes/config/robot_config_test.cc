#include "robot_app/processes/config/robot_config.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "tests/robot_app/processes/temporary.h"
#include "tests/support/folders.h"

namespace coppice::robot::processes {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

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
stop_timeout: 1.5
parameters: {use_sim_time: true}
processes:
  - {name: a, command: ["${bin}/a", "x=${x:-1}"], node: /a, ready: topic /clock}
  - {name: b, command: [b], depends: [a], restart: never, start_timeout: 7, log: other.log}
  - {name: c, command: [c], node: /c, after: [b], restart: on_failure, ready: service /c/go,
     state: [/var/lib/robot/c]}
initial: second
configurations:
  first: [a]
  second: {processes: [a, b, c]}
)",
                                  {{"bin", "/opt"}});
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(config.stop_timeout, std::chrono::milliseconds(1500));
  EXPECT_EQ(config.parameters.at("use_sim_time"), "true");
  ASSERT_EQ(config.processes.size(), 3u);
  EXPECT_THAT(config.processes[0].command, ElementsAre("/opt/a", "x=1"));
  EXPECT_EQ(config.processes[0].ready, Readiness::kTopic);
  EXPECT_EQ(config.processes[0].ready_name, "/clock");
  EXPECT_EQ(config.processes[0].log, "a.log");
  EXPECT_EQ(config.processes[0].restart, RestartRule::kAlways);
  EXPECT_EQ(config.processes[1].ready, Readiness::kNone);  // it has no node
  EXPECT_EQ(config.processes[1].restart, RestartRule::kNever);
  EXPECT_EQ(config.processes[1].start_timeout, std::chrono::seconds(7));
  EXPECT_EQ(config.processes[1].log, "other.log");
  EXPECT_THAT(config.processes[1].depends, ElementsAre(0u));
  EXPECT_EQ(config.processes[2].ready, Readiness::kService);
  EXPECT_EQ(config.processes[2].ready_name, "/c/go");
  EXPECT_EQ(config.processes[2].restart, RestartRule::kOnFailure);
  EXPECT_THAT(config.processes[2].state, ElementsAre("/var/lib/robot/c"));
  EXPECT_THAT(config.processes[2].after, ElementsAre(1u));
  EXPECT_EQ(config.configurations[config.initial].name, "second");
  EXPECT_THAT(config.configurations[1].processes, ElementsAre(0u, 1u, 2u));
}

TEST_F(RobotConfigTest, ReadsGroupsWithStrategyBudgetAndDependencies) {
  const RobotConfig config = Read(R"(
restart_intensity: {restarts: 5, window: 30}
back_off: {first: 2, most: 20}
escalation: {closure: 2, stack: 0, ask_within: 100}
groups:
  - {name: base}
  - {name: nav, strategy: rest_for_one, depends: [base], essential: no,
     restart_intensity: {restarts: 1, floor: 2, healthy_after: 7, hourly: 9}}
processes:
  - {name: base, command: [x]}
  - {name: map, command: [x], group: nav}
  - {name: plan, command: [x], group: nav}
  - {name: alone, command: [x]}
configurations: {all: [base, map, plan, alone]}
)");
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(config.back_off.first, std::chrono::seconds(2));
  EXPECT_EQ(config.escalation.closure, 2);
  EXPECT_EQ(config.escalation.stack, 0);
  EXPECT_EQ(config.escalation.ask_within, std::chrono::seconds(100));
  ASSERT_EQ(config.groups.size(), 3u);
  EXPECT_THAT(config.groups[0].processes, ElementsAre(0u));  // of the same name
  EXPECT_EQ(config.groups[0].limits.restarts, 5);
  EXPECT_TRUE(config.groups[0].essential);
  const GroupConfig& nav = config.groups[1];
  EXPECT_EQ(nav.strategy, Strategy::kRestForOne);
  EXPECT_FALSE(nav.essential);
  EXPECT_THAT(nav.depends, ElementsAre(0u));
  EXPECT_THAT(nav.processes, ElementsAre(1u, 2u));
  EXPECT_EQ(nav.limits.restarts, 1);
  EXPECT_EQ(nav.limits.window, std::chrono::seconds(30));  // of the file
  EXPECT_EQ(nav.limits.floor, std::chrono::seconds(2));
  EXPECT_EQ(nav.limits.healthy_after, std::chrono::seconds(7));
  EXPECT_EQ(nav.limits.hourly, 9);
  EXPECT_THAT(config.processes[2].after, ElementsAre(1u));  // in its turn
  EXPECT_EQ(config.groups[2].name, "alone");
  EXPECT_THAT(config.groups[2].processes, ElementsAre(3u));
}

TEST_F(RobotConfigTest, ReadsHostsConditionsAndWhatToDoWhenAGroupIsGivenUp) {
  const RobotConfig config = Read(R"(
hosts:
  jetson: {command: [ssh, user@jetson, --], bin: /there, address: 10.0.0.2}
  space: {command: [ip, netns, exec, ns1], bin: /here, shell: no}
conditions:
  charging_confirmed: {topic: /battery_state, current: 0.5, lasting: 5, staleness: 3}
  allowed: {topic: /allowed}
on_given_up: {command: ["${bin}/call", --call], configuration: safe}
switch_off: {command: [touch, "${bin}/off"]}
processes:
  - {name: a, command: ["${bin}/a"], host: space}
initial: safe
configurations:
  safe: [a]
  charging: {processes: [a], requires: [charging_confirmed, allowed]}
)",
                                  {{"bin", "/opt"}});
  EXPECT_EQ(Errors(), "");
  ASSERT_EQ(config.hosts.size(), 2u);
  EXPECT_THAT(config.hosts[0].command, ElementsAre("ssh", "user@jetson", "--"));
  EXPECT_TRUE(config.hosts[0].shell);
  EXPECT_EQ(config.hosts[0].address, "10.0.0.2");
  EXPECT_FALSE(config.hosts[1].shell);
  EXPECT_EQ(config.processes[0].host, 1u);
  EXPECT_THAT(config.processes[0].command, ElementsAre("/here/a"));  // the programs there
  EXPECT_EQ(config.conditions[0].current, 0.5);
  EXPECT_EQ(config.conditions[0].lasting, std::chrono::seconds(5));
  EXPECT_EQ(config.conditions[0].staleness, std::chrono::seconds(3));
  EXPECT_EQ(config.conditions[1].current, std::nullopt);
  EXPECT_THAT(config.configurations[1].requires_conditions, ElementsAre(0u, 1u));
  EXPECT_THAT(config.given_up.command, ElementsAre("/opt/call", "--call"));
  EXPECT_EQ(config.given_up.configuration, 0u);
  EXPECT_THAT(config.switch_off, ElementsAre("touch", "/opt/off"));
}

TEST_F(RobotConfigTest, StateThatCouldBeSomethingElseIsRefused) {
  Read(R"(
processes:
  - {name: a, command: [x], state: [relative, /etc, /home/robot, "/a/b/../../etc/x"]}
configurations: {all: [a]}
)");
  EXPECT_EQ(diagnostics_.all().size(), 4u) << Errors();
  EXPECT_THAT(Errors(), HasSubstr(R"("/etc" must be an absolute path)"));
}

TEST_F(RobotConfigTest, NothingCanBeginWithAConfigurationThatRequiresSomething) {
  Read(R"(
conditions: {allowed: {topic: /allowed}}
processes: [{name: a, command: [x]}]
configurations: {all: {processes: [a], requires: [allowed]}}
)");
  EXPECT_THAT(Errors(), HasSubstr("requires a condition, so nothing can begin with it"));
}

TEST_F(RobotConfigTest, FindsGroupsThatWaitForEachOther) {
  Read(R"(
groups:
  - {name: one}
  - {name: two, depends: [one]}
processes:
  - {name: a, command: [x], group: one}
  - {name: b, command: [x], group: one, depends: [c]}
  - {name: c, command: [x], group: two}
configurations: {all: [a, b, c]}
)");
  EXPECT_THAT(Errors(), HasSubstr(R"(group "one" waits for itself (depends))"));
  EXPECT_THAT(Errors(), HasSubstr(R"(group "two" waits for itself (depends))"));
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
  EXPECT_THAT(Errors(), HasSubstr(R"(test.yaml:2:31: error: variable "speeed" has no value (did )"
                                  R"(you mean "speed"?))"));
  EXPECT_THAT(Errors(), HasSubstr(R"(unknown key "nod" (did you mean "node"?))"));
  EXPECT_THAT(Errors(), HasSubstr(R"(test.yaml:3:12: error: duplicate process "planner")"));
  EXPECT_THAT(Errors(), HasSubstr(R"(unknown process "planer" (did you mean "planner"?))"));
  EXPECT_THAT(Errors(), HasSubstr(R"("command" is missing)"));
  EXPECT_THAT(Errors(), HasSubstr(R"(expected a ROS name with slash, got "mapper")"));
  EXPECT_THAT(Errors(), HasSubstr(R"("nodes" is none of node, none, topic /NAME, service /NAME)"));
  EXPECT_THAT(Errors(), HasSubstr(R"(unknown process "maper" (did you mean "mapper"?))"));
  EXPECT_THAT(Errors(), HasSubstr(R"(unknown configuration "al" (did you mean "all"?))"));
}

TEST_F(RobotConfigTest, MoreProcessesThanARobotHasAreAnError) {
  std::string text = "processes:\n";
  for (int i = 0; i <= 1000; ++i) {
    text += "  - {name: p" + std::to_string(i) + ", command: [x]}\n";
  }
  Read(text + "configurations: {all: [p1]}\ninitial: all\n");
  EXPECT_THAT(Errors(), HasSubstr("\"processes\": expected at most 1000 entries"));
}

// Advice on each would take a minute.
TEST_F(RobotConfigTest, OfVeryManyUnknownNamesOnlyTheFirstGetAdvice) {
  const std::string end(40, 'x');
  std::string text = "processes:\n";
  for (int i = 0; i < 1000; ++i) {
    const std::string number = std::to_string(1000 + i);
    text += "  - {name: p" + number + end + ", command: [x], depends: [";
    for (int k = 0; k < 9; ++k) text += "p" + number + std::to_string(k) + end + ", ";
    text += "]}\n";
  }
  Read(text + "configurations: {}\n");
  const auto is_advised = [](const Diagnostic& error) { return !error.hint.empty(); };
  const auto advised =
      std::count_if(diagnostics_.all().begin(), diagnostics_.all().end(), is_advised);
  EXPECT_GT(diagnostics_.all().size(), 9000u);
  EXPECT_GT(advised, 100);
  EXPECT_LT(advised, 1000);
}

TEST_F(RobotConfigTest, FindsProcessesThatWaitForThemselves) {
  Read(
      "processes:\n"
      "  - {name: a, command: [x], depends: [b]}\n"
      "  - {name: b, command: [x], after: [c]}\n"
      "  - {name: c, command: [x], depends: [a]}\n"
      "  - {name: d, command: [x], depends: [a]}\n"
      "configurations: {all: [a, b, c, d]}\n");
  EXPECT_THAT(Errors(), HasSubstr(R"(:2:5: error: process "a" waits for itself)"));
  EXPECT_EQ(diagnostics_.all().size(), 3u);  // d waits for them, but not for itself
}

TEST_F(RobotConfigTest, AConfigurationMustHoldWhatItsProcessesDependOn) {
  Read(
      "processes:\n"
      "  - {name: a, command: [x]}\n"
      "  - {name: b, command: [x], depends: [a]}\n"
      "  - {name: c, command: [x], after: [a]}\n"
      "configurations: {all: [b, c]}\n");
  EXPECT_THAT(Errors(), HasSubstr(R"(has "b" but not "a", which it depends on)"));
  EXPECT_EQ(diagnostics_.all().size(), 1u);
}

TEST_F(RobotConfigTest, WhatIsNotEnabledIsInNoConfiguration) {
  const RobotConfig config = Read(
      "processes:\n"
      "  - {name: a, command: [x], enabled: \"${seeing:-no}\"}\n"
      "  - {name: b, command: [x], enabled: yes}\n"
      "configurations: {all: [a, b]}\n");
  EXPECT_EQ(Errors(), "");
  EXPECT_THAT(config.configurations.at(0).processes, ElementsAre(1));
}

TEST_F(RobotConfigTest, EnabledIsYesOrNo) {
  Read(
      "processes:\n"
      "  - {name: a, command: [x], enabled: perhaps}\n"
      "configurations: {all: [a]}\n");
  EXPECT_THAT(Errors(), HasSubstr("\"enabled\": expected yes or no, got \"perhaps\""));
}

TEST_F(RobotConfigTest, PerceptionCanBeLeftOutOfTheShippedRobot) {
  const auto runs = [&](const char* perception, const std::string& name) {
    const RobotConfig config = LoadRobotConfig(SourceFolder() + "/robot_app/config/robot.yaml",
                                               {{"bin", "/b"},
                                                {"config", SourceFolder() + "/robot_app/config"},
                                                {"record", "/runs/one"},
                                                {"perception", perception}},
                                               diagnostics_);
    for (const std::size_t i : config.configurations[config.initial].processes) {
      if (config.processes[i].name == name) return true;
    }
    return false;
  };
  for (const char* const program : {"people_tracker", "camera_detector"}) {
    EXPECT_TRUE(runs("yes", program)) << program;
    EXPECT_FALSE(runs("no", program)) << program;
  }
  EXPECT_TRUE(runs("no", "navigation"));
}

constexpr char kSites[] = R"(
sites:
  initial: home
  table: {home: {configuration: operating}, hill: {configuration: away}}
  folder: "/runs/${site}"
processes: [{name: a, command: ["map=${site}"]}, {name: dock, command: [x]}]
configurations: {away: [a], operating: [a, dock]}
)";

TEST_F(RobotConfigTest, ASiteIsTheValueOfAVariableAndBeginsInItsConfiguration) {
  const RobotConfig home = Read(kSites);
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(home.sites[home.site].name, "home");
  EXPECT_EQ(home.configurations[home.initial].name, "operating");
  const RobotConfig hill = Read(kSites, {{"site", "hill"}});
  EXPECT_EQ(Errors(), "");
  EXPECT_THAT(hill.processes[0].command, ElementsAre("map=hill"));
  EXPECT_EQ(hill.configurations[hill.initial].name, "away");
  EXPECT_EQ(hill.site_folder, "/runs/hill");
}

TEST_F(RobotConfigTest, ASiteThatNobodyKnowsIsToldWithTheNearestRightName) {
  Read(kSites, {{"site", "hil"}});
  EXPECT_THAT(Errors(), HasSubstr("unknown site \"hil\""));
  EXPECT_THAT(Errors(), HasSubstr("did you mean \"hill\"?"));
}

TEST_F(RobotConfigTest, ASiteWithoutItsFilesIsNotComplete) {
  Read(R"(
sites: {table: {home: {configuration: all}}, files: ["/nowhere/${site}.yaml"]}
processes: [{name: a, command: [x]}]
configurations: {all: [a]}
)");
  EXPECT_THAT(Errors(), HasSubstr(":2:54: error: site \"home\": cannot read /nowhere/home.yaml"));
}

TEST_F(RobotConfigTest, ASiteOfADamagedFileIsNotComplete) {
  const std::string file = Temporary("damaged_places.yaml");
  std::ofstream(file) << "site: x\nplaces:\n  - {name: hall, x: 1";
  Read(R"(
sites: {table: {home: {configuration: all}}, files: ["${file}"]}
processes: [{name: a, command: [x]}]
configurations: {all: [a]}
)",
       {{"file", file}});
  EXPECT_THAT(Errors(), HasSubstr(file + ":3:"));
}

// All of them are read whenever the robot comes to the site.
TEST_F(RobotConfigTest, ASiteHasAHundredFilesAtTheMost) {
  std::string files = "/nowhere";
  for (int i = 0; i < 100; ++i) files += ", /nowhere";
  Read("sites: {table: {home: {configuration: all}}, files: [" + files + "]}\n" +
       "processes: [{name: a, command: [x]}]\nconfigurations: {all: [a]}\n");
  EXPECT_THAT(Errors(), HasSubstr(":1:54: error: expected at most 100 files"));
}

TEST_F(RobotConfigTest, ASiteHasANameThatLeadsNowhereElse) {
  for (const std::string name : {"../home", "a/b", "..", "\"\"", "\"a b\""}) {
    Read("sites: {table: {" + name + ": {configuration: all}}}\n" +
         "processes: [{name: a, command: [x]}]\nconfigurations: {all: [a]}\n");
    EXPECT_THAT(Errors(), HasSubstr("expected the name of a folder")) << name;
  }
}

// A long name of a site may stand in each of many words.
TEST_F(RobotConfigTest, VariablesDoNotMultiplyAFile) {
  std::string words = "x";
  for (int i = 0; i < 20'000; ++i) words += ", \"${site}\"";
  const std::string name(1000, 'a');
  Read("sites: {table: {" + name + ": {configuration: all}}}\nprocesses: [{name: a, command: [" +
       words + "]}]\nconfigurations: {all: [a]}\n");
  EXPECT_THAT(Errors(), HasSubstr("too long with their variables filled in"));
}

TEST_F(RobotConfigTest, TheParametersOfASiteAreThoseOfItsNodes) {
  const std::string file = Temporary("site_parameters.yaml");
  std::ofstream(file) << "mapping: {range: 30}\nslam: {surroundings: outdoor}\n";
  const RobotConfig config = Read(R"(
sites: {table: {home: {configuration: all}}, parameters: "${file}"}
parameters: {use_sim_time: true}
processes: [{name: a, command: [x]}]
configurations: {all: [a]}
)",
                                  {{"file", file}});
  EXPECT_EQ(Errors(), "");
  EXPECT_THAT(config.parameters,
              ElementsAre(Pair("mapping/range", "30"), Pair("slam/surroundings", "outdoor"),
                          Pair("use_sim_time", "true")));
}

TEST_F(RobotConfigTest, EveryShippedSiteIsComplete) {
  const std::string config = SourceFolder() + "/robot_app/config";
  Variables variables = {{"bin", "/b"}, {"config", config}, {"record", "/runs/one"}};
  for (const SiteConfig& site :
       LoadRobotConfig(config + "/robot.yaml", variables, diagnostics_).sites) {
    variables["site"] = site.name;
    LoadRobotConfig(config + "/robot.yaml", variables, diagnostics_);
    EXPECT_EQ(Errors(), "") << site.name;
  }
}

TEST_F(RobotConfigTest, TheShippedFileIsRight) {
  const std::string folder = SourceFolder() + "/robot_app/config";
  const RobotConfig config =
      LoadRobotConfig(folder + "/robot.yaml",
                      {{"bin", "/b"}, {"config", folder}, {"record", "/runs/one"}}, diagnostics_);
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(config.configurations[config.initial].name, "operating");
  for (const ProcessConfig& process : config.processes) {
    EXPECT_EQ(process.heartbeat.has_value(), process.name == "robot") << process.name;
    if (process.name != "localization") continue;
    EXPECT_THAT(process.state, ElementsAre("/runs/one/institute/last_pose"));
  }
}

}  // namespace
}  // namespace coppice::robot::processes
