#include "robot_app/slam/graph/coarse_graph.h"

#include <gtest/gtest.h>

#include "tests/robot_app/slam/graph/ring.h"

namespace coppice::robot::slam {
namespace {

// The ring as driven, with its steps and what closes it.
PoseGraph RingGraph() {
  const std::vector<Pose3> truth = Ring();
  PoseGraph graph{truth, {}};
  for (std::uint32_t i = 1; i < truth.size(); ++i) {
    graph.links.push_back(
        {i - 1, i, truth[i - 1].inverse() * truth[i], OfSteps(), LinkKind::kStep});
  }
  graph.links.push_back(Closing(truth, 0, static_cast<std::uint32_t>(truth.size() - 1)));
  return graph;
}

TEST(CoarseGraph, ItHasNoMoreGroupsThanItMay) {
  const PoseGraph graph = RingGraph();
  for (const std::size_t most : {5U, 15U, 100U}) {
    CoarseSettings settings;
    settings.square = 1;
    settings.most_groups = most;
    const CoarseGraph coarse = MakeCoarse(graph, settings);
    EXPECT_LE(coarse.graph.poses.size(), most);
    EXPECT_GT(coarse.graph.poses.size(), 1U);
    EXPECT_EQ(coarse.group_of.size(), graph.poses.size());
  }
}

TEST(CoarseGraph, WhatFitsFitsBetweenGroupsToo) {
  const PoseGraph graph = RingGraph();
  const CoarseGraph coarse = MakeCoarse(graph, {});
  ASSERT_FALSE(coarse.graph.links.empty());
  for (const Link& link : coarse.graph.links) {
    EXPECT_LT(SquaredError(link, coarse.graph.poses), 1e-9);
  }
}

TEST(CoarseGraph, AClosureIsOffAsMuchBetweenGroupsAsBetweenKeyFrames) {
  const PoseGraph graph = RingGraph();
  const CoarseGraph coarse = MakeCoarse(graph, {});
  Link closure = Closing(graph.poses, 3, 25);
  closure.relative = closure.relative * Step(0.05, 0.01);
  const Link between = BetweenGroups(coarse, graph.poses, closure);
  ASSERT_NE(between.from, between.to);
  EXPECT_NEAR(SquaredError(between, coarse.graph.poses), SquaredError(closure, graph.poses), 0.02);
}

TEST(CoarseGraph, ALinkThatGoesBackwardsSaysTheSame) {
  PoseGraph graph = RingGraph();
  PoseGraph turned = graph;
  for (Link& link : turned.links) {
    std::swap(link.from, link.to);
    link.relative = link.relative.inverse();
  }
  graph.poses[20] = graph.poses[20] * Step(0.1, 0);
  turned.poses = graph.poses;
  const CoarseGraph a = MakeCoarse(graph, {}), b = MakeCoarse(turned, {});
  ASSERT_EQ(a.graph.links.size(), b.graph.links.size());
  for (std::size_t i = 0; i < a.graph.links.size(); ++i) {
    EXPECT_TRUE(a.graph.links[i].relative.isApprox(b.graph.links[i].relative, 0.01));
  }
}

TEST(CoarseGraph, PosesMoveWithTheirGroup) {
  const PoseGraph graph = RingGraph();
  CoarseGraph coarse = MakeCoarse(graph, {});
  const std::vector<Pose3> before = coarse.graph.poses;
  coarse.graph.poses[1] = Step(1, 0.3) * coarse.graph.poses[1];
  std::vector<Pose3> poses = graph.poses;
  MoveWithGroups(coarse, before, poses);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Pose3 motion = coarse.group_of[i] == 1 ? Step(1, 0.3) : Pose3::Identity();
    EXPECT_TRUE(poses[i].isApprox(motion * graph.poses[i])) << i;
  }
}

TEST(CoarseGraph, AGroupIsTiltedAsItsKeyFramesAreTogether) {
  PoseGraph graph = RingGraph();
  for (const Pose3& pose : graph.poses) {
    graph.uprights.push_back({TiltOf({}, pose), 1e4});  // each is as it is known to be
  }
  CoarseGraph coarse = MakeCoarse(graph, {});
  ASSERT_EQ(coarse.graph.uprights.size(), coarse.graph.poses.size());
  double information = 0;
  for (std::size_t i = 0; i < coarse.graph.poses.size(); ++i) {
    EXPECT_LT(TiltOf(coarse.graph.uprights[i], coarse.graph.poses[i]).norm(), 1e-9);
    information += coarse.graph.uprights[i].information;
  }
  EXPECT_NEAR(information, 1e4 * static_cast<double>(graph.poses.size()), 1);

  // All of the map is tilted about its axis x: so is each group, however it is turned.
  Pose3 tilted = Pose3::Identity();
  tilted.linear() = Eigen::AngleAxisd(0.003, Eigen::Vector3d::UnitX()).toRotationMatrix();
  for (Pose3& pose : graph.poses) pose = tilted * pose;
  coarse = MakeCoarse(graph, {});
  for (std::size_t i = 0; i < coarse.graph.poses.size(); ++i) {
    EXPECT_NEAR(TiltOf(coarse.graph.uprights[i], coarse.graph.poses[i]).norm(), 0.003, 1e-5) << i;
  }
}

}  // namespace
}  // namespace coppice::robot::slam
