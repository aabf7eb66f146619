#include "bt_nodes/recovery/recovery_count.h"

#include <gtest/gtest.h>

namespace coppice::leaves {
namespace {

class RecoveryCountTest : public testing::Test {
 protected:
  // Begins and ends, in seconds, at a place.
  void Recover(const std::string& recovery, const std::string& subject, int begin, int end,
               double x, RecoveryPhase phase = RecoveryPhase::kSucceeded) {
    Add(recovery, subject, begin, x, RecoveryPhase::kBegun);
    Add(recovery, subject, end, x, phase);
  }
  void Add(const std::string& recovery, const std::string& subject, int at, double x,
           RecoveryPhase phase) {
    events_.push_back(
        {recovery, subject, phase, 1, Time(std::chrono::seconds(at)), Pose2D{x, 0, 0}, ""});
  }
  std::vector<RecoveryEvent> events_;
};

TEST_F(RecoveryCountTest, CountsByBothReadings) {
  Recover("wait", "navigation", 0, 20, 0);
  Recover("wait", "navigation", 50, 70, 5);    // soon, elsewhere: against the first, strictly
  Recover("back", "navigation", 500, 510, 5);  // the same place, late: against the second, strictly
  const std::vector<RecoveryCount> counts = CountRecoveries(events_);
  ASSERT_EQ(counts.size(), 2u);
  EXPECT_EQ(counts[0].recovery, "wait");
  EXPECT_EQ(counts[0].begun, 2);
  EXPECT_EQ(counts[0].succeeded, 2);
  EXPECT_EQ(counts[0].helped, 2);
  EXPECT_EQ(counts[0].helped_strictly, 0);
  EXPECT_EQ(counts[1].helped_strictly, 1) << "the last one counts as success";
}

TEST_F(RecoveryCountTest, AFailedOneIsBegunAndDidNotHelp) {
  Recover("wait", "navigation", 0, 20, 0, RecoveryPhase::kFailed);
  const std::vector<RecoveryCount> counts = CountRecoveries(events_);
  ASSERT_EQ(counts.size(), 1u);
  EXPECT_EQ(counts[0].begun, 1);
  EXPECT_EQ(counts[0].succeeded + counts[0].helped + counts[0].helped_strictly, 0);
}

}  // namespace
}  // namespace coppice::leaves
