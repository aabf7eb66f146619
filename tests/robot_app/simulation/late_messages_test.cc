#include "robot_app/simulation/late_messages.h"

#include <gtest/gtest.h>
#include <std_msgs/String.h>

#include <string>

namespace coppice::robot::simulation {
namespace {

TEST(LateMessages, WithoutEndAreLostAsInANetwork) {
  LateMessages late;
  std_msgs::String picture;
  picture.data = std::string(std::size_t{1} << 20, 'x');
  for (int k = 0; k < 200; ++k) late.Add(1e9 + k, ros::Publisher(), picture);
  EXPECT_GT(late.bytes(), LateMessages::kMostBytes / 2);
  EXPECT_LE(late.bytes(), LateMessages::kMostBytes);
}

TEST(LateMessages, OfAnotherTimeAreForgotten) {
  LateMessages late;
  late.Send(100);
  late.Add(200, ros::Publisher(), std_msgs::String());
  EXPECT_GT(late.bytes(), 0U);
  late.Send(50);
  EXPECT_EQ(late.bytes(), 0U);
}

}  // namespace
}  // namespace coppice::robot::simulation
