#include "robot_app/processes/processes_view.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace coppice::robot::processes {
namespace {

using coppice_msgs::ProcessState;
using testing::HasSubstr;

coppice_msgs::ProcessStates Example() {
  coppice_msgs::ProcessStates states;
  states.configuration = "operating";
  states.manual = true;
  ProcessState process;
  process.name = "ekf";
  process.group = "odometry_filter";
  process.state = ProcessState::BACKING_OFF;
  process.restarts = 4;
  process.restarts_in_window = 2;
  process.restarts_allowed = 3;
  process.escalation = ProcessState::CLOSURE;
  process.since = ros::Time(1000);
  process.back_off_until = ros::Time(1020);
  process.message = "ended by signal 11";
  states.processes.push_back(process);
  return states;
}

TEST(ProcessesViewTest, TheTableShowsEverythingInColumns) {
  EXPECT_EQ(ToTable(Example(), Time(std::chrono::seconds(1010))),
            "configuration operating, held by hand\n"
            "PROCESS  GROUP            HOST  STATE        FOR   PID  RESTARTS  USED  STEP     "
            "MESSAGE\n"
            "ekf      odometry_filter  -     BACKING_OFF  10 s  -    4         2/3   closure  "
            "ended by signal 11; again in 10 s\n");
}

TEST(ProcessesViewTest, WhoeverPublishesTheStatesSaysNothingToTheTerminal) {
  coppice_msgs::ProcessStates states = Example();
  states.configuration = "\x1b[2Joperating";
  states.processes[0].name = "\x1b]0;ekf\xff\n";
  states.processes[0].message = std::string(1'000'000, 'x');
  states.processes.resize(1000, Example().processes[0]);
  const std::string table = ToTable(states, Time(std::chrono::seconds(1010)));
  EXPECT_EQ(table.find('\x1b'), std::string::npos);
  EXPECT_LT(table.size(), 1000U * 500);
}

TEST(ProcessesViewTest, RowsAreTheProcessesOnOneLineTheMostImportantFirst) {
  const std::string rows = ToJsonRows(Example());
  EXPECT_EQ(
      rows.rfind(R"([{"name":"ekf","node":"","group":"odometry_filter","host":"","state":)", 0), 0U)
      << rows;
  EXPECT_EQ(rows.find('\n'), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(rows)[0]["restarts_allowed"], 3);
  EXPECT_EQ(ToJsonRows({}), "[]");
}

TEST(ProcessesViewTest, JsonCanBeReadByPrograms) {
  coppice_msgs::ProcessStates states = Example();
  states.processes[0].message = "bad \xff byte";
  const auto value = nlohmann::json::parse(ToJson(states));
  EXPECT_EQ(value["configuration"], "operating");
  EXPECT_EQ(value["manual"], true);
  EXPECT_EQ(value["processes"][0]["state"], "BACKING_OFF");
  EXPECT_EQ(value["processes"][0]["escalation"], "closure");
  EXPECT_EQ(value["processes"][0]["back_off_until"], 1020);
}

TEST(ProcessesViewTest, KnowsWhetherAllIsWell) {
  coppice_msgs::ProcessStates states = Example();
  EXPECT_TRUE(IsAsItShouldBe(states));
  states.changing = true;
  EXPECT_FALSE(IsAsItShouldBe(states));
  states.changing = false;
  states.processes[0].state = ProcessState::GIVEN_UP;
  EXPECT_FALSE(IsAsItShouldBe(states));
}

}  // namespace
}  // namespace coppice::robot::processes
