#include "robot_app/common/limits/largest_allocation.h"

#include <gtest/gtest.h>
#include <ros/serialization.h>
#include <sensor_msgs/LaserScan.h>

#include <memory>
#include <new>
#include <vector>

namespace coppice::robot {
namespace {

class LargestAllocation : public testing::Test {
 protected:
  void SetUp() override {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer has limits of its own";
#endif
  }
};

TEST_F(LargestAllocation, OfAVectorHasALimit) {
  EXPECT_EQ(std::vector<char>(kLargestAllocation).size(), kLargestAllocation);
  EXPECT_THROW(std::vector<char>(kLargestAllocation + 1), std::bad_alloc);
}

TEST_F(LargestAllocation, OfTheBuffersOfRoscppHasNone) {
  EXPECT_NE(std::unique_ptr<char[]>(new char[kLargestAllocation + 1]), nullptr);
}

TEST_F(LargestAllocation, AMessageThatLiesAboutItsLengthCannotBeRead) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(sensor_msgs::LaserScan()),
                                  0);
  const std::size_t length_of_ranges = bytes.size() - 2 * sizeof(std::uint32_t);
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(length_of_ranges), 4, 0x70);
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  sensor_msgs::LaserScan scan;
  EXPECT_THROW(ros::serialization::deserialize(stream, scan), std::bad_alloc);
}

}  // namespace
}  // namespace coppice::robot
