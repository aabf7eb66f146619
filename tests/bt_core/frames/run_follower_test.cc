#include "bt_core/frames/run_follower.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

TEST(RunFollower, TakesAnyTreeAndState) {
  RunFollower run;
  TreeDescription tree;
  tree.nodes.resize(1);
  EventWriter words;
  words.Status(kRootNode, Status::kSuccess);
  const TickEvents tick{1, Time(Duration(1)), Duration(0), Status::kSuccess, true, words.words()};
  run.Set(tree);
  run.Apply(tick);
  EXPECT_EQ(run.state(), nullptr) << "nothing is known before the first state";
  run.Set(HistoryState{{}, 0, Time{}, {Status::kIdle}, {}, {}});
  run.Apply(tick);
  EXPECT_EQ(run.state()->status(kRootNode), Status::kSuccess);
  run.Set(HistoryState{{}, 2, Time(Duration(2)), {Status::kRunning}, {}, {}});
  EXPECT_EQ(run.state()->status(kRootNode), Status::kRunning);
  tree.nodes.resize(2);
  run.Set(tree);
  EXPECT_EQ(run.state(), nullptr) << "the state was that of another tree";
  EXPECT_EQ(run.tree().nodes.size(), 2u);
}

}  // namespace
}  // namespace coppice
