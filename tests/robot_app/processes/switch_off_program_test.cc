// The program coppice-supervisor when it is asked to cut the power.
#include <coppice_msgs/SwitchOff.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "tests/robot_app/processes/supervisor_program_fixture.h"

namespace coppice::robot::processes {
namespace {

using coppice_msgs::ProcessState;
using testing::HasSubstr;
using testing::Not;

class SwitchOffProgramTest : public SupervisorProgramTest {
 protected:
  SwitchOffProgramTest() {
    WriteConfig(std::string(kConfig) +
                "  safe_stop: [first]\n"
                "on_given_up: {configuration: safe_stop}\n"
                "switch_off: {command: [touch, \"${folder}/off\"]}\n");
    setenv("COPPICE_SWITCH_OFF_TOKEN", "secret", 1);
    StartSupervisor();
    unsetenv("COPPICE_SWITCH_OFF_TOKEN");
    JoinGraph();
  }

  static std::string SwitchOff(const std::string& token) {
    coppice_msgs::SwitchOff service;
    service.request.reason = "the battery is empty";
    service.request.token = token;
    EXPECT_TRUE(ros::service::call("/supervisor/switch_off", service));
    EXPECT_TRUE(service.response.ok);
    return service.response.message;
  }
};

TEST_F(SwitchOffProgramTest, WithoutTheTokenItStaysInTheSafeStop) {
  EXPECT_THAT(SwitchOff("guess"), HasSubstr("the power stays on"));
  ASSERT_TRUE(graph_.WaitFor([&] { return configuration_ == "safe_stop"; }));
  ASSERT_TRUE(WaitForState("second", ProcessState::STOPPED));
  coppice_msgs::RestartProcess reset;
  reset.request.name = "all";
  EXPECT_TRUE(ros::service::call("/supervisor/reset", reset));
  ASSERT_TRUE(WaitForState("second", ProcessState::READY));
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/off"));
}

TEST_F(SwitchOffProgramTest, WithTheTokenEverythingEndsAndTheCommandRuns) {
  EXPECT_THAT(SwitchOff("secret"), HasSubstr("then the power goes off"));
  EXPECT_EQ(graph_.WaitForEnd(supervisor_), 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ + "/off"));
  EXPECT_EQ(PidOf("first"), 0);
  EXPECT_THAT(Read("logs/supervisor.json"), Not(HasSubstr("\"safe_stop\":true")));
}

}  // namespace
}  // namespace coppice::robot::processes
