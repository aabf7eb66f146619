#include "bt_core/analysis/recording.h"

#include <gtest/gtest.h>

#include "tests/bt_core/analysis/recorded_run.h"

namespace coppice {
namespace {

using std::chrono::milliseconds;

TEST(Recording, KnowsTheStateBeforeEveryTick) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Repeat num_cycles='-1'><Sequence><Script code='n += 1'/>"
      "<Sleep msec='150'/></Sequence></Repeat></BehaviorTree>");
  run.executor.Writer<double>("n").Send(0);
  std::vector<std::vector<Status>> statuses = {run.executor.statuses()};
  for (int i = 0; i < 10; ++i) {
    run.Tick();
    statuses.push_back(run.executor.statuses());
  }
  const Recording& recording = run.keeper.run;
  for (std::size_t i = 0; i < statuses.size(); ++i) {
    EXPECT_EQ(recording.Before(i).statuses, statuses[i]) << i;
  }
  EXPECT_EQ(recording.Find(4), 3u);
  EXPECT_EQ(recording.Find(99), recording.ticks().size());
  EXPECT_EQ(recording.FindTime(recording.start() + milliseconds(350)), 3u);
  EXPECT_EQ(recording.FindTime(Time{}), 0u);
  EXPECT_EQ(recording.TickBefore(3), std::optional<std::size_t>(2));
  EXPECT_EQ(recording.TickBefore(0), std::nullopt);
}

TEST(Recording, JoinsThePartsOfATickThatStoodAtABreakpoint) {
  RecordedRun run("<BehaviorTree ID='Main'><AlwaysSuccess/></BehaviorTree>");
  Recording recording;
  recording.OnTree(run.keeper.run.trees()[0]);
  recording.OnState(run.keeper.run.sections()[0].state);
  EventWriter words;
  words.Text(kRootNode, EventText::kMessage, "before");
  recording.OnTick({1, Time(Duration(5)), Duration(0), Status::kRunning, false, words.words()});
  words.Clear();
  words.Status(kRootNode, Status::kSuccess);
  recording.OnTick({1, Time(Duration(5)), Duration(9), Status::kSuccess, true, words.words()});
  ASSERT_EQ(recording.ticks().size(), 1u);
  EXPECT_EQ(recording.ticks()[0].duration, Duration(9));
  EXPECT_TRUE(recording.ticks()[0].is_whole);
  EXPECT_EQ(recording.Before(1).statuses[0], Status::kSuccess);
}

TEST(Recording, DoesNotLookBackBehindAGap) {
  RecordedRun run("<BehaviorTree ID='Main'><AlwaysSuccess/></BehaviorTree>");
  run.Tick();
  run.keeper.Lose();
  run.Tick();
  EXPECT_EQ(run.keeper.run.TickBefore(1), std::nullopt);
  EXPECT_EQ(run.keeper.run.sections().size(), 2u);
}

}  // namespace
}  // namespace coppice
