// The programs coppice-mapping and coppice-map-server with the simulator over ROS.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <std_srvs/Trigger.h>

#include <filesystem>
#include <fstream>

#include "robot_app/common/child_process.h"
#include "robot_app/common/ros_support.h"
#include "robot_app/mapping/map_file.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/latest.h"
#include "tests/robot_app/processes/temporary.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/robot_app/text_of.h"
#include "tests/support/folders.h"

namespace coppice::robot::mapping {
namespace {

using processes::Temporary;

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr double kPatience = 30;  // wall time, for whatever is waited for [s]
const std::string kPrograms = BinaryFolder() + "/bin/";

class MappingNodeTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const std::string& file : {kMap, kUnsaved, kLastPose}) fs::remove(file);
    command_ = node_.advertise<geometry_msgs::Twist>("/cmd_vel", 1);
  }

  // The odometry is that of the wheels, which will do for some metres.
  void StartSimulator() {
    ros::param::set("/use_sim_time", true);  // before anybody starts
    simulator_ =
        ChildProcess({kPrograms + "coppice-simulator", "_speed:=4", "_start:=2 0 0",
                      "_localization:=false", "/map:=/simulation/map", "/odom:=/odometry/filtered"},
                     Temporary("simulator.log"));
  }
  void StartMapping() {
    mapping_ = ChildProcess({kPrograms + "coppice-mapping", "_map_file:=" + kMap,
                             "_last_pose_file:=" + kLastPose, "_start_pose:=2 0 0"},
                            Temporary("mapping.log"));
  }
  void StartMapServer(const std::string& argument) {
    server_ = ChildProcess({kPrograms + "coppice-map-server", "_map:=" + kMap, argument},
                           Temporary("map_server.log"));
  }
  static int RunToTheEnd(const std::vector<std::string>& command, const std::string& log) {
    ChildProcess process(command, log);
    EXPECT_TRUE(Eventually([&] { return !process.IsRunning(); }, kPatience));
    return process.exit_status();
  }

  bool DriveUntil(const std::function<bool()>& done) {
    return Eventually(
        [&] {
          geometry_msgs::Twist twist;
          twist.linear.x = 0.4;
          command_.publish(twist);
          return done();
        },
        kPatience);
  }
  static bool Shows(const boost::shared_ptr<const nav_msgs::OccupancyGrid>& map, double x,
                    double y) {
    if (!map) return false;
    const Expected<OccupancyGrid> grid = ToGrid(*map);
    if (!grid) return false;
    const Cell cell = grid->frame.CellAt(x, y);
    return grid->frame.Contains(cell) &&
           grid->cells[grid->frame.Index(cell)] >= OccupancyGrid::kOccupied;
  }

  const std::string kMap = Temporary("map.yaml");
  const std::string kUnsaved = Temporary("map_unsaved.yaml");
  const std::string kLastPose = Temporary("last_pose");
  ros::NodeHandle node_;
  ros::Publisher command_;
  ChildProcess simulator_;
  ChildProcess mapping_;
  ChildProcess server_;
};

TEST_F(MappingNodeTest, MapsSavesAndLeavesWhatIsUnsaved) {
  StartSimulator();
  StartMapping();
  const Latest<nav_msgs::OccupancyGrid> map(node_, "/map");
  const Latest<geometry_msgs::PoseStamped> truth(node_, "/simulation/truth");
  const Latest<diagnostic_msgs::DiagnosticArray> state(node_, "/diagnostics");
  const RobotPose frames({"map", "odom", "base_link"});
  ASSERT_TRUE(Eventually([&] { return map.get() != nullptr; }, kPatience)) << "where it begins";
  ASSERT_TRUE(DriveUntil([&] { return truth.get() && truth.get()->pose.position.x > 4; }));
  // The wall of the corridor, half a cell to either side.
  ASSERT_TRUE(Eventually([&] { return Shows(map.get(), 3, 1.26) || Shows(map.get(), 3, 1.24); },
                         kPatience));
  EXPECT_EQ(map.get()->header.frame_id, "map");
  EXPECT_TRUE(Eventually(
      [&] {
        const auto pose = frames.Newest();
        return pose && Distance(pose->pose, ToPose2D(truth.get()->pose)) < 0.1;
      },
      kPatience));
  EXPECT_TRUE(Eventually([&] { return state.get() && state.get()->status[0].message == "maps"; },
                         kPatience));

  std_srvs::Trigger save;
  ASSERT_TRUE(ros::service::call("/mapping/save", save));
  EXPECT_TRUE(save.response.success) << save.response.message;
  Diagnostics diagnostics;
  EXPECT_TRUE(LoadMap(kMap, diagnostics)) << diagnostics.ToString();
  EXPECT_FALSE(fs::exists(kUnsaved));

  ASSERT_TRUE(DriveUntil([&] { return truth.get()->pose.position.x > 5.5; }));
  EXPECT_EQ(mapping_.Stop(std::chrono::seconds(10)), 0);
  EXPECT_TRUE(LoadMap(kUnsaved, diagnostics)) << diagnostics.ToString();
  EXPECT_THAT(TextOf(kLastPose), testing::StartsWith("5."));
}

TEST_F(MappingNodeTest, SaysWhyItCannotSave) {
  StartMapping();
  std_srvs::Trigger save;
  ASSERT_TRUE(ros::service::waitForService("/mapping/save", ros::Duration(kPatience)));
  ASSERT_TRUE(ros::service::call("/mapping/save", save));
  EXPECT_FALSE(save.response.success);
  EXPECT_THAT(save.response.message, HasSubstr("no map yet"));
  EXPECT_EQ(mapping_.Stop(std::chrono::seconds(10)), 0);
  EXPECT_FALSE(fs::exists(kUnsaved));
}

TEST_F(MappingNodeTest, TheServerShowsTheSavedMapOrAStandIn) {
  StartSimulator();
  StartMapServer("_stand_in_topic:=/simulation/map");
  {
    const Latest<nav_msgs::OccupancyGrid> map(node_, "/map");
    EXPECT_TRUE(Eventually([&] { return Shows(map.get(), 40, 3); }, kPatience));  // the hall
  }
  EXPECT_EQ(server_.Stop(std::chrono::seconds(5)), 0);

  OccupancyGrid small;
  small.frame = {0.05, 1, 1, 3, 2};
  small.cells = {0, 0, 0, 0, 100, 0};
  Diagnostics diagnostics;
  ASSERT_TRUE(SaveMap(kMap, small, diagnostics));
  StartMapServer("_stand_in_topic:=/simulation/map");
  const Latest<nav_msgs::OccupancyGrid> map(node_, "/map");
  EXPECT_TRUE(Eventually([&] { return Shows(map.get(), 1.075, 1.075); }, kPatience));
  EXPECT_EQ(map.get()->data.size(), 6u);
}

TEST_F(MappingNodeTest, RefuseWhatMakesNoSense) {
  const std::string log = Temporary("refused.log");
  const std::string server = kPrograms + "coppice-map-server";
  const std::string mapping = kPrograms + "coppice-mapping";
  EXPECT_EQ(RunToTheEnd({server, "__name:=a", "_map:=/does/not/exist.yaml"}, log), 2);
  EXPECT_THAT(TextOf(log), HasSubstr("/does/not/exist.yaml"));
  std::ofstream(kMap) << "image: nothing.pgm\n";
  EXPECT_EQ(RunToTheEnd({server, "__name:=b", "_map:=" + kMap, "_stand_in_topic:=/x"}, log), 2);
  EXPECT_THAT(TextOf(log), HasSubstr("resolution"));
  EXPECT_EQ(RunToTheEnd({mapping, "__name:=c", "_start_pose:=here"}, log), 2);
  EXPECT_THAT(TextOf(log), HasSubstr("X Y YAW"));
  EXPECT_EQ(RunToTheEnd({mapping, "__name:=d", "_range:=-3"}, log), 2);
  EXPECT_EQ(RunToTheEnd({mapping, "--help"}, log), 0);
}

}  // namespace
}  // namespace coppice::robot::mapping
