#include <gtest/gtest.h>

#include "bt_core/testing/scenario_player.h"
#include "bt_core/testing/scenario_writer.h"
#include "tests/bt_core/engine/fixture.h"
#include "tests/bt_core/testing/with_stand_ins.h"

namespace coppice {
namespace {

using std::chrono::milliseconds;

class RecordScenarioTest : public testing::Test {
 protected:
  void Make(const std::string& root) {
    Diagnostics diagnostics;
    program_ = CompileWithStandIns(Main(root), diagnostics);
    ASSERT_TRUE(program_) << diagnostics.ToString();
  }
  static PlacedRule Rule(const std::string& pattern, std::vector<Status> results,
                         Duration duration = Duration(0)) {
    PlacedRule placed;
    placed.rule = {pattern, {}};
    placed.rule.script.results = std::move(results);
    placed.rule.script.duration = duration;
    return placed;
  }
  static ScenarioStep After(Duration time) {
    ScenarioStep step;
    step.advance = time;
    return step;
  }

  std::shared_ptr<const Program> program_;
};

TEST_F(RecordScenarioTest, WhatHappenedIsExpected) {
  Make(R"(<Sequence><Script code="n := 3"/><Go/><Stay name="s"/></Sequence>)");
  const Scenario scenario = RecordScenario(
      *program_,
      {Rule("<Go>", {Status::kSuccess}), Rule("s", {Status::kRunning, Status::kFailure})},
      {ScenarioStep(), ScenarioStep()}, "twice");
  EXPECT_EQ(scenario.name, "twice");
  ASSERT_EQ(scenario.steps.size(), 2U);
  const Expectations& first = scenario.steps[0].expect;
  EXPECT_EQ(first.status->status, Status::kRunning);
  EXPECT_EQ(first.events->events.back().leaf, "s");
  ASSERT_EQ(first.blackboard.size(), 1U);
  EXPECT_EQ(first.blackboard[0].value.key + first.blackboard[0].value.text, "n3");
  EXPECT_EQ(scenario.steps[1].expect.status->status, Status::kFailure);
  EXPECT_TRUE(scenario.steps[1].expect.blackboard.empty());
  EXPECT_TRUE(RunScenario(*program_, {}, scenario).differences.empty());
}

TEST_F(RecordScenarioTest, StepsInWhichNothingNewHappensBecomeOne) {
  Make("<Go/>");
  const std::vector<ScenarioStep> steps(60, After(milliseconds(100)));
  const Scenario scenario =
      RecordScenario(*program_, {Rule("<Go>", {}, milliseconds(5000))}, steps, "long");
  // The activation begins in the first step, is over after 5 s and begins anew.
  ASSERT_EQ(scenario.steps.size(), 4U);
  EXPECT_EQ(scenario.steps[1].advance, milliseconds(5000));
  EXPECT_EQ(scenario.steps[1].expect.status->status, Status::kSuccess);
  EXPECT_TRUE(RunScenario(*program_, {}, scenario).differences.empty());
}

TEST_F(RecordScenarioTest, StepsThatCountStay) {
  Make("<Go/>");
  const std::vector<ScenarioStep> steps(4, After(milliseconds(100)));
  const Scenario scenario = RecordScenario(
      *program_,
      {Rule("<Go>", {Status::kRunning, Status::kRunning, Status::kRunning, Status::kFailure})},
      steps, "counts");
  EXPECT_EQ(scenario.steps.size(), 4U) << "the fourth result comes in the fourth tick";
}

TEST_F(RecordScenarioTest, ANodeGoesByItsNameIfNoOtherHasIt) {
  Make(R"(<Sequence><Go name="a"/><Go name="b"/><Go name="b"/><Go name="c/d"/></Sequence>)");
  EXPECT_EQ(PatternOf(*program_, NodeIndex{1}), "a");
  EXPECT_EQ(PatternOf(*program_, NodeIndex{2}), "/b");
  EXPECT_EQ(PatternOf(*program_, NodeIndex{4}), "c/d");
}

}  // namespace
}  // namespace coppice
