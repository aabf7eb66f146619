#include "bt_core/analysis/statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bt_core/frames/pause_note.h"
#include "tests/bt_core/analysis/recorded_run.h"

namespace coppice {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

TEST(Spread, HasTheSmallestDurationThatEnoughAreNotAbove) {
  std::vector<Duration> durations;
  for (int i = 100; i > 0; --i) durations.emplace_back(i);
  const Spread spread = SpreadOf(durations);
  EXPECT_EQ(spread.count, 100u);
  EXPECT_EQ(spread.p50, Duration(50));
  EXPECT_EQ(spread.p95, Duration(95));
  EXPECT_EQ(spread.p99, Duration(99));
  EXPECT_EQ(spread.max, Duration(100));
  EXPECT_EQ(SpreadOf({}).count, 0u);
  EXPECT_EQ(SpreadOf({Duration(7)}).p50, Duration(7));
}

// Sleeps 300 ms, then fails once and begins again; the last child is never ticked.
Statistics TenSeconds() {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Fallback name='root'><Sequence name='s'><Sleep name='sleep' "
      "msec='300'/><Script code='n := 1 - n'/><ScriptCondition name='flips' code='n &lt; 1'/>"
      "</Sequence><AlwaysSuccess name='other'/><AlwaysSuccess name='never'/></Fallback>"
      "</BehaviorTree>");
  run.executor.Writer<double>("n").Send(0);
  for (int i = 0; i < 101; ++i) run.Tick();
  run.executor.Halt();
  return StatisticsOf(run.keeper.run);
}

TEST(Statistics, CountsTicksResultsAndActivations) {
  const Statistics statistics = TenSeconds();
  EXPECT_EQ(statistics.ticks, 101u);
  EXPECT_EQ(statistics.time, std::chrono::seconds(10));
  EXPECT_EQ(statistics.periods.p50, milliseconds(100));
  ASSERT_EQ(statistics.nodes.size(), 7u);
  const NodeStatistics& sleep = statistics.nodes[2];
  EXPECT_EQ(sleep.path, "sleep");
  EXPECT_EQ(sleep.ticks, 101u);
  EXPECT_EQ(sleep.results_of(Status::kSuccess), 25u);
  EXPECT_EQ(sleep.results_of(Status::kRunning), 76u);
  EXPECT_EQ(sleep.results_of(Status::kIdle), 1u) << "halted at the end";
  EXPECT_EQ(sleep.activations.count, 26u);
  EXPECT_EQ(sleep.activations.p50, milliseconds(300));
  EXPECT_EQ(sleep.first_tick, 1u);
  EXPECT_EQ(sleep.last_tick, 101u);
}

TEST(Statistics, FindFlappingAndWhatIsNeverTicked) {
  const Statistics statistics = TenSeconds();
  const NodeStatistics& never = statistics.nodes[6];
  EXPECT_EQ(never.ticks, 0u);
  EXPECT_EQ(never.first_tick, 0u);
  const NodeStatistics& condition = statistics.nodes[4];
  EXPECT_EQ(condition.ticks, 25u);
  EXPECT_GT(condition.results_of(Status::kFailure), 0u);
  EXPECT_GT(condition.flips, 0u);
  EXPECT_DOUBLE_EQ(condition.flips_per_minute, static_cast<double>(condition.flips) * 6);
}

TEST(Statistics, ArePrintedInTheOrderThatIsAskedFor) {
  const Statistics statistics = TenSeconds();
  const std::string text = PrintStatistics(statistics, StatisticsOrder::kTree);
  EXPECT_THAT(text, HasSubstr("101 ticks in 10.0 s"));
  EXPECT_THAT(text, HasSubstr("never"));
  const auto json = nlohmann::json::parse(StatisticsToJson(statistics, StatisticsOrder::kFlips));
  EXPECT_EQ(json["ticks"], 101);
  EXPECT_EQ(json["nodes"].size(), 7u);
  for (std::size_t i = 1; i < 7; ++i) {
    EXPECT_GE(json["nodes"][i - 1]["flips"], json["nodes"][i]["flips"]);
  }
}

// Runs for 300 ms, with a pause of 10 s after the second of its four ticks.
Statistics PausedSleep() {
  RecordedRun run("<BehaviorTree ID='Main'><Sleep name='sleep' msec='10300'/></BehaviorTree>");
  run.Tick();
  run.Tick(milliseconds(50));
  const Time from = run.clock.Now();
  run.clock.Advance(std::chrono::seconds(10));
  run.keeper.run.OnNote(NoteOf({from, run.clock.Now()}));
  run.clock.Advance(milliseconds(50));
  run.Tick();
  run.Tick();
  return StatisticsOf(run.keeper.run);
}

TEST(Statistics, AnActivationDoesNotCountTheTimeInWhichTheTreeWasPaused) {
  const NodeStatistics sleep = PausedSleep().nodes[0];
  ASSERT_EQ(sleep.activations.count, 1u);
  EXPECT_EQ(sleep.activations.max, milliseconds(300));
}

TEST(Statistics, TicksAreAsFarApartAsTheTreeRanBetweenThem) {
  EXPECT_EQ(PausedSleep().periods.max, milliseconds(100));
}

TEST(Statistics, KnowHowLongTheTreeStoodStill) {
  EXPECT_EQ(PausedSleep().paused, std::chrono::seconds(10));
}

TEST(Statistics, ATickDoesNotCountTheTimeAtItsBreakpoint) {
  RecordedRun run("<BehaviorTree ID='Main'><AlwaysSuccess/></BehaviorTree>");
  const Time start = run.clock.Now();
  run.keeper.run.OnTick({1, start, milliseconds(2003), Status::kSuccess, true, {}});
  const Time from = start + milliseconds(1);
  run.keeper.run.OnNote(NoteOf({from, from + std::chrono::seconds(2)}));
  EXPECT_EQ(StatisticsOf(run.keeper.run).tick_durations.max, milliseconds(3));
}

// A simulated clock stands still while the tree stands.
TEST(Statistics, ATickDoesNotCountTheTimeAtItsBreakpointOnSimulatedTime) {
  RecordedRun run("<BehaviorTree ID='Main'><AlwaysSuccess/></BehaviorTree>");
  const Time start = run.clock.Now();
  run.keeper.run.OnNote(NoteOf({start, start, 7, std::chrono::seconds(2)}));
  run.keeper.run.OnNote(NoteOf({start, start, 7, std::chrono::seconds(1)}));
  run.keeper.run.OnTick({7, start, milliseconds(3003), Status::kSuccess, true, {}});
  run.keeper.run.OnTick({8, start, milliseconds(2), Status::kSuccess, true, {}});
  EXPECT_EQ(StatisticsOf(run.keeper.run).tick_durations.max, milliseconds(3));
  EXPECT_EQ(StatisticsOf(run.keeper.run).tick_durations.p50, milliseconds(2));
}

}  // namespace
}  // namespace coppice
