#include "bt_core/analysis/why/walk.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

// 0 Sequence: 1 leaf, 2 Fallback: (3 leaf, 4 leaf), 5 leaf
const TreeShape kShape = {{NodeIndex{0}, NodeIndex{6}, true},  {NodeIndex{0}, NodeIndex{2}, false},
                          {NodeIndex{0}, NodeIndex{5}, true},  {NodeIndex{2}, NodeIndex{4}, false},
                          {NodeIndex{2}, NodeIndex{5}, false}, {NodeIndex{0}, NodeIndex{6}, false}};

std::vector<std::uint32_t> NodesOf(const Walk& walk) {
  std::vector<std::uint32_t> nodes;
  for (const WalkStep& step : walk.steps) nodes.push_back(step.node);
  return nodes;
}

TEST(Walk, PutsAnOrderOfCompletionInTheOrderOfEntering) {
  EventWriter words;
  words.Status(NodeIndex{1}, Status::kSuccess);
  words.Status(NodeIndex{3}, Status::kFailure);
  words.Status(NodeIndex{4}, Status::kSuccess);
  words.Status(NodeIndex{2}, Status::kSuccess);
  words.Status(NodeIndex{5}, Status::kRunning);
  words.Status(kRootNode, Status::kRunning);
  const Walk walk = WalkOf(kShape, words.words());
  EXPECT_EQ(NodesOf(walk), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(walk.steps[0].parent, kNoStep);
  EXPECT_EQ(walk.steps[3].parent, 2u);
  EXPECT_EQ(walk.ChildrenOf(0), (std::vector<StepIndex>{1, 2, 5}));
  EXPECT_EQ(walk.Decisive(0), 5u);
  EXPECT_EQ(walk.Decisive(2), 4u);
  EXPECT_EQ(walk.Decisive(5), kNoStep);
  EXPECT_EQ(walk.steps[2].entry, 1u) << "behind the result of node 1";
}

TEST(Walk, KnowsANodeThatIsTickedTwice) {
  EventWriter words;
  words.Status(NodeIndex{3}, Status::kFailure);
  words.Status(NodeIndex{2}, Status::kFailure);
  words.Status(NodeIndex{3}, Status::kSuccess);
  words.Status(NodeIndex{2}, Status::kSuccess);
  words.Status(kRootNode, Status::kSuccess);
  const Walk walk = WalkOf(kShape, words.words());
  EXPECT_EQ(NodesOf(walk), (std::vector<std::uint32_t>{0, 2, 3, 2, 3}));
  EXPECT_EQ(walk.LastStepOf(NodeIndex{2}), 3u);
  EXPECT_EQ(walk.LastStepOf(NodeIndex{5}), kNoStep);
}

TEST(Walk, TakesAnInjectedResultForThatOfTheStep) {
  EventWriter words;
  words.Status(NodeIndex{1}, Status::kSuccess);
  words.Text(NodeIndex{1}, EventText::kInjected,
             std::string(1, static_cast<char>(Status::kFailure)));
  words.Status(NodeIndex{1}, Status::kFailure);
  words.Status(kRootNode, Status::kFailure);
  const Walk walk = WalkOf(kShape, words.words());
  EXPECT_EQ(NodesOf(walk), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(walk.steps[1].result, Status::kFailure);
  EXPECT_TRUE(walk.steps[1].is_injected);
  EXPECT_FALSE(walk.steps[0].is_injected);
}

TEST(Walk, HasResetsAsSteps) {
  EventWriter words;
  words.Status(NodeIndex{1}, Status::kRunning);
  words.Reset(NodeIndex{5});
  words.Status(kRootNode, Status::kRunning);
  const Walk walk = WalkOf(kShape, words.words());
  EXPECT_EQ(NodesOf(walk), (std::vector<std::uint32_t>{0, 1, 5}));
  EXPECT_EQ(walk.LastStepOf(NodeIndex{5}), kNoStep);
  EXPECT_EQ(walk.Decisive(0), 1u);
}

TEST(Walk, LeavesOutResetsThatChangeNothing) {
  EventWriter words;
  words.Reset(NodeIndex{2});
  words.Reset(NodeIndex{3});
  words.Status(kRootNode, Status::kRunning);
  const Status r = Status::kRunning;
  const std::vector<Status> before = {r, Status::kIdle, r, r, Status::kIdle, Status::kIdle};
  EXPECT_EQ(NodesOf(WalkOf(kShape, words.words(), &before)), (std::vector<std::uint32_t>{0, 2}));
}

TEST(Walk, LeavesOutNodesThatThereAreNot) {
  EventWriter words;
  words.Status(NodeIndex{77}, Status::kRunning);
  words.Status(kRootNode, Status::kRunning);
  EXPECT_EQ(NodesOf(WalkOf(kShape, words.words())), (std::vector<std::uint32_t>{0}));
}

TEST(FirstDifference, IsTheFirstStepInOrderOfCompletionThatIsAnother) {
  EventWriter before;
  before.Status(NodeIndex{1}, Status::kFailure);
  before.Status(kRootNode, Status::kFailure);
  EventWriter now;
  now.Status(NodeIndex{1}, Status::kSuccess);
  now.Status(NodeIndex{5}, Status::kRunning);
  now.Status(kRootNode, Status::kRunning);
  const Walk walk = WalkOf(kShape, now.words());
  EXPECT_EQ(walk.steps[FirstDifference(walk, WalkOf(kShape, before.words()))].node, 1u);
  EXPECT_EQ(FirstDifference(walk, walk), kNoStep);
}

}  // namespace
}  // namespace coppice
