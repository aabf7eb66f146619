// The programs coppice-odometry-filter and coppice-localization with the simulator over ROS.
#include <coppice_msgs/InjectFault.h>
#include <coppice_msgs/LocalizationState.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/Twist.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <std_srvs/Empty.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "robot_app/common/child_process.h"
#include "robot_app/common/ros_support.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/latest.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/robot_app/text_of.h"
#include "tests/support/folders.h"

namespace coppice::robot::localization {
namespace {

using State = coppice_msgs::LocalizationState;
constexpr double kPatience = 30;  // wall time, for whatever is waited for [s]
const std::string kPrograms = BinaryFolder() + "/bin/";

// Tests run at the same time.
std::string Own(const std::string& name) {
  return testing::TempDir() + std::to_string(getpid()) + "_" + name;
}

std::string Log(const std::string& name) { return Own(name + ".log"); }

class LocalizationNodeTest : public testing::Test {
 protected:
  LocalizationNodeTest() {
    std::filesystem::remove(kLastPose);
    command_ = node_.advertise<geometry_msgs::Twist>("/cmd_vel", 1);
    set_pose_ = node_.advertise<geometry_msgs::PoseWithCovarianceStamped>("/initialpose", 1);
    ros::param::set("/use_sim_time", true);  // before anybody starts
    simulator_ = ChildProcess({kPrograms + "coppice-simulator", "_speed:=4", "_localization:=false",
                               "_odometry_tf:=false"},
                              Log("simulator"));
    StartFilter();
    StartLocalization();
  }

  void StartFilter() {
    filter_ = ChildProcess({kPrograms + "coppice-odometry-filter"}, Log("odometry_filter"));
  }
  void StartLocalization(const std::vector<std::pair<std::string, std::string>>& environment = {}) {
    localization_ = ChildProcess({kPrograms + "coppice-localization", "_start_pose:=-2.4 0 3.14159",
                                  "_last_pose_file:=" + kLastPose},
                                 Log("localization"), environment);
  }
  static void Kill(ChildProcess& process) {
    kill(process.pid(), SIGKILL);
    EXPECT_TRUE(Eventually([&] { return !process.IsRunning(); }));
  }

  bool WaitForPhase(int phase) {
    return Eventually([&] { return state_.get() && state_.get()->phase == phase; }, kPatience);
  }
  bool TurnUntilOk() {
    return Eventually(
        [&] {
          geometry_msgs::Twist twist;
          twist.angular.z = 0.6;
          command_.publish(twist);
          return state_.get() && state_.get()->phase == State::OK;
        },
        kPatience);
  }
  // base_link as tf tells it, against the truth.
  bool IsWhereItShouldBe(double within) {
    return Eventually(
        [&] {
          const auto truth = truth_.get();
          const auto pose = frames_.Newest();
          return truth && pose && Distance(pose->pose, ToPose2D(truth->pose)) < within;
        },
        kPatience);
  }
  void Kidnap(const std::string& where) {
    EXPECT_TRUE(Eventually(
        [&] {  // somebody may stand there
          coppice_msgs::InjectFault service;
          service.request.fault = "kidnap";
          service.request.target = where;
          return ros::service::call("/simulation/inject_fault", service) && service.response.ok;
        },
        kPatience));
  }

  const std::string kLastPose = Own("localization_last_pose");
  ros::NodeHandle node_;
  ros::Publisher command_;
  ros::Publisher set_pose_;
  ChildProcess simulator_;
  ChildProcess filter_;
  ChildProcess localization_;
  Latest<State> state_{node_, "/localization/state"};
  Latest<geometry_msgs::PoseStamped> truth_{node_, "/simulation/truth"};
  Latest<nav_msgs::OccupancyGrid> map_{node_, "/map"};
  Latest<nav_msgs::Odometry> filtered_{node_, "/odometry/filtered"};
  Latest<geometry_msgs::PoseWithCovarianceStamped> pose_{node_, "/localization/pose"};
  RobotPose frames_{{"map", "odom", "base_link"}};
};

TEST_F(LocalizationNodeTest, FindsTheCarriedRobotByATurnAndByAPerson) {
  ASSERT_TRUE(WaitForPhase(State::OK)) << TextOf(Log("localization"));
  EXPECT_TRUE(IsWhereItShouldBe(0.03));
  ASSERT_TRUE(pose_.get());
  EXPECT_EQ(pose_.get()->header.frame_id, "map");
  EXPECT_GT(pose_.get()->pose.covariance[0], 0);
  EXPECT_GT(state_.get()->score, 0.8);
  EXPECT_LT(state_.get()->deviation, 0.3);

  Kidnap("hall_centre");
  ASSERT_TRUE(WaitForPhase(State::LOST));
  ASSERT_TRUE(TurnUntilOk()) << state_.get()->message;
  EXPECT_TRUE(IsWhereItShouldBe(0.1));

  // Whoever shows the map was restarted: the same map again does not make it begin anew, which it
  // would on the station.
  const auto map = map_.get();
  ASSERT_TRUE(map);
  ros::Publisher other = node_.advertise<nav_msgs::OccupancyGrid>("/map", 1, true);
  other.publish(*map);
  const double shown = state_.get()->header.stamp.toSec();
  ASSERT_TRUE(Eventually([&] { return other.getNumSubscribers() > 1; }, kPatience));
  EXPECT_TRUE(Eventually(
      [&] {
        EXPECT_NE(state_.get()->phase, State::LOST) << state_.get()->message;
        return state_.get()->phase == State::LOST || state_.get()->header.stamp.toSec() > shown + 5;
      },
      kPatience));
  EXPECT_TRUE(IsWhereItShouldBe(0.1));
  other.shutdown();

  Kidnap("32.4 3.8 1.5");  // an office that looks like another one
  ASSERT_TRUE(WaitForPhase(State::LOST));
  const auto truth = truth_.get();
  geometry_msgs::PoseWithCovarianceStamped pose;
  pose.header.frame_id = "elsewhere";
  pose.pose.pose = truth->pose;
  pose.pose.pose.position.x += 0.3;
  set_pose_.publish(pose);
  pose.header.frame_id = "map";
  set_pose_.publish(pose);
  EXPECT_TRUE(WaitForPhase(State::OK)) << state_.get()->message;
  EXPECT_TRUE(IsWhereItShouldBe(0.1));
}

TEST_F(LocalizationNodeTest, GoesOnAfterRestartsOfEither) {
  ASSERT_TRUE(WaitForPhase(State::OK)) << TextOf(Log("localization"));
  Kidnap("hall_centre");
  ASSERT_TRUE(WaitForPhase(State::LOST));
  ASSERT_TRUE(TurnUntilOk());
  EXPECT_TRUE(Eventually([&] {
    return TextOf(kLastPose).rfind("46", 0) == 0 || TextOf(kLastPose).rfind("45.9", 0) == 0;
  })) << TextOf(kLastPose);

  Kill(filter_);
  filtered_.Forget();
  StartFilter();
  EXPECT_TRUE(Eventually([&] { return filtered_.get() != nullptr; }, kPatience));
  EXPECT_TRUE(WaitForPhase(State::OK)) << state_.get()->message;
  EXPECT_TRUE(IsWhereItShouldBe(0.1));

  // It begins anew, with the last pose as the first idea; no turn is needed.
  Kill(localization_);
  state_.Forget();
  StartLocalization();
  EXPECT_TRUE(WaitForPhase(State::OK)) << TextOf(Log("localization"));
  EXPECT_TRUE(IsWhereItShouldBe(0.1));

  // If that idea is wrong it is not believed.
  Kill(localization_);
  state_.Forget();
  Kidnap("corridor_east_end");
  StartLocalization();
  ASSERT_TRUE(WaitForPhase(State::LOST)) << TextOf(Log("localization"));
  ASSERT_TRUE(TurnUntilOk()) << state_.get()->message;
  EXPECT_TRUE(IsWhereItShouldBe(0.1));

  std_srvs::Empty nothing;
  ASSERT_TRUE(ros::service::call("/global_localization", nothing));
  EXPECT_TRUE(Eventually([&] { return state_.get()->phase != State::OK; }));
  EXPECT_TRUE(TurnUntilOk());
  EXPECT_EQ(localization_.Stop(std::chrono::seconds(5)), 0);
  EXPECT_EQ(filter_.Stop(std::chrono::seconds(5)), 0);
}

TEST_F(LocalizationNodeTest, DoesNotWaitForADiskThatIsSlow) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer wants to be loaded first";
#endif
  ASSERT_TRUE(WaitForPhase(State::OK)) << TextOf(Log("localization"));
  localization_.Stop(std::chrono::seconds(5));
  std::filesystem::remove(kLastPose);
  state_.Forget();
  const std::string ready = Own("disk_ready");
  StartLocalization({{"LD_PRELOAD", BinaryFolder() + "/tests/lib/libtest_slow_disk.so"},
                     {"COPPICE_TEST_DISK_READY", ready}});
  ASSERT_TRUE(WaitForPhase(State::OK)) << TextOf(Log("localization"));
  const double begun = state_.get()->header.stamp.toSec();
  EXPECT_TRUE(Eventually([&] { return state_.get()->header.stamp.toSec() > begun + 10; }));
  EXPECT_TRUE(WaitForPhase(State::OK));
  EXPECT_TRUE(IsWhereItShouldBe(0.03));
  EXPECT_FALSE(std::filesystem::exists(kLastPose)) << "the disk has not taken it yet";
  std::ofstream(ready) << "now\n";
  EXPECT_TRUE(Eventually([&] { return std::filesystem::exists(kLastPose); }));
  EXPECT_EQ(localization_.Stop(std::chrono::seconds(5)), 0);
}

}  // namespace
}  // namespace coppice::robot::localization
