#include "bt_core/analysis/why/why.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bt_core/analysis/asked_run.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;

TEST(Why, TellsTheWalkAndWhatWasRead) {
  RecordedRun run(kPatrol, Lamps());
  run.executor.Writer<double>("battery").Send(50);
  run.executor.Writer<double>("lux").Send(3);
  run.Tick();
  Asked asked(run.keeper.run);
  const Why why = asked.Ask("drive");
  EXPECT_TRUE(why.was_ticked);
  EXPECT_EQ(why.status, Status::kRunning);
  ASSERT_EQ(why.steps.size(), 6u);
  EXPECT_EQ(asked.tree().NameOf(why.steps[0].node), "root");
  EXPECT_EQ(asked.tree().NameOf(why.steps[2].node), "battery_low");
  EXPECT_EQ(why.steps[2].cause, WhyCause::kScript);
  EXPECT_EQ(why.steps[2].script->answer, false);
  EXPECT_TRUE(why.steps[5].is_asked);
  const std::string text = asked.Print("drive");
  EXPECT_THAT(text,
              HasSubstr(R"(battery_low  FAILURE  code="battery < 20" is false: battery = 50)"));
  EXPECT_THAT(text, HasSubstr("dark  SUCCESS  lux = 3"));
  EXPECT_THAT(text, HasSubstr(R"(safety  FAILURE  because of "battery_low")"));
}

TEST(Why, NamesWhatChangedSinceTheTickBefore) {
  RecordedRun run(kPatrol, Lamps());
  const Sender<double> battery = run.executor.Writer<double>("battery");
  battery.Send(50);
  run.executor.Writer<double>("lux").Send(30);
  run.Tick();
  battery.Send(12);
  run.Tick();
  Asked asked(run.keeper.run);
  const Why why = asked.Ask("root");
  ASSERT_TRUE(why.change);
  EXPECT_EQ(asked.tree().NameOf(why.change->step.node), "battery_low");
  EXPECT_THAT(
      asked.Print("root"),
      HasSubstr(
          R"(first change: "battery_low" is SUCCESS and was FAILURE before; code="battery < 20" )"
          "is true: battery = 12 (was 50)"));
  EXPECT_EQ(asked.WhyNotText("drive"),
            R"("root" did not reach "work", because "safety", which comes before it, is SUCCESS)");
}

TEST(Why, TheCodeOfAnActionIsNoCondition) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Script name='counts' code='count := 3'/></BehaviorTree>");
  run.Tick();
  Asked asked(run.keeper.run);
  EXPECT_THAT(asked.Print("counts"), HasSubstr(R"(counts  SUCCESS  code="count := 3")"));
  EXPECT_THAT(asked.Print("counts"), testing::Not(HasSubstr("is true")));
}

TEST(Why, OfATickThatStandsAtABreakpointTellsTheWalkSoFar) {
  RecordedRun run(kPatrol, Lamps());
  run.executor.Writer<double>("battery").Send(50);
  run.executor.Writer<double>("lux").Send(3);
  run.Tick();
  const Recording& whole = run.keeper.run;
  TickEvents events = whole.EventsOf(0);
  --events.words.size;  // the result of the root is missing
  events.is_whole = false;
  Recording part;
  part.OnTree(whole.trees()[0]);
  part.OnState(whole.sections()[0].state);
  part.OnTick(events);
  Asked asked(part);
  const Why why = asked.Ask("root");
  ASSERT_TRUE(why.why_not);
  EXPECT_EQ(why.why_not->cause, WhyNot::Cause::kNotWhole);
  ASSERT_GE(why.steps.size(), 2u);
  EXPECT_EQ(asked.tree().NameOf(why.steps[0].node), "safety");
  EXPECT_EQ(why.steps[0].depth, 1u) << "below the root, which has not ended";
}

TEST(Why, SaysThatNothingChanged) {
  RecordedRun run("<BehaviorTree ID='Main'><AlwaysFailure name='a'/></BehaviorTree>");
  run.Tick();
  run.Tick();
  EXPECT_FALSE(Asked(run.keeper.run).Ask("a").change);
}

}  // namespace
}  // namespace coppice
