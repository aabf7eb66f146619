#include "bt_nodes/recovery/recovery_nodes.h"

#include <gtest/gtest.h>

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

class ContinueEpisodeTest : public testing::Test {
 protected:
  // The rung is 2; what is it after a pause and a way?
  int After(double seconds, double way) {
    episode_.Set("pose", Pose2D{0, 0, 0});
    episode_.Tick();
    episode_.Set("rung", 2);
    episode_.Set("pose", Pose2D{way, 0, 0});
    episode_.Advance(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds)));
    EXPECT_EQ(episode_.Tick(), Status::kSuccess);
    return episode_.Get<int>("rung");
  }
  LeafHarness episode_ = LeafHarness::For<ContinueEpisode>();
};

TEST_F(ContinueEpisodeTest, BeginsAtTheFirstRung) {
  episode_.Tick();
  EXPECT_EQ(episode_.Get<int>("rung"), 0);
}
TEST_F(ContinueEpisodeTest, GoesOnSoonAfterAtTheSamePlace) { EXPECT_EQ(After(60, 1), 2); }
TEST_F(ContinueEpisodeTest, EndsWithTime) { EXPECT_EQ(After(60.1, 0), 0); }
TEST_F(ContinueEpisodeTest, EndsWithTheWay) { EXPECT_EQ(After(1, 1.1), 0); }
TEST_F(ContinueEpisodeTest, DoesNotLookAtTheWayWithoutRadius) {
  episode_.Set("radius", 0.0);
  EXPECT_EQ(After(1, 50), 2);
}

class RecoveryTest : public testing::Test {
 protected:
  RecoveryTest() {
    recovery_.Set("recovery", std::string("wait"));
    recovery_.Set("subject", std::string("navigation"));
  }
  // What the recovery returns, and what it has recorded for that.
  std::vector<RecoveryPhase> Phases() const {
    std::vector<RecoveryPhase> phases;
    for (const RecoveryEvent& event : robot_.events) phases.push_back(event.phase);
    return phases;
  }
  FakeRobot robot_;
  LeafHarness recovery_ = LeafHarness::WithChildren<Recovery>(1, std::ref<RecoveryLog>(robot_));
};

TEST_F(RecoveryTest, RecordsBeginAndEnd) {
  recovery_.SetChild(0, {Status::kRunning});
  recovery_.Tick();
  recovery_.SetChild(0, {Status::kSuccess});
  EXPECT_EQ(recovery_.Tick(), Status::kSuccess);
  EXPECT_EQ(Phases(), (std::vector{RecoveryPhase::kBegun, RecoveryPhase::kSucceeded}));
  EXPECT_EQ(robot_.events[0].recovery, "wait");
  EXPECT_FALSE(robot_.events[0].pose);
}

TEST_F(RecoveryTest, RecordsThatItWasInterrupted) {
  recovery_.SetChild(0, {Status::kRunning});
  recovery_.Set("pose", Pose2D{1, 2, 0});
  recovery_.Tick();
  recovery_.Halt();
  EXPECT_EQ(Phases(), (std::vector{RecoveryPhase::kBegun, RecoveryPhase::kInterrupted}));
  EXPECT_EQ(robot_.events[1].pose->y, 2);
}

TEST_F(RecoveryTest, FailsWithoutTryingWhenTheBudgetIsUsedUp) {
  recovery_.Set("times", 2);
  recovery_.SetChild(0, {Status::kFailure});
  for (int i = 0; i < 9; ++i) EXPECT_EQ(recovery_.Tick(), Status::kFailure);
  EXPECT_EQ(Phases(),
            (std::vector{RecoveryPhase::kBegun, RecoveryPhase::kFailed, RecoveryPhase::kBegun,
                         RecoveryPhase::kFailed, RecoveryPhase::kRefused}))
      << "a refusal is told once";
  EXPECT_EQ(robot_.events[2].attempt, 2);
  recovery_.Advance(std::chrono::seconds(600));
  recovery_.Tick();
  EXPECT_EQ(robot_.events[5].phase, RecoveryPhase::kBegun);
  EXPECT_EQ(robot_.events[5].attempt, 1);
}

}  // namespace
}  // namespace coppice::leaves
