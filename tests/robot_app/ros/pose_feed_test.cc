#include "robot_app/ros/pose_feed.h"

#include <gtest/gtest.h>
#include <std_msgs/Float64.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include "bt_core/engine/executor.h"
#include "bt_nodes/recovery/recovery_nodes.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"

namespace coppice::robot::adapters {
namespace {

geometry_msgs::TransformStamped Transform(const char* parent, const char* child, double x) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = parent;
  transform.header.stamp = ros::Time::now();
  transform.child_frame_id = child;
  transform.transform.translation.x = x;
  transform.transform.rotation.w = 1;
  return transform;
}

TEST(PoseFeed, BringsPoseAndDistanceFromTf) {
  auto registry = std::make_shared<Registry>();
  registry->Register<leaves::ContinueEpisode>("ContinueEpisode");
  Diagnostics diagnostics;
  auto project = Project::FromText(
      R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><ContinueEpisode pose="{pose}" )"
      R"(seconds="{distance_to_station}"/></BehaviorTree></root>)",
      "pose", diagnostics);
  const auto program =
      Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
  ASSERT_TRUE(program) << diagnostics.ToString();
  SimulatedClock clock;
  Executor executor(program, clock);
  ros::NodeHandle node;
  tf2_ros::StaticTransformBroadcaster tf;
  tf.sendTransform({Transform("map", "odom", 1), Transform("odom", "base_link", 2)});
  const PoseFeed feed(
      node, {0, 0, 0},
      {{executor.Writer<leaves::Pose2D>("pose"), executor.Writer<double>("distance_to_station")}});
  const auto key = [&](const char* name) -> const Value& {
    executor.Tick();
    return executor.blackboard()[program->layout.Find(kMainScope, name)].value;
  };
  ASSERT_TRUE(Eventually([&] { return key("distance_to_station").has_value(); }));
  EXPECT_DOUBLE_EQ(key("pose").Get<leaves::Pose2D>().x, 3);
  EXPECT_DOUBLE_EQ(key("distance_to_station").Get<double>(), 4.5);  // estimated
  auto navigation = node.advertise<std_msgs::Float64>("/navigation/way_to_station", 1);
  std_msgs::Float64 way;
  way.data = 12;
  EXPECT_TRUE(Eventually([&] {
    navigation.publish(way);
    return key("distance_to_station").Get<double>() == 12;
  }));
  EXPECT_TRUE(Eventually([&] { return key("distance_to_station").Get<double>() == 4.5; }))
      << "the navigation is silent";
}

}  // namespace
}  // namespace coppice::robot::adapters
