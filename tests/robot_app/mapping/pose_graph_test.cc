#include "robot_app/mapping/pose_graph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace coppice::robot::mapping {
namespace {

// A square of 10 m in steps of 1 m, a quarter of a turn at each corner.
std::vector<Pose2D> Square() {
  std::vector<Pose2D> poses{{2, 3, 0.5}};
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < 9; ++i) poses.push_back(Compose(poses.back(), {1, 0, 0}));
    poses.push_back(Compose(poses.back(), {1, 0, M_PI / 2}));
  }
  return poses;
}

struct Graph {
  std::vector<PoseConstraint> constraints;
  std::vector<Pose2D> poses;
};

// As odometry measures it: each step twisted a little.
Graph Measured(const std::vector<Pose2D>& truth, double twist) {
  Graph graph{{}, {truth[0]}};
  for (std::size_t i = 1; i < truth.size(); ++i) {
    PoseConstraint step{i - 1, i, RelativeTo(truth[i - 1], truth[i])};
    step.relative.yaw += twist;
    step.information = Eigen::Vector3d(1e4, 1e4, 1e4).asDiagonal();
    graph.constraints.push_back(step);
    graph.poses.push_back(Compose(graph.poses.back(), step.relative));
  }
  return graph;
}

PoseConstraint Closing(const std::vector<Pose2D>& truth, std::size_t from, std::size_t to) {
  PoseConstraint closure{from, to, RelativeTo(truth[from], truth[to])};
  closure.information = Eigen::Vector3d(1e4, 1e4, 1e5).asDiagonal();
  closure.doubtful = true;
  return closure;
}

double WorstOf(const std::vector<Pose2D>& poses, const std::vector<Pose2D>& truth) {
  double worst = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    worst = std::max(worst, Distance(poses[i], truth[i]));
  }
  return worst;
}

TEST(PoseGraph, AClosedLoopStraightensTheWayRound) {
  const std::vector<Pose2D> truth = Square();
  Graph graph = Measured(truth, 0.01);
  const double before = WorstOf(graph.poses, truth);
  ASSERT_GT(before, 1.5);
  graph.constraints.push_back(Closing(truth, 0, truth.size() - 1));
  OptimizePoses(graph.constraints, graph.poses);
  EXPECT_LT(Distance(graph.poses.back(), truth.back()), 0.1);
  EXPECT_LT(WorstOf(graph.poses, truth), before / 3);
  EXPECT_DOUBLE_EQ(graph.poses[0].x, truth[0].x);
  EXPECT_DOUBLE_EQ(graph.poses[0].yaw, truth[0].yaw);
}

TEST(PoseGraph, ManyClosedLoopsLeaveLittle) {
  const std::vector<Pose2D> once = Square();
  std::vector<Pose2D> truth = once;
  truth.insert(truth.end(), once.begin() + 1, once.end());
  Graph graph = Measured(truth, 0.01);
  for (std::size_t i = 0; i < once.size(); i += 4) {
    graph.constraints.push_back(Closing(truth, i, i + once.size() - 1));
  }
  OptimizePoses(graph.constraints, graph.poses);
  for (const PoseConstraint& constraint : graph.constraints) {
    if (constraint.doubtful) {
      EXPECT_LT(ErrorOf(constraint, graph.poses).norm(), 0.05);
    }
  }
}

TEST(PoseGraph, AFalseClosureBendsNothingMuch) {
  const std::vector<Pose2D> truth = Square();
  Graph graph = Measured(truth, 0.0005);
  graph.constraints.push_back(Closing(truth, 0, truth.size() - 1));
  graph.constraints.push_back(Closing(truth, 3, 25));
  graph.constraints.back().relative = {};
  OptimizePoses(graph.constraints, graph.poses);
  EXPECT_LT(WorstOf(graph.poses, truth), 0.15);
}

TEST(PoseGraph, WhatFitsStays) {
  const std::vector<Pose2D> truth = Square();
  Graph graph = Measured(truth, 0);
  graph.constraints.push_back(Closing(truth, 0, truth.size() - 1));
  OptimizePoses(graph.constraints, graph.poses);
  EXPECT_LT(WorstOf(graph.poses, truth), 1e-6);
}

TEST(PoseGraph, WhatCannotBeSolvedStays) {
  std::vector<Pose2D> none;
  OptimizePoses({}, none);
  std::vector<Pose2D> unbound{{0, 0, 0}, {1, 0, 0}};
  OptimizePoses({}, unbound);
  EXPECT_EQ(unbound[1].x, 1);
  PoseConstraint nonsense{0, 1, {NAN, 0, 0}};
  OptimizePoses({nonsense}, unbound);
  EXPECT_EQ(unbound[1].x, 1);
}

}  // namespace
}  // namespace coppice::robot::mapping
