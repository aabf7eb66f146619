// The sites of the program coppice-supervisor, with a real master and real processes.
#include <gmock/gmock.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/robot_app/processes/supervisor_program_fixture.h"

namespace coppice::robot::processes {
namespace {

using testing::HasSubstr;

constexpr char kTwoSites[] = R"(
stop_timeout: 1
sites:
  table: {home: {configuration: at_home}, hill: {configuration: away}}
  parameters: "${folder}/${site}.yaml"
  folder: "${folder}/learnt/${site}"
processes:
  - {name: map, command: ["${talker}", "__name:=map", "_site:=${site}"], node: /map, ready: topic /talk}
  - {name: dock, command: ["${talker}", "__name:=dock"], node: /dock}
configurations:
  at_home: [map, dock]
  away: [map]
)";

class SiteProgramTest : public SupervisorProgramTest {
 protected:
  SiteProgramTest() {
    WriteConfig(kTwoSites);
    std::ofstream(folder_ + "/home.yaml") << "map: {range: 12}\n";
    std::ofstream(folder_ + "/hill.yaml") << "map: {range: 30}\n";
  }

  // All of it, or nothing is true yet.
  bool IsAt(const std::string& site) {
    const bool is_home = site == "home";
    return PidOf("map") > 0 &&
           CommandOf(PidOf("map")).find("_site:=" + site) != std::string::npos &&
           PidOfNode("/map") > 0 && Range() == (is_home ? 12 : 30) &&
           (PidOf("dock") > 0) == is_home &&
           std::filesystem::is_directory(folder_ + "/learnt/" + site);
  }

  // The parameter of the node; 0 if there is none.
  double Range() const {
    XmlRpc::XmlRpcClient master("127.0.0.1", port_, "/");
    XmlRpc::XmlRpcValue request, answer;
    request[0] = "/test";
    request[1] = "/map/range";
    if (!master.execute("getParam", request, answer) || static_cast<int>(answer[0]) != 1) return 0;
    return static_cast<double>(answer[2]);
  }

  static std::string CommandOf(int pid) {
    std::ostringstream text;
    text << std::ifstream("/proc/" + std::to_string(pid) + "/cmdline").rdbuf();
    return text.str();
  }

  // By hand, as a person does it.
  int Move(const std::string& site) {
    return ExitStatusOf(
        graph_.Start("move", {kPrograms + "coppice-processes", "site", site, "--master",
                              "http://127.0.0.1:" + std::to_string(port_)}));
  }
};

TEST_F(SiteProgramTest, AllThatBelongsToASiteChangesWithItByOneCommand) {
  StartSupervisor();
  ASSERT_TRUE(Eventually([&] { return IsAt("home"); }));
  EXPECT_EQ(Move("hil"), 1);
  EXPECT_THAT(Read("move.log"), HasSubstr("did you mean \"hill\"?"));
  EXPECT_EQ(Move("hill"), 0);
  ASSERT_TRUE(Eventually([&] { return IsAt("hill"); }));
  EXPECT_THAT(Read("supervisor.log"), HasSubstr("begins anew: the robot was brought to hill"));
  // Who is stopped on purpose is still there.
  graph_.Kill(supervisor_, SIGTERM);
  StartSupervisor();
  EXPECT_TRUE(Eventually([&] { return IsAt("hill"); }));
  graph_.Kill(supervisor_, SIGTERM);
}

TEST_F(SiteProgramTest, ASiteWithoutItsFilesIsNotEntered) {
  std::filesystem::remove(folder_ + "/hill.yaml");
  StartSupervisor();
  ASSERT_TRUE(Eventually([&] { return IsAt("home"); }));
  const int before = PidOf("map");
  EXPECT_EQ(Move("hill"), 1);
  EXPECT_THAT(Read("move.log"), HasSubstr("/hill.yaml"));
  EXPECT_EQ(PidOf("map"), before);
  graph_.Kill(supervisor_, SIGTERM);
}

// A full disk, a folder that was deleted: all would begin anew, where the robot is not.
TEST_F(SiteProgramTest, ASiteThatCannotBeWrittenDownIsNotEntered) {
  std::filesystem::create_directories(folder_ + "/memory");
  StartSupervisor({"--state", folder_ + "/memory/supervisor.json"});
  ASSERT_TRUE(Eventually([&] { return PidOfNode("/map") > 0; }));
  const int before = PidOfNode("/map");
  std::filesystem::remove_all(folder_ + "/memory");
  EXPECT_EQ(Move("hill"), 1);
  EXPECT_THAT(Read("move.log"), HasSubstr("supervisor.json"));
  EXPECT_EQ(PidOfNode("/map"), before);
  // As soon as it can be written down again, it may go there.
  std::filesystem::create_directories(folder_ + "/memory");
  EXPECT_EQ(Move("hill"), 0);
  EXPECT_TRUE(Eventually([&] { return PidOfNode("/map") > 0 && Range() == 30; }));
  graph_.Kill(supervisor_, SIGTERM);
}

TEST_F(SiteProgramTest, ASiteWhoseFolderCannotBeMadeIsNotEntered) {
  std::filesystem::create_directories(folder_ + "/learnt");
  std::ofstream(folder_ + "/learnt/hill") << "a file in its place";
  StartSupervisor();
  ASSERT_TRUE(Eventually([&] { return IsAt("home"); }));
  EXPECT_EQ(Move("hill"), 1);
  EXPECT_THAT(Read("move.log"), HasSubstr("/learnt/hill: cannot be made"));
  EXPECT_TRUE(IsAt("home"));
  graph_.Kill(supervisor_, SIGTERM);
}

TEST_F(SiteProgramTest, WithoutAFolderOfItsSiteTheRobotRunsNevertheless) {
  std::ofstream(folder_ + "/learnt") << "a file in its place";
  StartSupervisor();
  EXPECT_TRUE(Eventually([&] { return PidOfNode("/map") > 0; }));
  EXPECT_THAT(Read("supervisor.log"), HasSubstr("/learnt/home: cannot be made"));
  graph_.Kill(supervisor_, SIGTERM);
}

// At moments that are spread over the change, before and after its answer.
TEST_F(SiteProgramTest, KilledAtAnyMomentOfTheChangeItIsAtTheOldSiteOrAtTheNewOne) {
  int arrived = 0;
  for (const int after : {0, 20, 100, 400, 1500}) {  // ms
    std::filesystem::remove_all(folder_ + "/logs");
    StartSupervisor();
    ASSERT_TRUE(Eventually([&] { return IsAt("home"); }));
    const int mover =
        graph_.Start("move", {kPrograms + "coppice-processes", "site", "hill", "--timeout", "1",
                              "--master", "http://127.0.0.1:" + std::to_string(port_)});
    const auto kill_at = std::chrono::steady_clock::now() + std::chrono::milliseconds(after);
    Eventually([&] { return std::chrono::steady_clock::now() >= kill_at; });
    graph_.Kill(supervisor_, SIGKILL);
    const int status = ExitStatusOf(mover);
    StartSupervisor();
    ASSERT_TRUE(Eventually([&] { return IsAt("home") || IsAt("hill"); })) << after;
    if (status == 0) {
      EXPECT_TRUE(IsAt("hill")) << after;  // it was promised
    }
    arrived += IsAt("hill");
    graph_.Kill(supervisor_, SIGTERM);
    EXPECT_EQ(PidOf(""), 0);
  }
  RecordProperty("arrived", arrived);
}

}  // namespace
}  // namespace coppice::robot::processes
