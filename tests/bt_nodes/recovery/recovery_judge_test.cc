#include "bt_nodes/recovery/recovery_judge.h"

#include <gtest/gtest.h>

namespace coppice::leaves {
namespace {

using Verdicts = std::vector<RecoveryVerdict>;

class RecoveryJudgeTest : public testing::Test {
 protected:
  static RecoveryEvent Event(RecoveryPhase phase, double at, double x,
                             const std::string& subject = "navigation") {
    return {"wait",
            subject,
            phase,
            1,
            Time(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(at))),
            Pose2D{x, 0, 0},
            ""};
  }
  // A recovery at that place that succeeds at that time.
  static Verdicts Succeed(RecoveryJudge& judge, double at, double x,
                          const std::string& subject = "navigation") {
    Verdicts verdicts = judge.Take(Event(RecoveryPhase::kBegun, at - 5, x, subject));
    for (const auto& verdict : judge.Take(Event(RecoveryPhase::kSucceeded, at, x, subject))) {
      verdicts.push_back(verdict);
    }
    return verdicts;
  }

  RecoveryJudge judge_;
  RecoveryJudge strict_{{60, 1, true}};
};

TEST_F(RecoveryJudgeTest, HelpedIfNoneFollowsWithinAMinute) {
  Succeed(judge_, 100, 0);
  EXPECT_TRUE(judge_.Advance(Time(std::chrono::seconds(160))).empty());
  const Verdicts verdicts = judge_.Advance(Time(std::chrono::seconds(161)));
  ASSERT_EQ(verdicts.size(), 1u);
  EXPECT_TRUE(verdicts[0].helped);
  EXPECT_EQ(verdicts[0].ended, Time(std::chrono::seconds(100)));
}

TEST_F(RecoveryJudgeTest, DidNotHelpIfOneFollowsSoonAtTheSamePlace) {
  Succeed(judge_, 100, 0);
  const Verdicts verdicts = Succeed(judge_, 150, 0.9);
  ASSERT_EQ(verdicts.size(), 1u);
  EXPECT_FALSE(verdicts[0].helped);
}

TEST_F(RecoveryJudgeTest, HelpedIfTheNextIsSoonButElsewhere) {
  Succeed(judge_, 100, 0);
  EXPECT_TRUE(Succeed(judge_, 150, 5).empty()) << "not certain before the minute is over";
  const Verdicts verdicts = judge_.Advance(Time(std::chrono::seconds(161)));
  ASSERT_EQ(verdicts.size(), 1u);
  EXPECT_TRUE(verdicts[0].helped);
}

TEST_F(RecoveryJudgeTest, LooksAtTheTimeAloneWithoutAPose) {
  RecoveryEvent end = Event(RecoveryPhase::kSucceeded, 100, 0);
  end.pose.reset();
  judge_.Take(end);
  const Verdicts verdicts = judge_.Take(Event(RecoveryPhase::kBegun, 150, 5));
  ASSERT_EQ(verdicts.size(), 1u);
  EXPECT_FALSE(verdicts[0].helped);
}

TEST_F(RecoveryJudgeTest, LooksAtTheTimeAloneButForTheNavigation) {
  Succeed(judge_, 100, 0, "/camera");
  const Verdicts soon = Succeed(judge_, 150, 5, "/camera");
  ASSERT_EQ(soon.size(), 1u);
  EXPECT_FALSE(soon[0].helped) << "the robot drives on meanwhile";
  Succeed(strict_, 100, 0, "localization");
  const Verdicts late = Succeed(strict_, 500, 0, "localization");
  ASSERT_EQ(late.size(), 1u);
  EXPECT_TRUE(late[0].helped) << "at the same place";
}

TEST_F(RecoveryJudgeTest, KeepsSubjectsApart) {
  Succeed(judge_, 100, 0, "/a");
  EXPECT_TRUE(Succeed(judge_, 110, 0, "/b").empty());
  EXPECT_EQ(judge_.Finish().size(), 2u);
}

TEST_F(RecoveryJudgeTest, AFailedOneHasNotHelpedAndAnInterruptedOneIsNotJudged) {
  const Verdicts failed = judge_.Take(Event(RecoveryPhase::kFailed, 100, 0));
  ASSERT_EQ(failed.size(), 1u);
  EXPECT_FALSE(failed[0].helped);
  EXPECT_TRUE(judge_.Take(Event(RecoveryPhase::kInterrupted, 200, 0)).empty());
  EXPECT_TRUE(judge_.Take(Event(RecoveryPhase::kRefused, 200, 0)).empty());
  EXPECT_TRUE(judge_.Finish().empty());
}

TEST_F(RecoveryJudgeTest, CountsStrictlyByTimeOrPlace) {
  Succeed(strict_, 100, 0);
  Verdicts verdicts = Succeed(strict_, 150, 5);
  ASSERT_EQ(verdicts.size(), 1u);
  EXPECT_FALSE(verdicts[0].helped) << "elsewhere, but soon";
  verdicts = Succeed(strict_, 500, 5);
  ASSERT_EQ(verdicts.size(), 1u);
  EXPECT_FALSE(verdicts[0].helped) << "much later, but at the same place";
  verdicts = Succeed(strict_, 900, 0);
  ASSERT_EQ(verdicts.size(), 1u);
  EXPECT_TRUE(verdicts[0].helped);
  EXPECT_TRUE(strict_.Finish()[0].helped) << "the last one counts as success";
}

}  // namespace
}  // namespace coppice::leaves
