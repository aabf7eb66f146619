#include "bt_core/analysis/why/walk.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

// 0 Sequence: 1 leaf, 2 Fallback: (3 leaf, 4 leaf), 5 leaf
const TreeShape kShape = {{0, 6, true},  {0, 2, false}, {0, 5, true},
                          {2, 4, false}, {2, 5, false}, {0, 6, false}};

std::vector<NodeIndex> NodesOf(const Walk& walk) {
  std::vector<NodeIndex> nodes;
  for (const WalkStep& step : walk.steps) nodes.push_back(step.node);
  return nodes;
}

TEST(Walk, PutsAnOrderOfCompletionInTheOrderOfEntering) {
  EventWriter words;
  words.Status(1, Status::kSuccess);
  words.Status(3, Status::kFailure);
  words.Status(4, Status::kSuccess);
  words.Status(2, Status::kSuccess);
  words.Status(5, Status::kRunning);
  words.Status(0, Status::kRunning);
  const Walk walk = WalkOf(kShape, words.words());
  EXPECT_EQ(NodesOf(walk), (std::vector<NodeIndex>{0, 1, 2, 3, 4, 5}));
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
  words.Status(3, Status::kFailure);
  words.Status(2, Status::kFailure);
  words.Status(3, Status::kSuccess);
  words.Status(2, Status::kSuccess);
  words.Status(0, Status::kSuccess);
  const Walk walk = WalkOf(kShape, words.words());
  EXPECT_EQ(NodesOf(walk), (std::vector<NodeIndex>{0, 2, 3, 2, 3}));
  EXPECT_EQ(walk.LastStepOf(2), 3u);
  EXPECT_EQ(walk.LastStepOf(5), kNoStep);
}

TEST(Walk, TakesAnInjectedResultForThatOfTheStep) {
  EventWriter words;
  words.Status(1, Status::kSuccess);
  words.Text(1, EventText::kInjected, std::string(1, static_cast<char>(Status::kFailure)));
  words.Status(1, Status::kFailure);
  words.Status(0, Status::kFailure);
  const Walk walk = WalkOf(kShape, words.words());
  EXPECT_EQ(NodesOf(walk), (std::vector<NodeIndex>{0, 1}));
  EXPECT_EQ(walk.steps[1].result, Status::kFailure);
  EXPECT_TRUE(walk.steps[1].is_injected);
  EXPECT_FALSE(walk.steps[0].is_injected);
}

TEST(Walk, HasResetsAsSteps) {
  EventWriter words;
  words.Status(1, Status::kRunning);
  words.Reset(5);
  words.Status(0, Status::kRunning);
  const Walk walk = WalkOf(kShape, words.words());
  EXPECT_EQ(NodesOf(walk), (std::vector<NodeIndex>{0, 1, 5}));
  EXPECT_EQ(walk.LastStepOf(5), kNoStep);
  EXPECT_EQ(walk.Decisive(0), 1u);
}

TEST(Walk, LeavesOutResetsThatChangeNothing) {
  EventWriter words;
  words.Reset(2);
  words.Reset(3);
  words.Status(0, Status::kRunning);
  const Status r = Status::kRunning;
  const std::vector<Status> before = {r, Status::kIdle, r, r, Status::kIdle, Status::kIdle};
  EXPECT_EQ(NodesOf(WalkOf(kShape, words.words(), &before)), (std::vector<NodeIndex>{0, 2}));
}

TEST(Walk, LeavesOutNodesThatThereAreNot) {
  EventWriter words;
  words.Status(77, Status::kRunning);
  words.Status(0, Status::kRunning);
  EXPECT_EQ(NodesOf(WalkOf(kShape, words.words())), (std::vector<NodeIndex>{0}));
}

TEST(FirstDifference, IsTheFirstStepInOrderOfCompletionThatIsAnother) {
  EventWriter before;
  before.Status(1, Status::kFailure);
  before.Status(0, Status::kFailure);
  EventWriter now;
  now.Status(1, Status::kSuccess);
  now.Status(5, Status::kRunning);
  now.Status(0, Status::kRunning);
  const Walk walk = WalkOf(kShape, now.words());
  EXPECT_EQ(walk.steps[FirstDifference(walk, WalkOf(kShape, before.words()))].node, 1u);
  EXPECT_EQ(FirstDifference(walk, walk), kNoStep);
}

}  // namespace
}  // namespace coppice
