// The ROS programs that are started by StartNode, as whole processes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robot_app/common/child_process.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/robot_app/text_of.h"
#include "tests/support/folders.h"

namespace coppice::robot {
namespace {

using testing::HasSubstr;

struct Mistake {
  std::string program;
  std::string parameter;
  std::string meant;
};

// Runs the program to its end under a name of its own: parameters outlive their node.
struct Finished {
  Finished(const std::string& program, const std::vector<std::string>& arguments,
           const std::vector<std::pair<std::string, std::string>>& environment = {}) {
    const std::string log = testing::TempDir() + std::to_string(getpid()) + program + ".log";
    std::remove(log.c_str());
    std::vector<std::string> command = {BinaryFolder() + "/bin/" + program};
    command.insert(command.end(), arguments.begin(), arguments.end());
    ChildProcess process(command, log, environment);
    EXPECT_TRUE(Eventually([&] { return !process.IsRunning(); }));
    status = process.exit_status();
    text = TextOf(log);
  }

  int status = -1;
  std::string text;
};

class RosPrograms : public testing::TestWithParam<Mistake> {};

TEST_P(RosPrograms, RefuseAMisspeltParameterAndNameTheNearest) {
  const auto& [program, parameter, meant] = GetParam();
  const Finished run(program, {"__name:=misspelt_" + meant, "_" + parameter + ":=1"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.text,
            program + ": unknown parameter ~" + parameter + " (did you mean \"" + meant + "\"?)\n");
}

TEST_P(RosPrograms, RefuseAValueOfAnotherType) {
  const auto& [program, parameter, meant] = GetParam();
  const Finished run(program, {"__name:=mistyped_" + meant, "_" + meant + ":=[1]"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.text, HasSubstr(program + ": ~" + meant + " must be "));
}

TEST_P(RosPrograms, SayInOneLineThatThereIsNoMaster) {
  const Finished run(GetParam().program, {}, {{"ROS_MASTER_URI", "http://127.0.0.1:1"}});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.text,
            GetParam().program + ": no ROS master at http://127.0.0.1:1 (ROS_MASTER_URI)\n");
}

TEST_P(RosPrograms, ExplainTheirParameters) {
  const Finished run(GetParam().program, {"--help"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.text, HasSubstr("    ~" + GetParam().meant + " "));
}

INSTANTIATE_TEST_SUITE_P(
    Parameters, RosPrograms,
    testing::Values(Mistake{"coppice-simulator", "spead", "speed"},
                    Mistake{"coppice-navigation", "max_sped", "max_speed"},
                    Mistake{"coppice-docking", "aproach_speed", "approach_speed"},
                    Mistake{"coppice-localization", "loss_after", "lost_after"},
                    Mistake{"coppice-odometry-filter", "frequenzy", "frequency"},
                    Mistake{"coppice-mapping", "resolutoin", "resolution"}),
    [](const auto& test) {
      std::string name = test.param.program;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

TEST(RosProgramsWithout, ParametersRefuseEachOne) {
  const Finished run("coppice-velocity-mux", {"__name:=misspelt_mux", "_timeout:=1"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.text, "coppice-velocity-mux: unknown parameter ~timeout\n");
}

TEST(RosProgramsWithout, AMapNameTheNearestParameter) {
  const Finished run("coppice-map-server", {"__name:=misspelt_map", "_mapp:=none"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.text, HasSubstr("did you mean \"map\"?"));
}

TEST(RosProgramsWithout, AMapRefuseATopicThatCannotBe) {
  const Finished run("coppice-map-server", {"__name:=odd_map", "_stand_in_topic:={map}"});
  EXPECT_EQ(run.status, 2) << run.text;
  EXPECT_THAT(run.text, HasSubstr("~stand_in_topic: "));
}

}  // namespace
}  // namespace coppice::robot
