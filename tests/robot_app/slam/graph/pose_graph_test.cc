#include "robot_app/slam/graph/pose_graph.h"

#include <gtest/gtest.h>

#include "tests/robot_app/slam/graph/ring.h"

namespace coppice::robot::slam {
namespace {

PoseGraph GraphOf(const std::vector<Pose3>& truth) {
  PoseGraph graph{{truth[0]}, {}};
  for (std::uint32_t i = 1; i < truth.size(); ++i) {
    graph.links.push_back({i - 1, i, Measured(truth, i), OfSteps(), LinkKind::kStep});
    graph.poses.push_back(graph.poses.back() * graph.links.back().relative);
  }
  return graph;
}

TEST(PoseGraph3d, AClosedLoopStraightensTheWayRoundAlsoInHeight) {
  const std::vector<Pose3> truth = Ring();
  PoseGraph graph = GraphOf(truth);
  ASSERT_GT(WorstOf(graph.poses, truth), 1.2);
  graph.links.push_back(Closing(truth, 0, 40));
  ASSERT_TRUE(Optimize({0}, {}, graph));
  EXPECT_LT(WorstOf(graph.poses, truth), 0.4);
  EXPECT_NEAR(graph.poses[40].translation().z(), truth[40].translation().z(), 0.05);
}

TEST(PoseGraph3d, OneFalseClosureDoesNotBendTheMap) {
  const std::vector<Pose3> truth = Ring();
  PoseGraph graph = GraphOf(truth);
  for (const std::uint32_t i : {36U, 38U, 40U}) graph.links.push_back(Closing(truth, i - 36, i));
  PoseGraph with_false = graph;
  with_false.links.push_back({5, 25, Pose3::Identity(), OfClosures(), LinkKind::kCloud});
  ASSERT_TRUE(Optimize({0}, {}, graph));
  ASSERT_TRUE(Optimize({0}, {}, with_false));
  EXPECT_LT(WorstOf(with_false.poses, graph.poses), 0.1);
}

TEST(PoseGraph3d, WithoutTheKernelTheSameLinkBendsIt) {
  const std::vector<Pose3> truth = Ring();
  PoseGraph graph = GraphOf(truth);
  graph.links.push_back({5, 25, Pose3::Identity(), OfClosures(), LinkKind::kStep});
  ASSERT_TRUE(Optimize({0}, {}, graph));
  EXPECT_GT(WorstOf(graph.poses, truth), 4);
}

// 60 m straight on, while each step says that it goes up a little more.
PoseGraph RisingFloor() {
  PoseGraph graph{{Pose3::Identity()}, {}};
  for (std::uint32_t i = 1; i <= 60; ++i) {
    graph.links.push_back({i - 1, i, Step(1, 0, -0.0005), OfSteps(), LinkKind::kStep});
    graph.poses.push_back(graph.poses.back() * graph.links.back().relative);
  }
  return graph;
}

TEST(PoseGraph3d, AFloorThatIsKnownToBeLevelDoesNotRise) {
  PoseGraph graph = RisingFloor();
  ASSERT_GT(graph.poses.back().translation().z(), 0.8);
  graph.uprights.assign(graph.poses.size(), {{0, 0}, 1 / (0.005 * 0.005)});
  ASSERT_TRUE(Optimize({0}, {}, graph));
  EXPECT_LT(graph.poses.back().translation().z(), 0.1);
}

TEST(PoseGraph3d, APoseOfWhichNothingIsKnownMayBeTilted) {
  PoseGraph graph = RisingFloor();
  graph.uprights.resize(graph.poses.size());
  ASSERT_TRUE(Optimize({0}, {}, graph));
  EXPECT_GT(graph.poses.back().translation().z(), 0.8);
}

TEST(PoseGraph3d, ATiltIsAlongTheAxesOfThePose) {
  const Pose3 pose = Step(3, M_PI / 2, 0.02);  // turned to the left, and its nose down
  const Eigen::Vector2d tilt = TiltOf({}, pose);
  EXPECT_NEAR(tilt.x(), -0.02, 1e-4);
  EXPECT_NEAR(tilt.y(), 0, 1e-9);
  EXPECT_LT(TiltOf({tilt, 1}, pose).norm(), 1e-9);
}

TEST(PoseGraph3d, AnErrorIsInTheAxesOfWhatTheLinkSays) {
  const Pose3 from = Step(3, 1);
  const Link link{0, 1, Step(1, M_PI / 2), InformationOf(0.1, 0.01), LinkKind::kStep};
  const Vector6 error = ErrorOf(link, from, from * link.relative * Step(0.2, 0.03));
  EXPECT_NEAR(error(0), 0.2, 1e-9);
  EXPECT_NEAR(error(1), 0, 1e-9);
  EXPECT_NEAR(error(5), 0.03, 1e-5);
  EXPECT_NEAR(SquaredError(link, {from, from * link.relative * Step(0.2, 0.03)}), 4 + 9, 0.01);
}

TEST(PoseGraph3d, AGraphOfOnePoseIsAtItsBest) {
  PoseGraph graph{{Step(1, 2)}, {}};
  EXPECT_TRUE(Optimize({0}, {}, graph));
  EXPECT_NEAR(graph.poses[0].translation().x(), 1, 1e-12);
}

}  // namespace
}  // namespace coppice::robot::slam
