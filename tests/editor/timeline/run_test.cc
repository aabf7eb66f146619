#include "editor/timeline/run.h"

#include <gtest/gtest.h>

#include <random>

#include "bt_core/frames/pause_note.h"
#include "tests/editor/timeline/executed_run.h"

namespace coppice::editor {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr char kTrees[] = R"(<BehaviorTree ID="Main"><ReactiveSequence>
  <Is as="ready"/><Do as="work" count="{count}"/><Do as="rest"/>
  </ReactiveSequence></BehaviorTree>)";

class RunTest : public testing::Test {
 protected:
  ExecutedTree robot{kTrees};
  coppice::editor::Run run;
  Follow follow{robot.executor, run};
};

TEST_F(RunTest, StandsAtEveryTickAsTheTreeDidThen) {
  std::mt19937 random(5);
  std::vector<std::vector<Status>> statuses;
  std::vector<std::string> counts;
  for (int i = 0; i < 9000; ++i) {
    robot.results["work"] = static_cast<Status>(1 + random() % 3);
    robot.results["rest"] = static_cast<Status>(1 + random() % 3);
    robot.Tick(milliseconds(10));
    statuses.push_back(run.now().statuses());
    counts.push_back(run.now().values()[0]);
  }
  EXPECT_GT(run.recording().sections().size(), 2U) << "states in between make jumps short";
  RunPlace place(run);
  for (int i = 0; i < 300; ++i) {
    const std::size_t tick = random() % run.size();
    place.Go(tick);
    ASSERT_EQ(place.state().statuses(), statuses[tick]) << tick;
    ASSERT_EQ(place.state().values()[0], counts[tick]) << tick;
    if (tick + 1 < run.size()) {
      place.Go(tick + 1);
      ASSERT_EQ(place.state().statuses(), statuses[tick + 1]) << tick;
    }
  }
  EXPECT_EQ(run.breaks().size(), 0U);
}

TEST_F(RunTest, FindsTheTickOfATime) {
  for (int i = 0; i < 10; ++i) robot.Tick(milliseconds(100));
  EXPECT_EQ(run.TimeOf(0), Time{});
  EXPECT_EQ(run.TimeOf(7), Time(milliseconds(700)));
  EXPECT_EQ(run.TickAt(Time(milliseconds(750))), 7U);
  EXPECT_EQ(run.TickAt(Time(milliseconds(700))), 7U);
  EXPECT_EQ(run.TickAt(Time(seconds(-1))), 0U);
  EXPECT_EQ(run.TickAt(Time(seconds(100))), 9U);
}

TEST_F(RunTest, MarksWhatIsMissing) {
  robot.Tick();
  HistoryGap gap;
  gap.lost_ticks = 41;
  run.OnGap(gap);
  follow.Begin(HistoryState::Cause::kLost);
  robot.Tick();
  ASSERT_EQ(run.breaks().size(), 1U);
  EXPECT_EQ(run.breaks()[0].tick, 1U);
  EXPECT_EQ(run.breaks()[0].lost_ticks, 41U);
  EXPECT_FALSE(run.breaks()[0].is_other_run);
}

TEST_F(RunTest, GoesOnBehindARobotThatWasStartedAnew) {
  for (int i = 0; i < 5; ++i) robot.Tick();
  ExecutedTree again(kTrees);  // its clock begins anew too
  Follow follow_again(again.executor, run);
  again.Tick();
  again.Tick();
  ASSERT_EQ(run.breaks().size(), 1U);
  EXPECT_TRUE(run.breaks()[0].is_other_run);
  EXPECT_FALSE(run.breaks()[0].is_other_tree);
  EXPECT_EQ(run.TimeOf(5), run.TimeOf(4) + seconds(1));
  EXPECT_EQ(run.TimeOf(6), run.TimeOf(5) + milliseconds(100));
  EXPECT_EQ(&run.TracksAt(0), &run.TracksAt(6)) << "the same tree keeps its lanes";
}

TEST_F(RunTest, KeepsTheOldTreeWhenTheRobotRunsAnother) {
  robot.Tick();
  ExecutedTree other(R"(<BehaviorTree ID="Main"><Do as="work"/></BehaviorTree>)");
  Follow follow_other(other.executor, run);
  other.Tick();
  ASSERT_EQ(run.breaks().size(), 1U);
  EXPECT_TRUE(run.breaks()[0].is_other_tree);
  EXPECT_EQ(run.TracksAt(0).tree()->nodes.size(), 4U);
  EXPECT_EQ(run.TracksAt(1).tree()->nodes.size(), 1U);
  RunPlace place(run);
  place.Go(0);
  EXPECT_EQ(place.state().statuses().size(), 4U);
}

TEST_F(RunTest, CountsWhatHappened) {
  for (int i = 0; i < 4; ++i) robot.Tick();
  EXPECT_EQ(run.Activity(0, 4), run.Activity(0, 1) + run.Activity(1, 4));
  EXPECT_GT(run.Activity(2, 3), 0U);
  EXPECT_EQ(run.durations().size(), 4U);
}

TEST_F(RunTest, ATickAtABreakpointIsAsLongAsItRan) {
  robot.Tick(milliseconds(10));
  const std::uint64_t next = run.now().tick() + 1;
  const Time now = robot.clock.Now();
  run.OnNote(NoteOf(Pause{now, now, next, seconds(1)}));
  run.OnNote(NoteOf(Pause{now, now, next, seconds(1)}));
  run.OnTick({next, now, milliseconds(2003), Status::kRunning, true, {}});
  EXPECT_FLOAT_EQ(run.durations().Largest(1, 2), 3);
}

}  // namespace
}  // namespace coppice::editor
