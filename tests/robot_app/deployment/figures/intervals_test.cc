#include "robot_app/deployment/figures/intervals.h"

#include <gtest/gtest.h>

namespace coppice::robot::deployment {
namespace {

// The numbers are those of the published deployment's fault model.
TEST(Intervals, CountsOfTheSameMeanVaryAsAPoissonVariable) {
  const Bounds restarts = CountsOfMean(32);
  EXPECT_EQ(restarts.low, 21);
  EXPECT_EQ(restarts.high, 44);
  const Bounds waits = CountsOfMean(194);
  EXPECT_EQ(waits.low, 167);
  EXPECT_EQ(waits.high, 222);
  EXPECT_EQ(CountsOfMean(0).high, 0);
}

TEST(Intervals, ARateHasTheIntervalOfGarwood) {
  const Bounds restarts = MeanOfCount(32);
  EXPECT_NEAR(restarts.low / 65.4, 0.335, 0.001);
  EXPECT_NEAR(restarts.high / 65.4, 0.691, 0.001);
  EXPECT_EQ(MeanOfCount(0).low, 0);
  EXPECT_NEAR(MeanOfCount(0).high, 3.689, 0.001);
}

TEST(Intervals, AShareHasTheIntervalOfClopperAndPearson) {
  const Bounds restarts = ShareOf(20, 32);
  EXPECT_NEAR(100 * restarts.low, 43.7, 0.1);
  EXPECT_NEAR(100 * restarts.high, 78.9, 0.1);
  EXPECT_NEAR(ShareOf(27, 28).high, 0.999, 0.001);
  EXPECT_EQ(ShareOf(5, 5).high, 1);
  EXPECT_NEAR(ShareOf(5, 5).low, 0.478, 0.001);
  EXPECT_EQ(ShareOf(0, 0).high, 1);
}

}  // namespace
}  // namespace coppice::robot::deployment
