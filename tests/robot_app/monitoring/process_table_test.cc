#include "robot_app/monitoring/process_table.h"

#include <gtest/gtest.h>

namespace coppice::robot::monitoring {
namespace {

using leaves::HealthLevel;

Finding Error() { return {"node", "/a", "/a", HealthLevel::kError, 0, "", "silent", Time{}}; }

ProcessTable With(ProcessPhase phase, const std::string& message = "") {
  ProcessTable table;
  table.by_node["/a"].phase = phase;
  table.by_node["/a"].message = message;
  return table;
}

TEST(ProcessTable, AStartingNodeIsWell) {
  Finding finding = Error();
  ApplyGrace(With(ProcessPhase::kStarting), "/a", finding);
  EXPECT_EQ(finding.level, HealthLevel::kOk);
  EXPECT_EQ(finding.message, "starting");
  EXPECT_TRUE(With(ProcessPhase::kStarting).IsStarting("/a"));
  EXPECT_FALSE(With(ProcessPhase::kReady).IsStarting("/a"));
  EXPECT_FALSE(With(ProcessPhase::kStarting).IsStarting("/b"));
}

TEST(ProcessTable, ANodeThatTheSupervisorStartsByItselfIsOnlyAWarning) {
  Finding finding = Error();
  ApplyGrace(With(ProcessPhase::kBackingOff, "ended by signal 9"), "/a", finding);
  EXPECT_EQ(finding.level, HealthLevel::kWarn);
}

TEST(ProcessTable, AnErrorStaysOneAndTellsWhatTheSupervisorKnows) {
  for (const auto phase : {ProcessPhase::kStopped, ProcessPhase::kReady, ProcessPhase::kGivenUp}) {
    Finding finding = Error();
    ApplyGrace(With(phase, "ended by signal 9"), "/a", finding);
    EXPECT_EQ(finding.level, HealthLevel::kError);
    EXPECT_EQ(finding.message, "silent; process ended by signal 9");
  }
}

TEST(ProcessTable, AnUnknownNodeHasNoGrace) {
  Finding finding = Error();
  ApplyGrace({}, "/a", finding);
  EXPECT_EQ(finding.level, HealthLevel::kError);
  EXPECT_EQ(finding.message, "silent");
}

}  // namespace
}  // namespace coppice::robot::monitoring
