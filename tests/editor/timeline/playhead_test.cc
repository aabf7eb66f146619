#include "editor/timeline/playhead.h"

#include <gtest/gtest.h>

#include "tests/editor/timeline/executed_run.h"

namespace coppice::editor {
namespace {

using std::chrono::milliseconds;

class PlayheadTest : public testing::Test {
 protected:
  PlayheadTest() {
    for (int i = 0; i < 10; ++i) robot_.Tick(milliseconds(100));
  }
  ExecutedTree robot_{R"(<BehaviorTree ID="Main"><Do as="work"/></BehaviorTree>)"};
  coppice::editor::Run run_;
  Follow follow_{robot_.executor, run_};
  Playhead head_{run_};
};

TEST_F(PlayheadTest, IsGluedToNowUntilItIsMoved) {
  EXPECT_EQ(head_.tick(), 9U);
  robot_.Tick();
  EXPECT_EQ(head_.tick(), 10U);
  head_.Step(-1);
  EXPECT_EQ(head_.tick(), 9U);
  EXPECT_FALSE(head_.is_at_now());
  robot_.Tick();
  EXPECT_EQ(head_.tick(), 9U);
  head_.GoToNow();
  EXPECT_EQ(head_.tick(), 11U);
}

TEST_F(PlayheadTest, StepsWithinTheRunAndBackToNow) {
  head_.GoToTick(1);
  head_.Step(-5);
  EXPECT_EQ(head_.tick(), 0U);
  head_.Step(9);
  EXPECT_EQ(head_.tick(), 9U);
  EXPECT_FALSE(head_.is_at_now());
  head_.Step(1);
  EXPECT_TRUE(head_.is_at_now());
}

TEST_F(PlayheadTest, StepsToTheChangesOfANode) {
  robot_.results["work"] = Status::kFailure;
  robot_.Tick();
  robot_.Tick();
  head_.GoToTick(3);
  head_.StepToChange(kRootNode, true);
  EXPECT_EQ(head_.tick(), 10U);
  head_.StepToChange(kRootNode, true);
  EXPECT_EQ(head_.tick(), 10U) << "there is no further one";
  head_.StepToChange(kRootNode, false);
  EXPECT_EQ(head_.tick(), 0U);
}

TEST_F(PlayheadTest, PlaysAsFastAsItHappenedTimesTheSpeed) {
  head_.Play();
  EXPECT_EQ(head_.tick(), 0U) << "from the last tick it begins anew";
  head_.Advance(0.25);
  EXPECT_EQ(head_.tick(), 2U);
  head_.SetSpeed(2);
  head_.Advance(0.1);
  EXPECT_EQ(head_.tick(), 4U);
  EXPECT_EQ(head_.time(), Time(milliseconds(450)));
  head_.Advance(60);
  EXPECT_TRUE(head_.is_at_now());
  EXPECT_FALSE(head_.is_playing());
  head_.SetSpeed(1000);
  EXPECT_EQ(head_.speed(), 32);
}

TEST_F(PlayheadTest, DoesNothingInAnEmptyRun) {
  const coppice::editor::Run empty;
  Playhead head(empty);
  head.Play();
  head.Advance(1);
  head.Step(-1);
  head.StepToChange(kRootNode, true);
  head.GoToTime(Time(milliseconds(5)));
  EXPECT_EQ(head.tick(), 0U);
  EXPECT_EQ(head.time(), Time{});
}

}  // namespace
}  // namespace coppice::editor
