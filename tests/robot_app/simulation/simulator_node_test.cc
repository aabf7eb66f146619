#include <coppice_msgs/InjectFault.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <gmock/gmock.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/BatteryState.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

#include "robot_app/common/child_process.h"
#include "robot_app/common/compressed_picture.h"
#include "robot_app/perception/people/cloud_decoder.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/robot_app/text_of.h"
#include "tests/support/folders.h"

namespace coppice::robot::simulation {
namespace {

using testing::HasSubstr;

const std::string kSimulator = BinaryFolder() + "/bin/coppice-simulator";

// Keeps the newest message of a topic.
template <typename Message>
class Latest {
 public:
  Latest(ros::NodeHandle& node, const std::string& topic)
      : subscriber_(node.subscribe<Message>(
            topic, 5, [this](const boost::shared_ptr<const Message>& message) {
              const std::lock_guard<std::mutex> lock(mutex_);
              message_ = *message;
              ++count_;
            })) {}
  ~Latest() { subscriber_.shutdown(); }

  Message get() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return message_;
  }
  int count() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return count_;
  }

 private:
  mutable std::mutex mutex_;
  Message message_;
  int count_ = 0;
  ros::Subscriber subscriber_;
};

std::string Log(const std::string& name) {
  return testing::TempDir() + std::to_string(getpid()) + "_" + name + ".log";
}

// Runs the program to its end; returns its exit status.
int RunToTheEnd(std::vector<std::string> arguments, const std::string& log,
                const std::vector<std::pair<std::string, std::string>>& environment = {}) {
  arguments.insert(arguments.begin(), kSimulator);
  ChildProcess process(arguments, log, environment);
  EXPECT_TRUE(Eventually([&] { return !process.IsRunning(); }, 15));
  return process.exit_status();
}

bool HasFrame(const tf2_msgs::TFMessage& message, const std::string& name) {
  const auto is_it = [&](const auto& frame) { return frame.child_frame_id == name; };
  return std::any_of(message.transforms.begin(), message.transforms.end(), is_it);
}

class SimulatorNodeTest : public testing::Test {
 protected:
  coppice_msgs::InjectFault::Response Inject(const std::string& fault, const std::string& target,
                                             double value = 0) {
    coppice_msgs::InjectFault service;
    service.request.fault = fault;
    service.request.target = target;
    service.request.value = value;
    EXPECT_TRUE(ros::service::call("/simulation/inject_fault", service)) << fault;
    return service.response;
  }

  ros::NodeHandle node_;
};

TEST_F(SimulatorNodeTest, DrivesSeesAndBreaksOnRequestAndEndsOnSigterm) {
  Latest<nav_msgs::Odometry> odom(node_, "/odom");
  Latest<sensor_msgs::LaserScan> scan(node_, "/scan");
  Latest<rosgraph_msgs::Clock> clock(node_, "/clock");
  Latest<geometry_msgs::PoseStamped> truth(node_, "/simulation/truth");
  Latest<sensor_msgs::BatteryState> battery(node_, "/battery_state");
  ros::Publisher command = node_.advertise<geometry_msgs::Twist>("/cmd_vel", 1);
  ChildProcess simulator({kSimulator, "_speed:=4", "_start:=17 0 0"}, Log("simulator"));
  const auto drive = [&](double speed) {
    geometry_msgs::Twist twist;
    twist.linear.x = speed;
    command.publish(twist);
  };

  // It drives.
  ASSERT_TRUE(Eventually([&] { return odom.count() > 0 && clock.count() > 0; }, 15))
      << TextOf(Log("simulator"));
  bool simulated = false;
  EXPECT_TRUE(ros::param::get("/use_sim_time", simulated) && simulated);
  EXPECT_TRUE(Eventually([&] {
    drive(0.3);
    return odom.get().pose.pose.position.x > 0.3;
  }));
  EXPECT_GT(truth.get().pose.position.x, 17.2);
  EXPECT_TRUE(Eventually([&] {
    drive(0);
    return std::abs(odom.get().twist.twist.linear.x) < 0.01;
  }));
  EXPECT_EQ(odom.get().header.frame_id, "odom");

  // It sees what is put in its way.
  EXPECT_TRUE(Eventually([&] { return Inject("block_corridor", "corridor_middle").ok; }));
  EXPECT_TRUE(Eventually([&] {
    const auto ranges = scan.get().ranges;
    return ranges.size() == 541 && ranges[270] < 2.4;
  }));
  EXPECT_TRUE(Inject("clear_corridor", "corridor_middle").ok);
  EXPECT_TRUE(Eventually([&] { return scan.get().ranges[270] > 3; }));
  EXPECT_THAT(Inject("block_corridor", "corridor_midle").message, HasSubstr("corridor_middle"));
  EXPECT_FALSE(Inject("kill_node", "/simulator").ok);

  // It is put elsewhere, and its odometry does not notice.
  const double driven = odom.get().pose.pose.position.x;
  EXPECT_TRUE(Inject("kidnap", "45 0 0").ok);
  EXPECT_TRUE(Eventually([&] { return truth.get().pose.position.x > 44; }));
  EXPECT_NEAR(odom.get().pose.pose.position.x, driven, 0.1);

  EXPECT_TRUE(Inject("set_battery", "", 0.25).ok);
  EXPECT_TRUE(Eventually([&] { return std::abs(battery.get().percentage - 0.25) < 0.01; }));
  EXPECT_EQ(battery.get().power_supply_status,
            sensor_msgs::BatteryState::POWER_SUPPLY_STATUS_DISCHARGING);

  EXPECT_EQ(simulator.Stop(std::chrono::seconds(5)), 0) << TextOf(Log("simulator"));
}

TEST_F(SimulatorNodeTest, StartsDockedWithMapAndTransforms) {
  Latest<sensor_msgs::BatteryState> battery(node_, "/battery_state");
  Latest<nav_msgs::OccupancyGrid> map(node_, "/map");
  Latest<tf2_msgs::TFMessage> tf(node_, "/tf");
  Latest<tf2_msgs::TFMessage> tf_static(node_, "/tf_static");
  Latest<sensor_msgs::Imu> imu(node_, "/imu/data");
  Latest<sensor_msgs::LaserScan> scan(node_, "/scan");
  // Private parameters outlive their node at the master, so the start is given here too.
  ChildProcess simulator({kSimulator, "_speed:=4", "_start:=none", "_state_of_charge:=0.5"},
                         Log("docked"));
  ASSERT_TRUE(Eventually([&] { return battery.count() > 0 && map.count() > 0; }, 15))
      << TextOf(Log("docked"));
  EXPECT_EQ(battery.get().power_supply_status,
            sensor_msgs::BatteryState::POWER_SUPPLY_STATUS_CHARGING);
  EXPECT_EQ(map.get().data.size(), map.get().info.width * map.get().info.height);
  EXPECT_TRUE(Eventually([&] { return tf.get().transforms.size() == 2; }));  // with map -> odom
  EXPECT_TRUE(Eventually([&] { return tf_static.count() > 0 && imu.count() > 0; }));
  for (const char* const frame : {"laser", "velodyne", "camera_front_optical", "sonar_left"}) {
    EXPECT_TRUE(HasFrame(tf_static.get(), frame)) << frame;
  }
  EXPECT_FALSE(HasFrame(tf_static.get(), "left_ear"));  // it moves: told by who moves it
  std::string description;
  EXPECT_TRUE(ros::param::get("/robot_description", description));
  EXPECT_THAT(description, HasSubstr("<robot name=\"sobi\">"));

  // A silenced topic is silent: the clock runs on for a second and no scan comes.
  Latest<rosgraph_msgs::Clock> clock(node_, "/clock");
  EXPECT_TRUE(Inject("silence_topic", "/scan").ok);
  EXPECT_TRUE(Eventually([&] { return clock.count() > 0; }));
  const ros::Time since = clock.get().clock;
  EXPECT_TRUE(Eventually([&] { return (clock.get().clock - since).toSec() > 1; }));
  EXPECT_LT((scan.get().header.stamp - since).toSec(), 0.2);
  EXPECT_TRUE(Inject("restore_topic", "/scan").ok);
  EXPECT_TRUE(Eventually([&] { return (scan.get().header.stamp - since).toSec() > 1; }));
}

TEST_F(SimulatorNodeTest, SendsCloudsOfTheWallsAroundItToWhoSubscribes) {
  ChildProcess simulator({kSimulator, "_speed:=4", "_start:=20 0 0"}, Log("cloud"));
  Latest<sensor_msgs::PointCloud2> clouds(node_, "/velodyne_points");
  Latest<tf2_msgs::TFMessage> tf_static(node_, "/tf_static");
  ASSERT_TRUE(Eventually([&] { return clouds.count() > 1 && tf_static.count() > 0; }, 15))
      << TextOf(Log("cloud"));
  const sensor_msgs::PointCloud2 cloud = clouds.get();
  EXPECT_EQ(cloud.header.frame_id, "velodyne");
  EXPECT_EQ(cloud.width * cloud.height, 16U * 900U);
  std::vector<perception::LidarPoint> points;
  ASSERT_TRUE(perception::Decode(cloud, points));
  int walls = 0, wrong_rings = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const perception::LidarPoint& point = points[i];
    if (point.ring != i / cloud.width || point.time < 0 || point.time >= 0.1F) ++wrong_rings;
    if (std::abs(std::abs(point.y) - 1.25F) < 0.15F) ++walls;  // of the corridor
  }
  EXPECT_EQ(wrong_rings, 0);
  EXPECT_GT(walls, 3000);
  const auto frames = tf_static.get().transforms;
  const auto velodyne = std::find_if(frames.begin(), frames.end(), [](const auto& frame) {
    return frame.child_frame_id == "velodyne";
  });
  ASSERT_NE(velodyne, frames.end());
  EXPECT_EQ(velodyne->transform.translation.z, 1.2);
}

TEST_F(SimulatorNodeTest, SonarsTellTheirRangesTenTimesASecondAndGoDeafLateOrSilentOnRequest) {
  // Half a metre before the south wall of the corridor.
  ChildProcess simulator({kSimulator, "_speed:=4", "_start:=20 -0.4 -1.5708"}, Log("sonars"));
  Latest<rosgraph_msgs::Clock> clock(node_, "/clock");
  for (const std::string name : {"left", "front", "right"}) {
    Latest<sensor_msgs::Range> range(node_, "/sonar/" + name);
    ASSERT_TRUE(Eventually([&] { return range.count() > 1; }, 15)) << TextOf(Log("sonars"));
    const sensor_msgs::Range message = range.get();
    EXPECT_EQ(message.header.frame_id, "sonar_" + name);
    EXPECT_EQ(message.radiation_type, sensor_msgs::Range::ULTRASOUND);
    EXPECT_NEAR(message.field_of_view, M_PI / 6, 1e-6);
    EXPECT_FLOAT_EQ(message.min_range, 0.2F);
    EXPECT_FLOAT_EQ(message.max_range, 4);
    EXPECT_NEAR(message.range, 0.53, 0.12);
  }

  Latest<sensor_msgs::Range> front(node_, "/sonar/front");
  ASSERT_TRUE(Eventually([&] { return front.count() > 0; }));
  const ros::Time first = front.get().header.stamp;
  const int before = front.count();
  EXPECT_TRUE(Eventually([&] { return front.count() >= before + 20; }));
  EXPECT_NEAR((front.get().header.stamp - first).toSec() / (front.count() - before), 0.1, 0.01);

  EXPECT_TRUE(Inject("blind_topic", "/sonar/front").ok);
  EXPECT_TRUE(Eventually([&] { return std::isnan(front.get().range); }));
  EXPECT_TRUE(Inject("restore_topic", "/sonar/front").ok);
  EXPECT_TRUE(Eventually([&] { return !std::isnan(front.get().range); }));
  EXPECT_TRUE(Inject("delay_topic", "/sonar/front", 2).ok);
  EXPECT_TRUE(Eventually([&] {
    const sensor_msgs::Range newest = front.get();
    return (clock.get().clock - newest.header.stamp).toSec() > 1.9;
  }));
  EXPECT_TRUE(Inject("silence_topic", "/sonar/front").ok);
  const ros::Time silenced = clock.get().clock;
  EXPECT_TRUE(Eventually([&] { return (clock.get().clock - silenced).toSec() > 4; }));
  EXPECT_LT((front.get().header.stamp - silenced).toSec(), 0.2);
}

TEST_F(SimulatorNodeTest, TheThreeDLidarLeavesTurnsOutWhereTimeRunsFast) {
  ChildProcess simulator({kSimulator, "_speed:=0", "_start:=20 0 0"}, Log("turns"));
  Latest<sensor_msgs::PointCloud2> clouds(node_, "/velodyne_points");
  ASSERT_TRUE(Eventually([&] { return clouds.count() > 0; }, 15)) << TextOf(Log("turns"));
  const ros::Time first = clouds.get().header.stamp;
  const int before = clouds.count();
  ASSERT_TRUE(Eventually([&] { return clouds.count() >= before + 4; }, 15));
  const double between = (clouds.get().header.stamp - first).toSec() / (clouds.count() - before);
  EXPECT_GT(between, 0.2) << "a turn takes 0.1 s";
}

// Faster than real time the clock comes less often: so the time between two of its messages tells.
TEST_F(SimulatorNodeTest, TakesAnotherSpeedWhileItRunsIfThereIsSuchASpeed) {
  ChildProcess simulator({kSimulator, "_speed:=4"}, Log("speed"));
  std::atomic<double> last = 0, period = 0;
  const ros::Subscriber clock = node_.subscribe<rosgraph_msgs::Clock>(
      "/clock", 10, [&](const rosgraph_msgs::Clock::ConstPtr& message) {
        period = message->clock.toSec() - last.exchange(message->clock.toSec());
      });
  ros::Publisher speed = node_.advertise<std_msgs::Float64>("/simulation/speed", 5, true);
  const auto set = [&](double value) {
    std_msgs::Float64 message;
    message.data = value;
    speed.publish(message);
  };
  const auto is_fast = [&] { return period > 0.03 && period < 0.1; };
  const auto is_real = [&] { return period > 0.01 && period < 0.03; };
  ASSERT_TRUE(Eventually(is_fast, 15)) << TextOf(Log("speed"));
  set(1);
  EXPECT_TRUE(Eventually(is_real));
  set(6);
  EXPECT_TRUE(Eventually(is_fast));
  set(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(Eventually([] {
    return TextOf(Log("speed")).find("/simulation/speed is nan, expected 0 to 1000") !=
           std::string::npos;
  }));
  EXPECT_TRUE(is_fast());
}

TEST_F(SimulatorNodeTest, ASpeedAtWhichTheNextStepIsYearsAwayIsLeftAndEndedAtOnce) {
  const Latest<rosgraph_msgs::Clock> clock(node_, "/clock");
  ros::Publisher speed = node_.advertise<std_msgs::Float64>("/simulation/speed", 5);
  const auto is_up = [&] { return speed.getNumSubscribers() > 0; };
  const std::vector<std::string> slow = {kSimulator, "_speed:=1e-9"};
  ChildProcess ended(slow, Log("slow"));
  ASSERT_TRUE(Eventually(is_up, 15)) << TextOf(Log("slow"));
  EXPECT_EQ(ended.Stop(std::chrono::seconds(10)), 0);
  ASSERT_TRUE(Eventually([&] { return !is_up(); }));
  const ChildProcess left(slow, Log("slow"));
  ASSERT_TRUE(Eventually(is_up, 15)) << TextOf(Log("slow"));
  std_msgs::Float64 message;
  message.data = 1;
  speed.publish(message);
  const int before = clock.count();
  EXPECT_TRUE(Eventually([&] { return clock.count() > before + 20; }, 15));
}

TEST_F(SimulatorNodeTest, TopicsComeTooFastOrTooSlowlyAndTheBatteryFreezesOnRequest) {
  Latest<rosgraph_msgs::Clock> clock(node_, "/clock");
  Latest<sensor_msgs::LaserScan> scan(node_, "/scan");
  Latest<sensor_msgs::BatteryState> battery(node_, "/battery_state");
  Latest<std_msgs::Bool> stop(node_, "/emergency_stop");
  ChildProcess simulator({kSimulator, "_speed:=4", "_start:=10 0 0", "_state_of_charge:=0.5"},
                         Log("rates"));
  ASSERT_TRUE(Eventually([&] { return scan.count() > 0 && battery.count() > 0; }, 15))
      << TextOf(Log("rates"));
  // Scans within five seconds of simulated time; ten a second are due.
  const auto scans = [&] {
    const ros::Time since = scan.get().header.stamp;
    const int before = scan.count();
    EXPECT_TRUE(Eventually([&] { return (clock.get().clock - since).toSec() > 5; }));
    return scan.count() - before;
  };
  EXPECT_TRUE(Inject("slow_topic", "/scan", 0.3).ok);
  EXPECT_LT(scans(), 25);
  EXPECT_TRUE(Inject("fast_topic", "/scan", 3).ok);
  EXPECT_GT(scans(), 100);
  EXPECT_TRUE(Inject("restore_topic", "/scan").ok);

  EXPECT_TRUE(Inject("freeze_battery", "").ok);
  const auto frozen = battery.get();
  EXPECT_TRUE(Inject("set_battery", "", 0.2).ok);
  EXPECT_TRUE(
      Eventually([&] { return (battery.get().header.stamp - frozen.header.stamp).toSec() > 2; }));
  EXPECT_NEAR(battery.get().percentage, 0.5, 0.01);
  EXPECT_TRUE(Inject("thaw_battery", "").ok);
  EXPECT_TRUE(Eventually([&] { return battery.get().percentage < 0.25; }));

  EXPECT_TRUE(Eventually([&] { return stop.count() > 0 && !stop.get().data; }));
  EXPECT_TRUE(Inject("emergency_stop", "").ok);
  EXPECT_TRUE(Eventually([&] { return stop.get().data != 0; }));
}

TEST_F(SimulatorNodeTest, SensorsGoBlindLagAndLoseARingOnRequest) {
  ChildProcess simulator({kSimulator, "_speed:=2", "_start:=20 0 0"}, Log("ill"));
  Latest<rosgraph_msgs::Clock> clock(node_, "/clock");
  Latest<sensor_msgs::LaserScan> scan(node_, "/scan");
  Latest<sensor_msgs::PointCloud2> clouds(node_, "/velodyne_points");
  ASSERT_TRUE(Eventually([&] { return scan.count() > 0 && clouds.count() > 0; }, 15))
      << TextOf(Log("ill"));

  EXPECT_TRUE(Inject("blind_topic", "/scan").ok);
  EXPECT_TRUE(Eventually([&] { return std::isnan(scan.get().ranges.at(270)); }));
  EXPECT_TRUE(Inject("restore_topic", "/scan").ok);
  EXPECT_TRUE(Eventually([&] { return !std::isnan(scan.get().ranges.at(270)); }));

  EXPECT_TRUE(Inject("delay_topic", "/scan", 2).ok);
  EXPECT_TRUE(Eventually([&] {
    const sensor_msgs::LaserScan newest = scan.get();
    return (clock.get().clock - newest.header.stamp).toSec() > 1.9;
  }));
  EXPECT_TRUE(Inject("restore_topic", "/scan").ok);

  const auto measured = [&](int wanted) {
    std::vector<perception::LidarPoint> points;
    EXPECT_TRUE(perception::Decode(clouds.get(), points));
    return std::count_if(points.begin(), points.end(), [wanted](const auto& point) {
      return point.ring == wanted && !std::isnan(point.x);
    });
  };
  EXPECT_GT(measured(3), 500);
  EXPECT_TRUE(Inject("lose_ring", "", 3).ok);
  EXPECT_TRUE(Eventually([&] { return measured(3) == 0; }));
  EXPECT_GT(measured(4), 500);
}

TEST_F(SimulatorNodeTest, CamerasSendPicturesAndDepthToWhoSubscribesAndGoDarkOnRequest) {
  ChildProcess simulator({kSimulator, "_speed:=1", "_start:=20 0 0"}, Log("world"));
  ChildProcess cameras({BinaryFolder() + "/bin/coppice-simulated-cameras"}, Log("cameras"));
  Latest<sensor_msgs::CompressedImage> colour(node_, "/camera/front/color/image_raw/compressed");
  Latest<sensor_msgs::CompressedImage> depth(
      node_, "/camera/front/aligned_depth_to_color/image_raw/compressedDepth");
  Latest<sensor_msgs::CameraInfo> info(node_, "/camera/front/color/camera_info");
  ASSERT_TRUE(Eventually([&] { return colour.count() > 1 && depth.count() > 1; }, 15))
      << TextOf(Log("cameras"));
  EXPECT_EQ(colour.get().header.frame_id, "camera_front_optical");
  EXPECT_EQ(info.get().K[0], 615.18);
  const Expected<Picture> picture = DecodeJpeg(colour.get().data);
  ASSERT_TRUE(picture) << picture.problem();
  EXPECT_EQ(picture->width, 640);
  const Expected<DepthPicture> depths = DecodeDepth(depth.get().data);
  ASSERT_TRUE(depths) << depths.problem();
  // The floor of the corridor, 1.35 m below the lens.
  EXPECT_NEAR(depths->at(320, 470), 1000 * 1.35 * 615.18 / (470 - 236.27), 150);

  EXPECT_TRUE(Inject("cover_lens", "front").ok);
  EXPECT_TRUE(Eventually([&] {
    const Expected<Picture> dark = DecodeJpeg(colour.get().data);
    return dark && dark->at(320, 300)[1] < 30;
  }));
  EXPECT_TRUE(Inject("uncover_lens", "front").ok);
  const auto depth_of_the_floor = [&] {
    const Expected<DepthPicture> now = DecodeDepth(depth.get().data);
    return now ? now->at(320, 470) : 0;
  };
  EXPECT_TRUE(Eventually([&] { return depth_of_the_floor() > 0; }));
  EXPECT_TRUE(Inject("wear_camera", "front", 3600).ok);  // all of it within a second
  EXPECT_TRUE(Eventually([&] { return depth_of_the_floor() == 0; }));
  EXPECT_TRUE(Inject("mend_camera", "front").ok);

  // Silence takes one camera only.
  Latest<sensor_msgs::CompressedImage> rear(node_, "/camera/rear/color/image_raw/compressed");
  EXPECT_TRUE(Inject("silence_topic", "/camera/front").ok);
  EXPECT_TRUE(Eventually([&] { return rear.count() > 2; }));
  const ros::Time last = colour.get().header.stamp;
  EXPECT_TRUE(Eventually([&] { return (rear.get().header.stamp - last).toSec() > 1; }));
  EXPECT_EQ(colour.get().header.stamp, last);
  EXPECT_THAT(Inject("cover_lens", "frnt").message, HasSubstr("did you mean \"front\""));
}

TEST_F(SimulatorNodeTest, EndsWithCodeTwoWhenThereIsNoSuchRobot) {
  const std::string log = Log("bad_robot");
  EXPECT_EQ(RunToTheEnd({"__name:=bad_robot", "_robot:=/nowhere.urdf"}, log), 2);
  EXPECT_THAT(TextOf(log), HasSubstr("/nowhere.urdf"));
}

TEST_F(SimulatorNodeTest, EndsWithCodeTwoWhenThereIsNoSuchFloor) {
  const std::string log = Log("bad");
  EXPECT_EQ(RunToTheEnd({"__name:=bad", "_floor:=/nowhere.yaml"}, log), 2);
  EXPECT_THAT(TextOf(log), HasSubstr("/nowhere.yaml"));
}

}  // namespace
}  // namespace coppice::robot::simulation
