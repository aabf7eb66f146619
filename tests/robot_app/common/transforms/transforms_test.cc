#include "robot_app/common/transforms/transforms.h"

#include <gtest/gtest.h>
#include <ros/publisher.h>

#include <limits>

#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"

namespace coppice::robot {
namespace {

class TransformsTest : public testing::Test {
 protected:
  void Send(const ros::Publisher& publisher, const ros::Time& stamp, double x) {
    tf2_msgs::TFMessage message;
    message.transforms.resize(1);
    message.transforms[0].header.stamp = stamp;
    message.transforms[0].header.frame_id = "odom";
    message.transforms[0].child_frame_id = "base_link";
    message.transforms[0].transform.translation.x = x;
    message.transforms[0].transform.rotation.w = 1;
    publisher.publish(message);
  }
  bool Finds(double x) const {
    return Eventually([&] {
      const auto found = transforms_.Find("odom", "base_link", ros::Time());
      return found && found->transform.translation.x == x;
    });
  }

  ros::NodeHandle node_;
  const ros::Publisher moving_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 10, true);
  const ros::Publisher fixed_ = node_.advertise<tf2_msgs::TFMessage>("/tf_static", 10, true);
  Transforms transforms_;
};

TEST_F(TransformsTest, FindsTheNewestAndItsParent) {
  Send(moving_, ros::Time::now() - ros::Duration(1), 1);
  Send(moving_, ros::Time::now(), 2);
  EXPECT_TRUE(Finds(2));
  EXPECT_EQ(transforms_.ParentOf("base_link"), "odom");
  EXPECT_EQ(transforms_.ParentOf("map"), "");
}

TEST_F(TransformsTest, AStampOfTheFarFutureIsNotBelieved) {
  for (const std::uint32_t seconds : {std::numeric_limits<std::uint32_t>::max(), 0x7fffffffU}) {
    Send(moving_, ros::Time(seconds, 0), 3);
  }
  Send(moving_, ros::Time::now(), 4);
  EXPECT_TRUE(Finds(4));
}

TEST_F(TransformsTest, AFixedOneHoldsAlwaysWhateverItsStamp) {
  Send(fixed_, ros::Time(std::numeric_limits<std::uint32_t>::max(), 0), 5);
  EXPECT_TRUE(Finds(5));
}

TEST_F(TransformsTest, AskedForAnImpossibleTimeItSaysSo) {
  Send(moving_, ros::Time::now(), 6);
  ASSERT_TRUE(Finds(6));
  const ros::Time never(std::numeric_limits<std::uint32_t>::max(), 0);
  EXPECT_FALSE(transforms_.Find("odom", "base_link", never));
}

tf2_msgs::TFMessage Frames(const std::string& prefix, std::size_t count, const ros::Time& stamp) {
  tf2_msgs::TFMessage message;
  for (std::size_t i = 0; i < count; ++i) {
    geometry_msgs::TransformStamped& one = message.transforms.emplace_back();
    one.header.stamp = stamp;
    one.header.frame_id = "map";
    one.child_frame_id = prefix + std::to_string(i);
    one.transform.rotation.w = 1;
  }
  return message;
}

TEST(TransformMemory, OneThatIsAheadDoesNotHoldAgainstThoseThatFollow) {
  TransformMemory memory;
  memory.Store(Frames("robot_", 1, ros::Time(1009)), false, ros::Time(1000));
  tf2_msgs::TFMessage next = Frames("robot_", 1, ros::Time(1001));
  next.transforms[0].transform.translation.x = 2;
  memory.Store(next, false, ros::Time(1001));
  const auto newest = memory.Find("map", "robot_0", ros::Time());
  ASSERT_TRUE(newest);
  EXPECT_EQ(newest->transform.translation.x, 2);
}

TEST(TransformMemory, ThereIsRoomForAThousandFramesThatMove) {
  TransformMemory memory;
  const ros::Time now(1000);
  EXPECT_EQ(memory.Store(Frames("robot_", 1, now), false, now), 0U);
  EXPECT_EQ(memory.Store(Frames("box_", 2000, now), false, now), 2000 - 998U);
  EXPECT_TRUE(memory.Find("map", "robot_0", ros::Time()));
  EXPECT_TRUE(memory.Find("map", "box_997", ros::Time()));
  EXPECT_FALSE(memory.Find("map", "box_998", ros::Time()));
}

TEST(TransformMemory, WhatIsNotHeardOfAnyMoreMakesRoomButForWhatHolds) {
  TransformMemory memory;
  memory.Store(Frames("laser_", 1, ros::Time()), true, ros::Time(1000));
  memory.Store(Frames("box_", 2000, ros::Time(1000)), false, ros::Time(1000));
  const auto refused = [&](double now) {
    return memory.Store(Frames("robot_", 1, ros::Time(now)), false, ros::Time(now));
  };
  EXPECT_EQ(refused(1009), 1U);
  EXPECT_EQ(refused(1011), 0U);
  EXPECT_TRUE(memory.Find("map", "robot_0", ros::Time()));
  EXPECT_TRUE(memory.Find("map", "laser_0", ros::Time()));
  EXPECT_FALSE(memory.Find("map", "box_0", ros::Time()));
}

TEST(TransformMemory, OfThoseThatHoldThereAreAThousandAndNoneHasAnEndlessName) {
  TransformMemory memory;
  const ros::Time now(1000);
  EXPECT_EQ(memory.Store(Frames("box_", 1500, now), true, now), 1500 - 999U);
  EXPECT_EQ(memory.Store(Frames("robot_", 1, now), false, now), 0U) << "which move";
  EXPECT_EQ(memory.Store(Frames(std::string(300, 'x'), 1, now), false, now), 1U);
}

TEST(TransformMemory, WhereTimeGoesBackWhatHoldsStays) {
  TransformMemory memory;
  memory.Store(Frames("laser_", 1, ros::Time()), true, ros::Time(1000));
  memory.Store(Frames("robot_", 1, ros::Time(1000)), false, ros::Time(1000));
  memory.Store(Frames("wheel_", 1, ros::Time(10)), false, ros::Time(10));
  EXPECT_TRUE(memory.Find("map", "laser_0", ros::Time()));
  EXPECT_TRUE(memory.Find("map", "wheel_0", ros::Time()));
  EXPECT_FALSE(memory.Find("map", "robot_0", ros::Time()));
}

}  // namespace
}  // namespace coppice::robot
