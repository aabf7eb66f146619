// coppice-velocity-mux as a whole process.
#include <geometry_msgs/Twist.h>
#include <gtest/gtest.h>

#include <cmath>

#include "robot_app/common/child_process.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/latest.h"
#include "tests/support/folders.h"

namespace coppice::robot::teleoperation {
namespace {

class VelocityMuxProgram : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(Eventually([&] {
      return command_.is_connected() && supervisor_.getNumSubscribers() > 0;
    })) << "no coppice-velocity-mux";
  }

  geometry_msgs::Twist Driven(const geometry_msgs::Twist& command) {
    command_.Forget();
    EXPECT_TRUE(Eventually([&] {
      supervisor_.publish(command);
      return command_.get() != nullptr;
    }));
    return command_.get() ? *command_.get() : geometry_msgs::Twist();
  }

  ros::NodeHandle node_;
  ChildProcess program_{{BinaryFolder() + "/bin/coppice-velocity-mux"}, "/dev/null", {}};
  ros::Publisher supervisor_ = node_.advertise<geometry_msgs::Twist>("/cmd_vel/supervisor", 1);
  Latest<geometry_msgs::Twist> command_{node_, "/cmd_vel"};
};

TEST_F(VelocityMuxProgram, HandsOnOnlyWhatTheBaseCanDo) {
  geometry_msgs::Twist command;
  command.linear.x = 0.3;
  command.linear.y = NAN;
  command.linear.z = 7;
  command.angular.x = INFINITY;
  command.angular.z = -0.5;
  const geometry_msgs::Twist driven = Driven(command);
  EXPECT_EQ(driven.linear.x, 0.3);
  EXPECT_EQ(driven.angular.z, -0.5);
  EXPECT_EQ(driven.linear.y, 0);
  EXPECT_EQ(driven.linear.z, 0);
  EXPECT_EQ(driven.angular.x, 0);
}

}  // namespace
}  // namespace coppice::robot::teleoperation
