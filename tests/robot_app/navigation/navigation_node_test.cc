// The programs coppice-navigation and coppice-docking drive the simulator's robot over ROS.
#include <actionlib/client/simple_action_client.h>
#include <coppice_msgs/DockingAction.h>
#include <coppice_msgs/InjectFault.h>
#include <coppice_msgs/MotionAction.h>
#include <coppice_msgs/NavigationState.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <nav_msgs/GetPlan.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Float64.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <optional>
#include <vector>

#include "robot_app/common/child_process.h"
#include "robot_app/processes/launch/ros_master.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/latest.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/robot_app/simulation_speed.h"
#include "tests/robot_app/text_of.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::navigation {
namespace {

using actionlib::SimpleClientGoalState;
using testing::HasSubstr;

constexpr double kPatience = 30;  // wall time, for whatever is waited for [s]
const std::string kPrograms = BinaryFolder() + "/bin/";

std::string Log(const std::string& name) {
  return testing::TempDir() + std::to_string(getpid()) + "_" + name + ".log";
}

template <class Action>
class Client {
 public:
  explicit Client(const std::string& name) : client_(name, true) {
    EXPECT_TRUE(client_.waitForServer(ros::Duration(kPatience))) << name;
  }
  template <class Goal>
  void Send(const Goal& goal) {
    client_.sendGoal(goal);
  }
  SimpleClientGoalState Wait() {
    EXPECT_TRUE(client_.waitForResult(ros::Duration(kPatience)));
    return client_.getState();
  }
  auto* operator->() { return &client_; }

 private:
  actionlib::SimpleActionClient<Action> client_;
};

move_base_msgs::MoveBaseGoal Goal(double x, double y) {
  move_base_msgs::MoveBaseGoal goal;
  goal.target_pose.header.frame_id = "map";
  goal.target_pose.pose.position.x = x;
  goal.target_pose.pose.position.y = y;
  goal.target_pose.pose.orientation.w = 1;
  return goal;
}

// Is there a way to that point right now? Not before it knows the map and where it is.
bool FindsAWay(double x, double y) {
  nav_msgs::GetPlan plan;
  plan.request.goal = Goal(x, y).target_pose;
  return ros::service::call("move_base/make_plan", plan) && !plan.response.plan.poses.empty();
}

// Keeps what the navigation says and what the robot is told.
struct Listener {
  Listener() {
    state_subscriber = node.subscribe<coppice_msgs::NavigationState>(
        "/navigation/state", 20, [this](const coppice_msgs::NavigationState::ConstPtr& message) {
          const std::lock_guard<std::mutex> lock(mutex);
          state = *message;
          driving = driving || message->state == coppice_msgs::NavigationState::DRIVING;
        });
    command_subscriber = node.subscribe<geometry_msgs::Twist>(
        "/cmd_vel", 100, [this](const geometry_msgs::Twist::ConstPtr& message) {
          speed = message->linear.x;
          ++commands;
        });
    path_subscriber = node.subscribe<nav_msgs::Path>(
        "/navigation/path", 20, [this](const nav_msgs::Path::ConstPtr& message) {
          longest_path = std::max<int>(longest_path, static_cast<int>(message->poses.size()));
        });
  }
  ~Listener() {
    state_subscriber.shutdown();
    command_subscriber.shutdown();
    path_subscriber.shutdown();
  }
  coppice_msgs::NavigationState State() {
    const std::lock_guard<std::mutex> lock(mutex);
    return state;
  }

  ros::NodeHandle node;
  std::mutex mutex;
  coppice_msgs::NavigationState state;
  std::atomic<bool> driving{false};
  std::atomic<double> speed{0};
  std::atomic<int> commands{0};
  std::atomic<int> longest_path{0};
  ros::Subscriber state_subscriber;
  ros::Subscriber command_subscriber;
  ros::Subscriber path_subscriber;
};

// Opens and closes doors; a door that somebody stands in can not be closed until they are gone.
bool InjectFault(const std::string& fault, const std::string& target) {
  coppice_msgs::InjectFault call;
  call.request.fault = fault;
  call.request.target = target;
  return ros::service::call("/simulation/inject_fault", call) && call.response.ok;
}

class NavigationNode : public testing::Test {
 protected:
  // A node's parameters outlive it.
  ~NavigationNode() override {
    ros::param::del("/navigation/places");
    ros::param::del("/simulator/floor");
  }

  // Starts the robot at "X Y YAW", or docked: "none". The rest: arguments of the programs.
  void StartRobot(const std::string& start, const std::vector<std::string>& navigation = {},
                  const std::vector<std::string>& simulator = {}) {
    ros::param::set("/use_sim_time", true);
    StartSimulator(start, simulator);
    std::vector<std::string> command = {kPrograms + "coppice-navigation"};
    command.insert(command.end(), navigation.begin(), navigation.end());
    navigation_ = ChildProcess(command, Log("navigation"));
  }
  void StartSimulator(const std::string& start, const std::vector<std::string>& arguments = {}) {
    std::vector<std::string> command = {kPrograms + "coppice-simulator", SimulationSpeed(6),
                                        "_start:=" + start, "_state_of_charge:=0.5"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    simulator_ = ChildProcess(command, Log("simulator"));
  }

  ChildProcess simulator_;
  ChildProcess navigation_;
};

TEST_F(NavigationNode, AManoeuvreWaitsForSensorsThatComeLate) {
  ros::param::set("/use_sim_time", true);
  ChildProcess docking({kPrograms + "coppice-docking"}, Log("docking_first"));
  Client<coppice_msgs::DockingAction> dock("docking");
  coppice_msgs::DockingGoal undock;
  undock.dock = false;
  dock.Send(undock);
  ASSERT_TRUE(
      Eventually([&] { return dock->getState() == SimpleClientGoalState::ACTIVE; }, kPatience));
  StartRobot("none");
  EXPECT_EQ(dock.Wait(), SimpleClientGoalState::SUCCEEDED) << dock->getState().getText();
}

TEST_F(NavigationNode, LeavesTheStationDrivesToAGoalAndComesBack) {
  StartRobot("none");
  ChildProcess docking({kPrograms + "coppice-docking"}, Log("docking"));
  Listener listener;
  Client<coppice_msgs::DockingAction> dock("docking");
  Client<move_base_msgs::MoveBaseAction> move_base("move_base");
  ASSERT_TRUE(Eventually([&] { return listener.State().header.stamp.toSec() > 1; }, kPatience));

  coppice_msgs::DockingGoal undock;
  undock.dock = false;
  dock.Send(undock);
  EXPECT_EQ(dock.Wait(), SimpleClientGoalState::SUCCEEDED) << dock->getState().getText();

  move_base.Send(Goal(5.2, 0));
  EXPECT_EQ(move_base.Wait(), SimpleClientGoalState::SUCCEEDED) << move_base->getState().getText();
  EXPECT_TRUE(listener.driving);
  EXPECT_GT(listener.longest_path, 100);
  EXPECT_TRUE(Eventually([&] {
    return listener.speed == 0 && listener.State().state == coppice_msgs::NavigationState::IDLE;
  }));

  move_base.Send(Goal(0, 0));
  EXPECT_EQ(move_base.Wait(), SimpleClientGoalState::SUCCEEDED) << move_base->getState().getText();
  coppice_msgs::DockingGoal back;
  back.dock = true;
  dock.Send(back);
  EXPECT_EQ(dock.Wait(), SimpleClientGoalState::SUCCEEDED) << dock->getState().getText();
  EXPECT_THAT(dock->getResult()->message, HasSubstr("charging with"));

  EXPECT_EQ(navigation_.Stop(std::chrono::seconds(5)), 0);
  EXPECT_EQ(docking.Stop(std::chrono::seconds(5)), 0);
}

TEST_F(NavigationNode, AStationThatWasMovedIsFoundAlsoAfterAKillInTheMidstOfDocking) {
  StartRobot("-0.8 0 3.1416");
  std::optional<ChildProcess> docking;
  docking.emplace(std::vector<std::string>{kPrograms + "coppice-docking"}, Log("docking_killed"));
  Listener listener;
  ASSERT_TRUE(ros::service::waitForService("/simulation/inject_fault", ros::Duration(kPatience)));
  ASSERT_TRUE(InjectFault("move_station", "-0.2 0.45 -0.35"));
  coppice_msgs::DockingGoal goal;
  goal.dock = true;
  {
    Client<coppice_msgs::DockingAction> dock("docking");
    dock.Send(goal);
    ASSERT_TRUE(Eventually([&] { return listener.speed > 0.05; }, kPatience));
    kill(docking->pid(), SIGKILL);
    ASSERT_TRUE(Eventually([&] { return !docking->IsRunning(); }, kPatience));
  }
  docking.emplace(std::vector<std::string>{kPrograms + "coppice-docking"}, Log("docking_anew"));
  Client<coppice_msgs::DockingAction> dock("docking");
  dock.Send(goal);
  EXPECT_EQ(dock.Wait(), SimpleClientGoalState::SUCCEEDED) << dock->getState().getText();
  EXPECT_THAT(dock->getResult()->message, HasSubstr("charging with"));
}

TEST_F(NavigationNode, AnswersLikeMoveBase) {
  StartRobot("4 0 0");
  Listener listener;
  Client<move_base_msgs::MoveBaseAction> move_base("move_base");
  Client<coppice_msgs::MotionAction> motion("motion");
  ASSERT_TRUE(Eventually([] { return FindsAWay(5, 0); }, kPatience));

  move_base.Send(Goal(5, 1.2));
  EXPECT_EQ(move_base.Wait(), SimpleClientGoalState::ABORTED);
  EXPECT_THAT(move_base->getState().getText(), HasSubstr("is blocked"));
  EXPECT_TRUE(Eventually([&] { return listener.State().consecutive_failures == 1; }));

  auto invalid = Goal(5, 0);
  invalid.target_pose.pose.orientation.w = 0;
  move_base.Send(invalid);
  EXPECT_EQ(move_base.Wait(), SimpleClientGoalState::ABORTED);

  move_base.Send(Goal(30, 0));
  ASSERT_TRUE(Eventually([&] { return listener.speed > 0.3; }, kPatience));
  move_base->cancelGoal();
  EXPECT_EQ(move_base.Wait(), SimpleClientGoalState::PREEMPTED);
  EXPECT_TRUE(Eventually([&] { return listener.speed == 0; }));

  // A motion holds up the running goal, which goes on afterwards.
  move_base.Send(Goal(11, 0));
  ASSERT_TRUE(Eventually([&] { return listener.speed > 0.3; }, kPatience));
  coppice_msgs::MotionGoal backwards;
  backwards.distance = -0.3;
  motion.Send(backwards);
  EXPECT_EQ(motion.Wait(), SimpleClientGoalState::SUCCEEDED) << motion->getState().getText();
  EXPECT_TRUE(motion->getResult()->ok);
  EXPECT_EQ(move_base.Wait(), SimpleClientGoalState::SUCCEEDED) << move_base->getState().getText();
  EXPECT_TRUE(Eventually([&] { return listener.State().consecutive_failures == 0; }));

  backwards.distance = -3;
  motion.Send(backwards);
  EXPECT_EQ(motion.Wait(), SimpleClientGoalState::ABORTED);
  EXPECT_THAT(motion->getResult()->message, HasSubstr("too far"));

  // Nothing to do, nothing said on /cmd_vel, once the last zero has come through.
  const auto let_pass = [&](double seconds) {
    const ros::Time stamp = listener.State().header.stamp;
    return Eventually(
        [&] { return listener.State().header.stamp > stamp + ros::Duration(seconds); });
  };
  ASSERT_TRUE(Eventually([&] { return listener.speed == 0; }));
  ASSERT_TRUE(let_pass(2));
  const int commands = listener.commands;
  ASSERT_TRUE(let_pass(3));
  EXPECT_EQ(listener.commands, commands);
}

// Stands between the scanner and the programs; blinded, it passes on scans that tell nothing.
class BlindableScanner {
 public:
  explicit BlindableScanner(ros::NodeHandle& node)
      : publisher_(node.advertise<sensor_msgs::LaserScan>("/scan", 5)),
        subscriber_(node.subscribe<sensor_msgs::LaserScan>(
            "/scan_seen", 5, [this](const sensor_msgs::LaserScan::ConstPtr& seen) {
              sensor_msgs::LaserScan scan = *seen;
              if (is_blind) scan.ranges.assign(scan.ranges.size(), NAN);
              publisher_.publish(scan);
            })) {}
  ~BlindableScanner() { subscriber_.shutdown(); }

  std::atomic<bool> is_blind{false};

 private:
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

TEST_F(NavigationNode, AScanThatTellsNothingIsNoFreeWay) {
  ros::NodeHandle node;
  BlindableScanner scanner(node);
  StartRobot("4 0 0", {}, {"/scan:=/scan_seen"});
  Listener listener;
  Client<move_base_msgs::MoveBaseAction> move_base("move_base");
  ASSERT_TRUE(Eventually([&] { return listener.State().header.stamp.toSec() > 1; }, kPatience));
  ASSERT_TRUE(Eventually(
      [&] {
        if (move_base->getState().isDone()) move_base.Send(Goal(30, 0));
        return listener.speed > 0.3;
      },
      kPatience));
  scanner.is_blind = true;
  EXPECT_TRUE(Eventually([&] { return listener.speed == 0; }, kPatience));
  EXPECT_TRUE(
      Eventually([&] { return listener.State().message.find("no laser scan") == 0; }, kPatience))
      << listener.State().message;
  scanner.is_blind = false;
  EXPECT_TRUE(Eventually([&] { return listener.speed > 0.3; }, kPatience));
}

TEST_F(NavigationNode, DrivesAroundABoxThatOnlyTheSonarsHear) {
  const TemporaryFolder folder;
  std::ofstream(folder.Path("hall.yaml"))
      << "name: hall\nwall_height: 2.5\n"
         "walls: [[[0, -2], [12, -2], [12, 2], [0, 2], [0, -2]]]\n"
         "places: [{name: box, at: [6, 0], size: [0.4, 0.6], height: 0.15}]\n"
         "charging_station: {docked: [1, 0, 0], staging: [1.5, 0, 0]}\n";
  StartRobot("2 0 0", {}, {"_floor:=" + folder.Path("hall.yaml")});
  ros::NodeHandle node;
  std::atomic<double> aside{0};  // of the box, when the robot was beside it
  const ros::Subscriber truth = node.subscribe<geometry_msgs::PoseStamped>(
      "/simulation/truth", 20, [&](const geometry_msgs::PoseStamped::ConstPtr& message) {
        const geometry_msgs::Point& at = message->pose.position;
        if (std::abs(at.x - 6) < 0.2) aside = std::abs(at.y);
      });
  Listener listener;
  Client<move_base_msgs::MoveBaseAction> move_base("move_base");
  ASSERT_TRUE(Eventually([] { return FindsAWay(10, 0); }, kPatience)) << TextOf(Log("simulator"));
  coppice_msgs::InjectFault box;
  box.request.fault = "block_corridor";
  box.request.target = "box";
  ASSERT_TRUE(ros::service::call("/simulation/inject_fault", box) && box.response.ok);

  move_base.Send(Goal(10, 0));
  EXPECT_EQ(move_base.Wait(), SimpleClientGoalState::SUCCEEDED) << move_base->getState().getText();
  EXPECT_GT(aside, 0.3 + 0.33);
}

using Way = Latest<std_msgs::Float64>;

// The parameter that gives navigation a site with a station there.
std::string Station(double x, double y) {
  const std::string file = testing::TempDir() + std::to_string(getpid()) + "_places.yaml";
  std::ofstream(file) << "places: [{name: station, categories: [station], x: " << x << ", y: " << y
                      << ", yaw: 0}]\n";
  return "_places:=" + file;
}

double LengthOf(const Way& way) {
  EXPECT_TRUE(Eventually([&] { return way.get() != nullptr; }, kPatience));
  return way.get() ? way.get()->data : NAN;
}

TEST_F(NavigationNode, TellsHowFarItIsToTheStationWhileItDrivesThere) {
  StartRobot("4 0 0", {Station(-2.4, 0)});
  ros::NodeHandle node;
  const Way way(node, "/navigation/way_to_station");
  EXPECT_NEAR(LengthOf(way), 6.4, 0.5);
  Client<move_base_msgs::MoveBaseAction> move_base("move_base");
  move_base.Send(Goal(0, 0));
  EXPECT_EQ(move_base.Wait(), SimpleClientGoalState::SUCCEEDED) << move_base->getState().getText();
  EXPECT_TRUE(Eventually([&] { return std::abs(way.get()->data - 2.4) < 0.4; }, kPatience))
      << way.get()->data;
}

TEST_F(NavigationNode, TheWayToTheStationLeadsAroundWalls) {
  StartRobot("24 3.6 0", {Station(32, 3.6)});  // two offices side by side
  ros::NodeHandle node;
  const Way way(node, "/navigation/way_to_station");
  const double length = LengthOf(way);
  EXPECT_GT(length, 11) << "the straight line is 8 m";
  EXPECT_LT(length, 16);
}

TEST_F(NavigationNode, TellsWhetherADoorIsOpenWithoutMoving) {
  StartRobot("24 0 1.5708");  // before office 103
  Listener listener;
  ASSERT_TRUE(ros::service::waitForService("move_base/make_plan", ros::Duration(kPatience)));
  ASSERT_TRUE(ros::service::waitForService("/simulation/inject_fault", ros::Duration(kPatience)));
  const auto way_in = [] { return FindsAWay(24, 3.6); };
  EXPECT_TRUE(Eventually(way_in, kPatience));
  ASSERT_TRUE(Eventually([] { return InjectFault("close_door", "door_103"); }, kPatience));
  EXPECT_TRUE(Eventually([&] { return !way_in(); }, kPatience));
  EXPECT_TRUE(InjectFault("open_door", "door_103"));
  EXPECT_TRUE(Eventually(way_in, kPatience));
  EXPECT_FALSE(listener.driving);
}

// Its goals are older than those before, as far as their stamps say.
TEST_F(NavigationNode, TakesGoalsAlsoAfterTheSimulatorHasBegunTimeAnew) {
  StartRobot("4 0 0");
  Listener listener;
  const auto now = [&] { return listener.State().header.stamp.toSec(); };
  ASSERT_TRUE(Eventually([&] { return now() > 1; }, kPatience));
  const double begin = now();
  Client<move_base_msgs::MoveBaseAction> move_base("move_base");
  ASSERT_TRUE(Eventually([&] { return FindsAWay(5, 0) && now() > begin + 20; }, kPatience));
  move_base.Send(Goal(5, 0));
  ASSERT_EQ(move_base.Wait(), SimpleClientGoalState::SUCCEEDED) << move_base->getState().getText();

  kill(simulator_.pid(), SIGKILL);
  ASSERT_TRUE(Eventually([&] { return !simulator_.IsRunning(); }, kPatience));
  StartSimulator("4 0 0");
  ASSERT_TRUE(Eventually([&] { return now() < begin + 15; }, kPatience));
  ASSERT_TRUE(Eventually([] { return FindsAWay(5, 0); }, kPatience));
  move_base.Send(Goal(5.5, 0));
  EXPECT_EQ(move_base.Wait(), SimpleClientGoalState::SUCCEEDED) << move_base->getState().getText();
}

TEST_F(NavigationNode, SaysNothingOfAWayWhereNoneLeadsToTheStation) {
  for (const std::vector<std::string>& station :
       {std::vector<std::string>(), {Station(500, 500)}}) {
    StartRobot("4 0 0", station);
    ros::NodeHandle node;
    const Way way(node, "/navigation/way_to_station");
    Client<move_base_msgs::MoveBaseAction> move_base("move_base");
    // Goals are refused until it knows the map and where it is.
    ASSERT_TRUE(Eventually(
        [&] {
          move_base.Send(Goal(5, 0));
          return move_base.Wait() == SimpleClientGoalState::SUCCEEDED;
        },
        kPatience));
    Listener listener;
    ASSERT_TRUE(Eventually([&] { return listener.State().header.stamp.toSec() > 1; }, kPatience));
    const ros::Time stamp = listener.State().header.stamp;
    ASSERT_TRUE(Eventually([&] { return listener.State().header.stamp > stamp + ros::Duration(2); },
                           kPatience));
    EXPECT_EQ(way.get(), nullptr) << (station.empty() ? "without a station" : station[0]);
    navigation_.Stop(std::chrono::seconds(5));
    simulator_.Stop(std::chrono::seconds(5));
  }
}

}  // namespace
}  // namespace coppice::robot::navigation
