// Attacks on the robot's programs by messages of broken drivers: the real programs, with the
// simulator and over ROS. What is said is what was measured, but for the time, or for the numbers.
#include <coppice_msgs/LocalizationState.h>
#include <coppice_msgs/MotionActionGoal.h>
#include <coppice_msgs/MotionActionResult.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/Twist.h>
#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/BatteryState.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/Range.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <sstream>

#include "robot_app/common/child_process.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/latest.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/robot_app/text_of.h"
#include "tests/support/folders.h"

namespace coppice::robot {
namespace {

using coppice_msgs::LocalizationState;

constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();

ros::Time Wild(std::uint32_t seconds, std::uint32_t nanoseconds) {
  ros::Time time;  // which takes them as they are, as a message does
  time.sec = seconds;
  time.nsec = nanoseconds;
  return time;
}

// Stamps that no clock has, or not now.
std::vector<ros::Time> WildStamps(std::uint32_t now) {
  return {Wild(0, 0),         Wild(0, kMost),          Wild(now, kMost),   Wild(now + 3600, 0),
          Wild(1U << 31U, 0), Wild(1U << 31U, kMost),  Wild(kMost - 5, 5), Wild(kMost, 0),
          Wild(kMost, kMost), Wild(kMost, 999'999'999)};
}

// That a program has had so far [kB].
int MostMemory(int pid) {
  std::istringstream status(TextOf("/proc/" + std::to_string(pid) + "/status"));
  std::string line;
  while (std::getline(status, line) && line.rfind("VmHWM:", 0) != 0) continue;
  return std::stoi(line.substr(6));
}

class MessageAttack : public testing::Test {
 protected:
  MessageAttack() {
    ros::param::set("/use_sim_time", true);  // before anybody starts
    Start({"coppice-simulator", "_localization:=false", "_odometry_tf:=false"});
  }

  void Start(std::vector<std::string> command) {
    names_.push_back(command.front());
    command.front() = BinaryFolder() + "/bin/" + command.front();
    programs_.emplace_back(command, Log(names_.back()));
  }
  static std::string Log(const std::string& name) {
    return testing::TempDir() + "message_attack_" + std::to_string(getpid()) + "_" + name + ".log";
  }

  void ExpectAllRun() {
    for (std::size_t i = 0; i < programs_.size(); ++i) {
      EXPECT_TRUE(programs_[i].IsRunning()) << names_[i] << ": " << TextOf(Log(names_[i]));
    }
  }

  // What is heard of the driver is said again, changed.
  template <typename Message>
  void SayAgain(const std::string& topic, const std::function<void(Message&)>& change, int times) {
    const Latest<Message> honest(node_, topic);
    ros::Publisher broken = node_.advertise<Message>(topic, 100);
    int said = 0;
    boost::shared_ptr<const Message> last;
    ASSERT_TRUE(Eventually([&] {
      const auto newest = honest.get();
      if (!newest || newest == last) return false;
      last = newest;
      Message message = *newest;
      change(message);
      broken.publish(message);
      return ++said == times;
    })) << topic;
  }
  template <typename Message>
  void SayAtWildTimes(const std::string& topic) {
    ASSERT_TRUE(Eventually([&] { return clock_.get() != nullptr; }));
    for (const ros::Time& stamp : WildStamps(clock_.get()->clock.sec)) {
      SayAgain<Message>(
          topic, [&](Message& message) { message.header.stamp = stamp; }, 3);
      if (HasFatalFailure()) return;
    }
  }

  double Now() const { return clock_.get()->clock.toSec(); }

  ros::NodeHandle node_;
  const Latest<rosgraph_msgs::Clock> clock_{node_, "/clock"};
  std::deque<ChildProcess> programs_;
  std::vector<std::string> names_;
};

TEST_F(MessageAttack, StampsThatNoClockHasEndNoDrivingAndMisplaceNothing) {
  Start({"coppice-odometry-filter"});
  Start({"coppice-localization", "_start_pose:=-2.4 0 3.14159"});
  Start({"coppice-navigation"});
  Start({"coppice-docking"});
  const Latest<LocalizationState> state(node_, "/localization/state");
  const auto is_placed = [&] { return state.get() && state.get()->phase == LocalizationState::OK; };
  ASSERT_TRUE(Eventually(is_placed));
  std::atomic<double> furthest{0};  // from now, of what is told on [s]
  const ros::Subscriber filtered = node_.subscribe<nav_msgs::Odometry>(
      "/odometry/filtered", 100, [&](const nav_msgs::Odometry::ConstPtr& message) {
        const double off = std::abs(message->header.stamp.toSec() - Now());
        if (off > furthest) furthest = off;
      });

  SayAtWildTimes<nav_msgs::Odometry>("/odom");
  SayAtWildTimes<sensor_msgs::Imu>("/imu/data");
  EXPECT_LT(furthest, 10) << "what the filter publishes";
  SayAtWildTimes<sensor_msgs::LaserScan>("/scan");
  SayAtWildTimes<sensor_msgs::Range>("/sonar/front");
  SayAtWildTimes<sensor_msgs::BatteryState>("/battery_state");
  EXPECT_TRUE(is_placed()) << state.get()->message;
  SayAtWildTimes<nav_msgs::Odometry>("/odometry/filtered");
  ExpectAllRun();
  const double then = Now();
  EXPECT_TRUE(Eventually([&] {
    return is_placed() && state.get()->header.stamp.toSec() > then + 1;
  })) << state.get()->message;
}

TEST_F(MessageAttack, StampsThatNoClockHasEndNoMappingAndNoPerception) {
  Start({"coppice-odometry-filter"});
  Start({"coppice-mapping"});
  Start({"coppice-people"});
  const Latest<tf2_msgs::TFMessage> transforms(node_, "/tf");
  SayAtWildTimes<sensor_msgs::LaserScan>("/scan");
  SayAtWildTimes<nav_msgs::Odometry>("/odometry/filtered");
  SayAtWildTimes<sensor_msgs::PointCloud2>("/velodyne_points");
  ExpectAllRun();
  const double then = Now();
  EXPECT_TRUE(Eventually([&] {
    const auto newest = transforms.get();
    return newest && newest->transforms.front().header.frame_id == "map" &&
           newest->transforms.front().header.stamp.toSec() > then;
  })) << "the mapping goes on";
}

// Backwards nothing looks, so the way is limited: it must not be measured from nowhere.
TEST_F(MessageAttack, OdometryThatIsNoNumberLeavesNoMotionWithoutAnEnd) {
  Start({"coppice-odometry-filter"});
  Start({"coppice-navigation"});
  const Latest<coppice_msgs::MotionActionResult> result(node_, "/motion/result");
  ros::Publisher goals = node_.advertise<coppice_msgs::MotionActionGoal>("/motion/goal", 1, true);
  const Latest<geometry_msgs::Twist> command(node_, "/cmd_vel");
  coppice_msgs::MotionActionGoal goal;
  goal.goal.distance = -0.3;
  goal.goal.angle = 0.5;
  goal.goal_id.id = "backwards";
  ASSERT_TRUE(Eventually([&] { return clock_.get() != nullptr; }));
  const Latest<nav_msgs::Odometry> filtered(node_, "/odometry/filtered");
  ASSERT_TRUE(Eventually([&] { return goals.getNumSubscribers() > 0 && filtered.get(); }));
  goals.publish(goal);
  ASSERT_TRUE(Eventually([&] { return command.get() && command.get()->linear.x < 0; }));
  const double begun = Now();
  ASSERT_TRUE(Eventually([&] {
    SayAgain<nav_msgs::Odometry>(
        "/odom",
        [](nav_msgs::Odometry& message) {
          message.pose.pose.position.x = std::numeric_limits<double>::quiet_NaN();
        },
        5);
    return result.get() || Now() > begun + 20;
  }));
  EXPECT_TRUE(result.get()) << "it drives still: " << (command.get() ? command.get()->linear.x : 0)
                            << " m/s";
  ExpectAllRun();
}

// Cells of 5 m, by a slip of the one who wrote the map's file; and a building of a quarter of a
// kilometre, of which there are too many cells.
TEST_F(MessageAttack, MapsForWhichThereIsNoRoomEndNothingAndTheOldOneHolds) {
  Start({"coppice-odometry-filter"});
  Start({"coppice-localization", "_start_pose:=-2.4 0 3.14159"});
  Start({"coppice-navigation"});
  const Latest<LocalizationState> state(node_, "/localization/state");
  const auto is_placed = [&] { return state.get() && state.get()->phase == LocalizationState::OK; };
  ASSERT_TRUE(Eventually(is_placed));
  ros::Publisher maps = node_.advertise<nav_msgs::OccupancyGrid>("/map", 5);
  ASSERT_TRUE(Eventually([&] { return maps.getNumSubscribers() == 2; }));
  for (const auto& [resolution, width] : {std::pair(5.0F, 400U), {0.05F, 5000U}, {1.0F, 1100U}}) {
    nav_msgs::OccupancyGrid map;
    map.info.resolution = resolution;
    map.info.width = map.info.height = width;
    map.info.origin.orientation.w = 1;
    map.data.resize(std::size_t{width} * width);
    maps.publish(map);
  }
  const auto has_refused = [](const std::string& name) {
    const std::string log = TextOf(Log(name));
    return log.find("1100 x 1100 cells") != std::string::npos;  // the last one
  };
  EXPECT_TRUE(Eventually(
      [&] { return has_refused("coppice-localization") && has_refused("coppice-navigation"); }));
  ExpectAllRun();
  const double then = Now();
  EXPECT_TRUE(
      Eventually([&] { return is_placed() && state.get()->header.stamp.toSec() > then + 1; }));
}

// A scanner that sees without end, by its own words, in a hall that is open on one side.
TEST_F(MessageAttack, AReadingFromLightYearsAwayHoldsNothingUp) {
  Start({"coppice-odometry-filter"});
  Start({"coppice-localization", "_start_pose:=-2.4 0 3.14159"});
  const Latest<LocalizationState> state(node_, "/localization/state");
  ASSERT_TRUE(Eventually([&] { return state.get() && state.get()->score > 0; }));
  const Latest<nav_msgs::OccupancyGrid> honest(node_, "/map");
  ros::Publisher maps = node_.advertise<nav_msgs::OccupancyGrid>("/map", 1, true);
  ASSERT_TRUE(Eventually([&] { return honest.get() && maps.getNumSubscribers() == 2; }));
  nav_msgs::OccupancyGrid open = *honest.get();
  for (std::size_t i = 0; i < open.data.size(); ++i) {
    if (i % open.info.width / 40 % 2 == 0) open.data[i] = 0;
  }
  maps.publish(open);
  SayAgain<sensor_msgs::LaserScan>(
      "/scan",
      [](sensor_msgs::LaserScan& scan) {
        scan.header.stamp += ros::Duration(0.001);  // or it would say nothing new
        scan.range_max = std::numeric_limits<float>::infinity();
        for (std::size_t i = 0; i < scan.ranges.size(); i += 3) scan.ranges[i] = 1e30F;
      },
      20);
  const double then = Now();
  EXPECT_TRUE(Eventually([&] { return state.get()->header.stamp.toSec() > then + 1; }, 20));
  ExpectAllRun();
}

// Whoever detects things may give each a frame of its own.
TEST_F(MessageAttack, FramesWithoutEndTakeNoMemoryAndMisplaceNothing) {
  Start({"coppice-odometry-filter"});
  Start({"coppice-localization", "_start_pose:=-2.4 0 3.14159"});
  const Latest<LocalizationState> state(node_, "/localization/state");
  const auto is_placed = [&] { return state.get() && state.get()->phase == LocalizationState::OK; };
  ASSERT_TRUE(Eventually(is_placed));
  ros::Publisher broken = node_.advertise<tf2_msgs::TFMessage>("/tf", 100);
  ASSERT_TRUE(Eventually([&] { return broken.getNumSubscribers() >= 2; }));
  const int localization = programs_.back().pid();
  const int before = MostMemory(localization);
  for (int i = 0; i < 50'000; ++i) {
    static tf2_msgs::TFMessage message;
    geometry_msgs::TransformStamped& one = message.transforms.emplace_back();
    one.header.stamp = clock_.get()->clock;
    one.header.frame_id = "map";
    one.child_frame_id = "box_" + std::to_string(i);
    one.transform.rotation.w = 1;
    if (message.transforms.size() < 1000) continue;
    broken.publish(message);
    message.transforms.clear();
  }
  EXPECT_TRUE(Eventually([] {
    return TextOf(Log("coppice-localization")).find("too many frames") != std::string::npos;
  }));
  const double then = Now();
  EXPECT_TRUE(Eventually([&] {
    return is_placed() && state.get()->header.stamp.toSec() > then + 1;
  })) << state.get()->message;
  ExpectAllRun();
  EXPECT_LT(MostMemory(localization) - before, 40'000) << "kilobytes more";
}

}  // namespace
}  // namespace coppice::robot
