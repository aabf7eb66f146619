#include "robot_app/metrics/tree_metrics.h"

#include <gmock/gmock.h>

#include "bt_core/engine/executor.h"
#include "bt_core/engine/program.h"
#include "bt_core/model/project.h"

namespace coppice::robot::metrics {
namespace {

using testing::HasSubstr;
using testing::Not;

std::shared_ptr<const Program> MakeProgram(const std::string& children) {
  Diagnostics diagnostics;
  auto project = Project::FromText(R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Fallback>)" +
                                       children + "</Fallback></BehaviorTree></root>",
                                   "tree", diagnostics);
  return Compile(std::make_shared<const Project>(*std::move(project)),
                 std::make_shared<const Registry>(), diagnostics);
}

class TreeMetricsTest : public testing::Test {
 protected:
  TreeMetricsTest() { stream_.Add(metrics_); }
  ~TreeMetricsTest() override { stream_.Remove(metrics_); }

  std::string Text() {
    stream_.Flush();
    MetricTable table;
    metrics_.Collect(table);
    return table.Text();
  }

  SimulatedClock clock_;
  TreeMetrics metrics_{"monitor"};
  Executor executor_{MakeProgram(R"(<AlwaysFailure name="no"/><AlwaysSuccess name="yes"/>)"),
                     clock_};
  EventStream stream_{executor_};
};

TEST_F(TreeMetricsTest, CountsTicksAndWhatNodesReturn) {
  for (int i = 0; i < 3; ++i) executor_.Tick();
  const std::string text = Text();
  EXPECT_THAT(text, HasSubstr("coppice_ticks_total{tree=\"monitor\"} 3\n"));
  EXPECT_THAT(text, HasSubstr("coppice_tick_seconds_count{tree=\"monitor\"} 3\n"));
  EXPECT_THAT(text, HasSubstr(R"({tree="monitor",node="no",result="failure"} 3)"));
  EXPECT_THAT(text, HasSubstr(R"({tree="monitor",node="no",result="success"} 0)"));
  EXPECT_THAT(text, HasSubstr(R"({tree="monitor",node="yes",result="success"} 3)"));
}

TEST_F(TreeMetricsTest, NeverCountsBackwardsWhenTheTreeIsChanged) {
  executor_.Tick();
  executor_.Reload(MakeProgram(R"(<AlwaysSuccess name="other"/><AlwaysSuccess name="yes"/>)"));
  executor_.Tick();
  const std::string text = Text();
  EXPECT_THAT(text, HasSubstr(R"(node="no",result="failure"} 1)"));
  EXPECT_THAT(text, HasSubstr(R"(node="yes",result="success"} 1)"));
  EXPECT_THAT(text, HasSubstr(R"(node="other",result="success"} 1)"));
}

}  // namespace
}  // namespace coppice::robot::metrics
