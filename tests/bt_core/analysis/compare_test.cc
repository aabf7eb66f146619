#include "bt_core/analysis/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bt_core/analysis/recorded_run.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;

constexpr char kTree[] =
    "<BehaviorTree ID='Main'><Sequence name='s'><ScriptCondition name='c' code='x &lt; 3'/>"
    "<AlwaysSuccess name='a'/></Sequence></BehaviorTree>";

struct Counted : RecordedRun {
  Counted(const std::string& tree, double at_tick_3) : RecordedRun(tree) {
    const Sender<double> x = executor.Writer<double>("x");
    for (int i = 0; i < 5; ++i) {
      x.Send(i == 2 ? at_tick_3 : 1);
      Tick();
    }
  }
};

TEST(CompareRuns, FindsNothingBetweenEqualRuns) {
  const RunComparison comparison =
      CompareRuns(Counted(kTree, 2).keeper.run, Counted(kTree, 2).keeper.run);
  EXPECT_TRUE(comparison.is_the_same());
  EXPECT_EQ(PrintComparison(comparison), "5 ticks: the same\n");
}

TEST(CompareRuns, NamesTheFirstTickInWhichTheyPart) {
  const RunComparison comparison =
      CompareRuns(Counted(kTree, 2).keeper.run, Counted(kTree, 7).keeper.run);
  ASSERT_TRUE(comparison.parting);
  EXPECT_EQ(comparison.parting->tick, 3u);
  EXPECT_EQ(comparison.parting->what, "Main{x}");
  EXPECT_EQ(comparison.parting->first, "= 2");
  EXPECT_EQ(comparison.parting->second, "= 7");
  EXPECT_EQ(comparison.different_ticks, 1u);
  const std::string text = PrintComparison(comparison);
  EXPECT_THAT(text, HasSubstr("  c: 1 ticks, first in tick 3: SUCCESS | FAILURE\n"));
  EXPECT_THAT(text, HasSubstr("  a: 1 ticks, first in tick 3: SUCCESS | not ticked\n"));
}

TEST(CompareRuns, MatchesNodesOfOtherTreesByPath) {
  const std::string other =
      "<BehaviorTree ID='Main'><Sequence name='s'><AlwaysSuccess name='new'/>"
      "<ScriptCondition name='c' code='x &lt; 3'/><AlwaysSuccess name='a'/></Sequence>"
      "</BehaviorTree>";
  const RunComparison comparison =
      CompareRuns(Counted(kTree, 2).keeper.run, Counted(other, 2).keeper.run);
  EXPECT_FALSE(comparison.parting) << comparison.parting->what;
  EXPECT_EQ(comparison.only_second, (std::vector<std::string>{"new"}));
  EXPECT_FALSE(comparison.is_the_same());
}

}  // namespace
}  // namespace coppice
