#include "robot_app/slam/graph/planar_fit.h"

#include <gtest/gtest.h>

#include "tests/robot_app/slam/graph/ring.h"

namespace coppice::robot::slam {
namespace {

TEST(PlanarFit, FindsTheShiftAndTheTurn) {
  const Pose3 truth = Step(0, 2.5) * Step(3, -0.7);
  std::vector<Eigen::Vector3d> moved, points{{1, 2, 0.5}, {-3, 0, 1}, {4, -2, 0}};
  for (const Eigen::Vector3d& point : points) moved.push_back(truth * point);
  EXPECT_TRUE(PlanarFit(moved, points).isApprox(truth, 1e-9));
}

}  // namespace
}  // namespace coppice::robot::slam
