#include "editor/timeline/columns.h"

#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "tests/editor/timeline/executed_run.h"

namespace coppice::editor {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class ColumnsTest : public testing::Test {
 protected:
  ExecutedTree robot_{R"(<BehaviorTree ID="Main"><Do as="work"/></BehaviorTree>)"};
  coppice::editor::Run run_;
  Follow follow_{robot_.executor, run_};
};

TEST_F(ColumnsTest, SayWhichTicksHoldInEachColumn) {
  for (int i = 0; i < 10; ++i) robot_.Tick(seconds(1));
  TimeView view;
  view.Fit(Time(seconds(0)), Time(seconds(10)));
  const auto columns = ColumnsOf(run_, view, 1000, Time(seconds(9)));
  EXPECT_TRUE(columns.front().is_empty()) << "before the run";
  EXPECT_TRUE(columns.back().is_empty()) << "behind it";
  const Column middle = columns[500];
  EXPECT_EQ(middle.end - middle.first, 1U);
  const auto wide = ColumnsOf(run_, view, 2, Time(seconds(9)));
  EXPECT_EQ(wide[0].first, 0U);
  EXPECT_EQ(wide[0].end, 5U);
  EXPECT_EQ(wide[1].end, 10U);
}

TEST_F(ColumnsTest, BarsJoinColumnsThatShowTheSame) {
  for (int i = 0; i < 10; ++i) {
    robot_.results["work"] = i < 5 ? Status::kRunning : Status::kFailure;
    robot_.Tick(seconds(1));
  }
  TimeView view;
  view.Fit(Time(seconds(0)), Time(seconds(9)));
  const auto bars =
      BarsOf(run_.TracksAt(0).LaneOf(kRootNode), ColumnsOf(run_, view, 1000, Time(seconds(9))));
  ASSERT_EQ(bars.size(), 3U) << "the column in the middle has some of both";
  EXPECT_EQ(bars[0].statuses, SetOf(Status::kRunning));
  EXPECT_EQ(bars[1].end_column - bars[1].first_column, 1U);
  EXPECT_EQ(bars[2].statuses, SetOf(Status::kFailure));
  EXPECT_EQ(bars[0].end_column, bars[1].first_column);
  const auto one =
      BarsOf(run_.TracksAt(0).LaneOf(kRootNode), ColumnsOf(run_, view, 1, Time(seconds(9))));
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].statuses, SetOf(Status::kRunning) | SetOf(Status::kFailure))
      << "nothing vanishes";
}

// Says how long it takes; how long it may take depends on the computer.
TEST_F(ColumnsTest, TenMillionEventsAreScrubbed) {
  std::mt19937 random(1);
  constexpr std::size_t kTicks = 1000000;
  constexpr NodeIndex kNodes{20};
  TreeDescription tree;
  tree.main_tree = "Main";
  for (NodeIndex i{0}; i < kNodes; ++i) {
    DescribedNode node;
    node.path = "node" + std::to_string(i);
    node.id = "Any";
    tree.nodes.push_back(node);
  }
  coppice::editor::Run run;
  run.OnTree(tree);
  HistoryState state;
  state.statuses.assign(kNodes, Status::kIdle);
  run.OnState(state);
  std::size_t events = 0;
  EventWriter writer;
  for (std::size_t tick = 1; tick <= kTicks; ++tick) {
    writer.Clear();
    writer.Status(kRootNode, Status::kRunning);
    for (int i = 0; i < 9; ++i) {
      writer.Status(kRootNode + 1 + random() % (kNodes - 1), static_cast<Status>(1 + random() % 3));
    }
    events += writer.words().size;
    run.OnTick(
        {tick, Time(milliseconds(10) * tick), Duration(1), Status::kRunning, true, writer.words()});
  }
  EXPECT_GE(events, 10000000U);
  TimeView view;
  RunPlace place(run);
  const auto start = std::chrono::steady_clock::now();
  constexpr int kFrames = 20;
  std::size_t bars = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    const Duration span = seconds(10000) / (1 << (frame % 10));
    view.Fit(Time(seconds(frame)), Time(seconds(frame)) + span);
    const auto columns = ColumnsOf(run, view, 1920, run.TimeOf(run.size() - 1));
    for (NodeIndex i{0}; i < kNodes; ++i) bars += BarsOf(run.TracksAt(0).LaneOf(i), columns).size();
    place.Go(random() % run.size());
  }
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  std::printf("frame of 10 million events, 20 lanes of 1920 columns and a jump: %.2f ms\n",
              took.count() / kFrames);
  EXPECT_GT(bars, 1000U);
}

}  // namespace
}  // namespace coppice::editor
