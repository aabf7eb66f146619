// The program coppice-robot in a ROS graph in which nobody else is.
#include <gmock/gmock.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>

#include <fstream>
#include <sstream>

#include "tests/robot_app/processes/ros_graph.h"
#include "tests/robot_app/processes/shut_down_node.h"

namespace coppice::robot {
namespace {

using testing::HasSubstr;

constexpr char kTrees[] = R"(<root BTCPP_format="4" main_tree_to_execute="Long">
  <BehaviorTree ID="Long"><Sleep msec="100000000"/></BehaviorTree>
  <BehaviorTree ID="Short"><AlwaysSuccess/></BehaviorTree>
</root>)";

class RobotProgramTest : public testing::Test {
 protected:
  RobotProgramTest() { std::ofstream(trees_) << kTrees; }
  ~RobotProgramTest() override { graph_.EndPrograms(); }

  void Start(const std::vector<std::string>& more = {}) {
    std::vector<std::string> command = {processes::kPrograms + "coppice-robot",
                                        "--application",
                                        trees_,
                                        "--monitor",
                                        trees_,
                                        "--waypoints",
                                        SourceFolder() + "/robot_app/config/waypoints.yaml",
                                        "--live-port",
                                        "0"};
    command.insert(command.end(), more.begin(), more.end());
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

  processes::RosGraph& graph_ = processes::RosGraph::Shared();
  const std::string trees_ = processes::Temporary("robot_program_test.xml");
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

TEST_F(RobotProgramTest, EndsInOrderWhenItIsAsked) {
  Start();
  ASSERT_TRUE(ComesToLife());
  EXPECT_EQ(graph_.Kill(pid_, SIGTERM), 0);
}

}  // namespace
}  // namespace coppice::robot
