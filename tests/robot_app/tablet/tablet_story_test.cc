// A visitor at the tablet: real programs, real browser. What the trees do is played.
#include <coppice_msgs/Answer.h>
#include <geometry_msgs/TransformStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <mutex>
#include <string>
#include <vector>

#include "robot_app/common/child_process.h"
#include "robot_app/processes/launch/ros_master.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/knowledge/sample_database.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/support/folders.h"

namespace coppice::robot::tablet {
namespace {

// A corridor with rooms on both sides, about as the sample's institute has them.
nav_msgs::OccupancyGrid Corridor() {
  nav_msgs::OccupancyGrid grid;
  grid.header.frame_id = "map";
  grid.info.resolution = 0.1F;
  grid.info.width = 520;
  grid.info.height = 120;
  grid.info.origin.position.x = -3;
  grid.info.origin.position.y = -6;
  grid.info.origin.orientation.w = 1;
  for (unsigned row = 0; row < grid.info.height; ++row) {
    for (unsigned column = 0; column < grid.info.width; ++column) {
      const bool is_outer =
          row < 2 || row + 2 >= grid.info.height || column < 2 || column + 2 >= grid.info.width;
      const bool is_side = (row == 47 || row == 73) && column % 80 > 12;
      const bool is_between = (row < 47 || row > 73) && column % 80 == 0;
      grid.data.push_back(is_outer || is_side || is_between ? 100 : 0);
    }
  }
  return grid;
}

class TabletStory : public testing::Test {
 protected:
  TabletStory() {
    Start("coppice-expression", {});
    Start("coppice-tablet", {"--knowledge", sample_.path(), "--places",
                             SourceFolder() + "/robot_app/config/sites/institute/places.yaml",
                             "--port", std::to_string(port_)});
    map_.publish(Corridor());
    timer_ = node_.createWallTimer(ros::WallDuration(0.1), [this](const auto&) { Localize(); });
  }
  void Start(const std::string& program, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), BinaryFolder() + "/bin/" + program);
    programs_.emplace_back(arguments, folder_ + program + ".log");
  }
  // The robot stands in the corridor.
  void Localize() {
    tf2_msgs::TFMessage message;
    for (const auto& [parent, child] : {std::pair("map", "odom"), std::pair("odom", "base_link")}) {
      geometry_msgs::TransformStamped& frame = message.transforms.emplace_back();
      frame.header.stamp = ros::Time::now();
      frame.header.frame_id = parent;
      frame.child_frame_id = child;
      frame.transform.translation.x = std::string(child) == "odom" ? 10 : 2;
      frame.transform.rotation.w = 1;
    }
    tf_.publish(message);
  }
  // As the trees do: the wish is heard, and given up.
  void OnAnswer(const coppice_msgs::Answer& answer) {
    const std::lock_guard lock(mutex_);
    if (!answer.guides) return;
    guided_to_ = answer.place;
    std_msgs::String outcome;
    outcome.data = "lost";
    outcome_.publish(outcome);
  }

  const std::string folder_ = testing::TempDir() + "tablet_" + std::to_string(getpid()) + "_";
  const int port_ = processes::FreePort();
  knowledge::SampleDatabase sample_;
  std::vector<ChildProcess> programs_;
  std::mutex mutex_;
  std::string guided_to_;
  int touches_ = 0;
  ros::NodeHandle node_;
  ros::Publisher map_ = node_.advertise<nav_msgs::OccupancyGrid>("/map", 1, true);
  ros::Publisher tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 10);
  ros::Publisher outcome_ = node_.advertise<std_msgs::String>("/visitors/outcome", 10);
  ros::Subscriber answers_ = node_.subscribe("/speech/answer", 10, &TabletStory::OnAnswer, this);
  ros::Subscriber touched_ = node_.subscribe<std_msgs::Empty>(
      "/tablet/touched", 10, [this](const std_msgs::Empty::ConstPtr&) {
        const std::lock_guard lock(mutex_);
        ++touches_;
      });
  ros::WallTimer timer_;
};

TEST_F(TabletStory, AVisitorFindsHisWayIsLedAndLeavesNothingBehind) {
  const std::string log = folder_ + "story.log";
  ChildProcess browser(
      {"/usr/bin/python3", SourceFolder() + "/tests/robot_app/tablet/tablet_story.py",
       "http://localhost:" + std::to_string(port_) + "/", BinaryFolder() + "/tests/tablet_story"},
      log);
  EXPECT_TRUE(Eventually([&] { return !browser.IsRunning(); }, 200));
  std::ifstream file(log);
  EXPECT_EQ(browser.exit_status(), 0) << std::string(std::istreambuf_iterator<char>(file), {});
  const std::lock_guard lock(mutex_);
  EXPECT_EQ(guided_to_, "office_103");
  EXPECT_GE(touches_, 1);
}

}  // namespace
}  // namespace coppice::robot::tablet
