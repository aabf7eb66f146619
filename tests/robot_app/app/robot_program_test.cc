// The program coppice-robot in a ROS graph in which nobody else is.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gmock/gmock.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/bt_core/live/watcher.h"
#include "tests/bt_core/live/web_caller.h"
#include "tests/robot_app/processes/ros_graph.h"
#include "tests/robot_app/processes/shut_down_node.h"

namespace coppice::robot {
namespace {

using testing::HasSubstr;

constexpr char kTrees[] = R"(<root BTCPP_format="4" main_tree_to_execute="Long">
  <BehaviorTree ID="Long"><Sleep msec="100000000"/></BehaviorTree>
  <BehaviorTree ID="Short"><AlwaysSuccess/></BehaviorTree>
</root>)";

// Has always something to record.
constexpr char kBusyTree[] = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Long"><Repeat num_cycles="-1"><Sleep msec="20"/></Repeat></BehaviorTree>
</root>)";

class RobotProgramTest : public testing::Test {
 protected:
  RobotProgramTest() { std::ofstream(trees_) << kTrees; }
  ~RobotProgramTest() override { graph_.EndPrograms(); }

  void Start(const std::vector<std::string>& more = {}) {
    std::vector<std::string> command = {
        processes::kPrograms + "coppice-robot",
        "--application",
        trees_,
        "--monitor",
        trees_,
        "--places",
        SourceFolder() + "/robot_app/config/sites/institute/places.yaml",
        "--live-port",
        std::to_string(live_port_)};
    command.insert(command.end(), more.begin(), more.end());
    if (!shell_.empty()) {
      const std::vector<std::string> shell = {"/bin/sh", "-c", shell_, "sh"};
      command.insert(command.begin(), shell.begin(), shell.end());
    }
    pid_ = graph_.Start("robot", command);
    beats_ = graph_.node().subscribe<std_msgs::Empty>(
        "/coppice/heartbeat", 10, [this](const std_msgs::Empty::ConstPtr&) { ++heard_; });
    application_ = graph_.node().subscribe<std_msgs::String>(
        "/coppice/application", 10,
        [this](const std_msgs::String::ConstPtr& message) { said_ = message->data; });
  }

  bool ComesToLife() {
    return graph_.WaitFor([&] { return heard_ > 1; });
  }

  // The newest one on /diagnostics.
  ros::Subscriber ListenToWarnings(std::string& warning) {
    return graph_.node().subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 10, [&](const diagnostic_msgs::DiagnosticArray::ConstPtr& message) {
          for (const auto& status : message->status) {
            if (status.level == status.WARN) warning = status.name + ": " + status.message;
          }
        });
  }

  processes::RosGraph& graph_ = processes::RosGraph::Shared();
  const std::string trees_ = processes::Temporary("robot_program_test.xml");
  std::string shell_;  // that starts it, if not empty
  int live_port_ = 0;  // none
  int pid_ = 0;
  int heard_ = 0;
  std::string said_;
  ros::Subscriber beats_, application_;
};

TEST_F(RobotProgramTest, RunsTheTreeThatIsNamed) {
  Start({"--tree", "Short"});
  EXPECT_TRUE(graph_.WaitFor([&] { return said_ == "SUCCESS"; })) << said_;
}

TEST_F(RobotProgramTest, ItsHeartBeatsOnAfterTheApplicationHasEnded) {
  Start({"--tree", "Short"});
  ASSERT_TRUE(graph_.WaitFor([&] { return said_ == "SUCCESS"; }));
  heard_ = 0;
  EXPECT_TRUE(ComesToLife());
}

TEST_F(RobotProgramTest, EndsWhenItsRosNodeIsShutDownFromOutside) {
  Start();
  ASSERT_TRUE(ComesToLife());
  ASSERT_TRUE(processes::ShutDownNode(graph_.master(), "/coppice_robot"));
  const auto wait_status = graph_.WaitForEnd(pid_);
  ASSERT_TRUE(wait_status) << "it lives on without ROS";
  EXPECT_EQ(WEXITSTATUS(*wait_status), 1) << "0 would say that its work is done";
}

TEST_F(RobotProgramTest, SaysWhenItCannotRecord) {
  const std::string folder = processes::Temporary("robot_program_records");
  std::string warning;
  const ros::Subscriber diagnostics = ListenToWarnings(warning);
  shell_ = "trap '' XFSZ; ulimit -f 1; exec \"$@\"";  // as a disk that is full
  Start({"--record", folder});
  EXPECT_TRUE(graph_.WaitFor([&] { return !warning.empty(); }));
  EXPECT_THAT(warning, AllOf(HasSubstr("coppice_robot: record of "), HasSubstr("cannot write")));
}

TEST_F(RobotProgramTest, SaysThatItsRecordWasDeleted) {
  const std::filesystem::path folder = processes::Temporary("robot_program_deleted");
  std::string warning;
  const ros::Subscriber diagnostics = ListenToWarnings(warning);
  std::ofstream(trees_) << kBusyTree;
  Start({"--record", folder});
  ASSERT_TRUE(ComesToLife());
  std::filesystem::remove(folder / "application.coppice");
  EXPECT_TRUE(graph_.WaitFor([&] { return !warning.empty(); }));
  EXPECT_THAT(warning, AllOf(HasSubstr("coppice_robot: record of application: "),
                             HasSubstr("somebody has deleted this record")));
}

TEST_F(RobotProgramTest, EndsInOrderWhenItIsAsked) {
  Start();
  ASSERT_TRUE(ComesToLife());
  EXPECT_EQ(graph_.Kill(pid_, SIGTERM), 0);
}

TEST_F(RobotProgramTest, TellsItsFiguresToPrometheus) {
  const int port = processes::FreePort();
  Start({"--metrics-port", std::to_string(port)});
  ASSERT_TRUE(ComesToLife());
  WebCaller caller(static_cast<std::uint16_t>(port));
  EXPECT_THAT(caller.Ask("GET /metrics HTTP/1.0\r\nHost: localhost\r\n\r\n"), HasSubstr("200 OK"));
  const std::string figures = caller.Rest();
  EXPECT_THAT(figures, HasSubstr("coppice_ticks_total{tree=\"application\"}"));
  EXPECT_THAT(figures, HasSubstr("coppice_ticks_total{tree=\"monitor\"}"));
}

// What the node of the face draws, a watcher of the trees has in his hands.
TEST_F(RobotProgramTest, ShowsItsFaceToThoseWhoWatchItsTrees) {
  live_port_ = processes::FreePort(4);  // two trees have two each
  Start();
  graph_.Start("expression", {processes::kPrograms + "coppice-expression"});
  LiveClientOptions options;
  options.with_pictures = true;
  Watcher watcher;
  const LiveClient client("127.0.0.1:" + std::to_string(live_port_), watcher, options);
  const auto shows = [](const Watched& watched, const std::string& name, std::uint32_t width,
                        const std::string& text) {
    const auto& all = watched.pictures;
    return std::any_of(all.begin(), all.end(), [&](const LivePicture& picture) {
      return picture.name == name && picture.width == width && picture.text == text;
    });
  };
  EXPECT_TRUE(watcher.Await([&](const Watched& watched) {
    return shows(watched, "face", 64, "NEUTRAL") && shows(watched, "ears", 1, "0° 0°") &&
           shows(watched, "arms", 1, "0° 0°");
  }));
}

}  // namespace
}  // namespace coppice::robot
