#include "robot_app/slam/graph/session_graph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/robot_app/slam/graph/ring.h"

namespace coppice::robot::slam {
namespace {

// Drives the ring in a session of its own; returns the index of its first pose.
std::uint32_t Drive(SessionGraph& graph, double twist) {
  const std::vector<Pose3> truth = Ring();
  graph.BeginSession();
  const std::uint32_t first = graph.AddPose(Pose3::Identity(), OfSteps());
  for (std::size_t i = 1; i < truth.size(); ++i)
    graph.AddPose(Measured(truth, i, twist), OfSteps());
  return first;
}

// Pose i of the first round and pose j of the second one.
Link Between(std::uint32_t i, std::uint32_t j) {
  const std::vector<Pose3> truth = Ring();
  const auto second = static_cast<std::uint32_t>(truth.size());
  return {i, second + j, truth[i].inverse() * truth[j], OfClosures(), LinkKind::kPicture};
}

std::vector<Pose3> Round(const SessionGraph& graph, std::uint32_t first) {
  return {graph.poses().begin() + first, graph.poses().begin() + first + 41};
}

TEST(SessionGraph, ASecondClosureThatSaysTheSameJoinsANewSession) {
  SessionGraph graph;
  Drive(graph, 0.0);
  const std::uint32_t second = Drive(graph, 0.001);
  ASSERT_FALSE(graph.InOneMap(0, second));
  EXPECT_EQ(graph.AddClosure(Between(10, 10)), Verdict::kWaits);
  EXPECT_EQ(graph.AddClosure(Between(12, 12)), Verdict::kBelieved);
  EXPECT_TRUE(graph.InOneMap(0, second));
  const std::vector<Pose3> truth = Ring();
  const Pose3 to_truth = truth[0] * graph.poses()[0].inverse();
  const Pose3 at = to_truth * graph.poses()[second + 11];
  EXPECT_LT((at.translation() - truth[11].translation()).norm(), 0.25);
}

TEST(SessionGraph, AClosureBetweenMapsIsNotBelievedAlone) {
  SessionGraph graph;
  Drive(graph, 0);
  const std::uint32_t second = Drive(graph, 0);
  const std::vector<Pose3> before = Round(graph, second);
  EXPECT_EQ(graph.AddClosure(Between(3, 33)), Verdict::kWaits);
  EXPECT_EQ(graph.AddClosure(Between(3, 33)), Verdict::kWaits);  // from the same place
  EXPECT_FALSE(graph.InOneMap(0, second));
  EXPECT_LT(WorstOf(Round(graph, second), before), 1e-9);
}

TEST(SessionGraph, TwoClosuresThatContradictEachOtherJoinNothing) {
  SessionGraph graph;
  Drive(graph, 0);
  const std::uint32_t second = Drive(graph, 0);
  EXPECT_EQ(graph.AddClosure(Between(3, 3)), Verdict::kWaits);
  Link wrong = Between(20, 20);
  wrong.relative = wrong.relative * Step(2, 0);
  EXPECT_EQ(graph.AddClosure(wrong), Verdict::kWaits);
  EXPECT_FALSE(graph.InOneMap(0, second));
}

TEST(SessionGraph, AClosureThatContradictsOthersIsForgotten) {
  SessionGraph graph;
  Drive(graph, 0.005);
  const std::vector<Pose3> truth = Ring();
  for (const std::uint32_t i : {38U, 39U, 40U}) {
    ASSERT_EQ(graph.AddClosure(Closing(truth, i - 38, i)), Verdict::kBelieved);
  }
  const std::vector<Pose3> before = graph.poses();
  const std::size_t links = graph.graph().links.size();
  Link wrong = Closing(truth, 5, 25);
  wrong.relative = Pose3::Identity();
  EXPECT_EQ(graph.AddClosure(wrong), Verdict::kRefused);
  EXPECT_EQ(graph.graph().links.size(), links);
  EXPECT_LT(WorstOf(graph.poses(), before), 1e-9);
}

TEST(SessionGraph, WhatWasWrittenDownGoesOn) {
  SessionGraph graph;
  Drive(graph, 0);
  Drive(graph, 0);
  graph.AddClosure(Between(10, 10));
  graph.AddClosure(Between(12, 12));
  Drive(graph, 0);
  SessionGraph again({}, graph.graph(), graph.sessions());
  EXPECT_EQ(again.session_count(), 3U);
  EXPECT_EQ(again.map_of(1), 0U);
  EXPECT_EQ(again.map_of(2), 2U);
  again.BeginSession();
  EXPECT_EQ(again.sessions()[again.AddPose(Pose3::Identity(), OfSteps())], 3U);
}

// Up a ramp, half of a metre a step; odometry knows it, or does not.
double HeightOfRamp(bool is_measured) {
  SessionGraph graph;
  graph.BeginSession();
  graph.AddPose(Pose3::Identity(), OfSteps());
  for (int i = 0; i < 40; ++i) {
    const double pitch = i == 10 ? -0.08 : i == 30 ? 0.08 : 0;
    graph.AddPose(Step(0.5, 0, is_measured ? pitch : 0), OfSteps());
  }
  Link closure{0, 40, graph.poses()[40], OfClosures(), LinkKind::kCloud};
  closure.relative.translation().x() -= 0.15;
  EXPECT_EQ(graph.AddClosure(closure), Verdict::kBelieved);
  return graph.poses()[40].translation().z();
}

TEST(SessionGraph, ARampThatOdometryMeasuresStaysARamp) {
  EXPECT_NEAR(HeightOfRamp(true), 20 * 0.5 * std::sin(0.08), 0.05);
  EXPECT_NEAR(HeightOfRamp(false), 0, 1e-3);
}

TEST(SessionGraph, AGraphThatWasWrittenDownKnowsAsWellWhatIsUpright) {
  SessionGraph graph;
  Drive(graph, 0.001);
  Drive(graph, 0.002);
  const SessionGraph read({}, graph.graph(), graph.sessions());
  ASSERT_EQ(read.graph().uprights.size(), graph.poses().size());
  for (std::size_t i = 0; i < graph.poses().size(); ++i) {
    EXPECT_TRUE(read.graph().uprights[i].up.isApprox(graph.graph().uprights[i].up)) << i;
    EXPECT_EQ(read.graph().uprights[i].information, graph.graph().uprights[i].information);
  }
}

}  // namespace
}  // namespace coppice::robot::slam
