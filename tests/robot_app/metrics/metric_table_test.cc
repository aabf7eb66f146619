#include "robot_app/metrics/metric_table.h"

#include <gtest/gtest.h>

namespace coppice::robot::metrics {
namespace {

TEST(MetricTable, PutsWhatHasOneNameTogether) {
  MetricTable table;
  table.Counter("b_total", "of b", {{"tree", "x"}}, 1);
  table.Gauge("a", "of a", {}, 0.5);
  table.Counter("b_total", "of b", {{"tree", "y"}}, 2);
  EXPECT_EQ(table.Text(),
            "# HELP a of a\n# TYPE a gauge\na 0.5\n"
            "# HELP b_total of b\n# TYPE b_total counter\n"
            "b_total{tree=\"x\"} 1\nb_total{tree=\"y\"} 2\n");
}

TEST(MetricTable, EscapesTextsOfOthers) {
  MetricTable table;
  table.Gauge("a", "of a", {{"subject", "a \"b\"\\\n}"}}, 1);
  EXPECT_EQ(table.Text(), "# HELP a of a\n# TYPE a gauge\na{subject=\"a \\\"b\\\"\\\\\\n}\"} 1\n");
}

TEST(MetricTable, CountsDurationsUpToTheirLimits) {
  DurationCounts durations({0.1, 1});
  for (const double seconds : {0.05, 0.1, 0.5, 5.0}) durations.Add(seconds);
  MetricTable table;
  table.Histogram("d", "of d", {}, durations);
  EXPECT_EQ(table.Text(),
            "# HELP d of d\n# TYPE d histogram\nd_count 4\nd_sum 5.65\n"
            "d_bucket{le=\"0.1\"} 2\nd_bucket{le=\"1\"} 3\nd_bucket{le=\"+Inf\"} 4\n");
}

}  // namespace
}  // namespace coppice::robot::metrics
