#include "robot_app/assistance/channels/letter_queue.h"

#include <gmock/gmock.h>

namespace coppice::robot::assistance {
namespace {

using std::chrono::seconds;
using Progress = LetterQueue::Progress;

class Letters : public testing::Test {
 protected:
  Letter Only(Time now) {
    const std::vector<Letter> due = queue_.TakeDue(now);
    EXPECT_EQ(due.size(), 1u);
    return due.empty() ? Letter{} : due.front();
  }

  const std::vector<HumanSupervisor> people_{{"Ada", {{"telegram", "1"}, {"mail", "a@b"}}}};
  LetterQueue queue_{people_};
};

TEST_F(Letters, ALetterIsHandedOutOnceUntilItIsReported) {
  queue_.Add({});
  EXPECT_EQ(Only(Time(seconds(0))).number, 1u);
  EXPECT_TRUE(queue_.TakeDue(Time(seconds(100))).empty());
  EXPECT_EQ(queue_.Delivered(1, true, Time(seconds(100))).progress, Progress::kDelivered);
  EXPECT_TRUE(queue_.TakeDue(Time(seconds(200))).empty());
}

TEST_F(Letters, TheNextWayIsTriedAtOnceAndTheFirstAgainAfterAWhile) {
  queue_.Add({});
  EXPECT_EQ(Only(Time(seconds(0))).way, 0u);
  EXPECT_EQ(queue_.Delivered(1, false, Time(seconds(1))).progress, Progress::kTryingNextWay);
  EXPECT_EQ(Only(Time(seconds(1))).way, 1u);
  EXPECT_EQ(queue_.Delivered(1, false, Time(seconds(2))).progress, Progress::kNoWayWorked);
  EXPECT_TRUE(queue_.TakeDue(Time(seconds(2))).empty());
  EXPECT_EQ(Only(Time(seconds(2) + LetterQueue::kRetryAfter)).way, 0u);
}

TEST_F(Letters, ALetterThatNeverWorksIsDroppedInTheEnd) {
  queue_.Add({});
  Time now{};
  int attempts = 0;
  for (; attempts < 1000; ++attempts) {
    const std::vector<Letter> due = queue_.TakeDue(now);
    if (due.empty()) break;
    if (queue_.Delivered(1, false, now).progress == Progress::kNoWayWorked) {
      now += LetterQueue::kRetryAfter;
    }
  }
  EXPECT_EQ(attempts, 2 * LetterQueue::kMostRounds);
}

TEST_F(Letters, AReportOfALetterThatWasDroppedMeansNothing) {
  queue_.Add({});
  Only(Time(seconds(0)));
  queue_.DropIf([](const Letter& letter) { return letter.request == 0; });
  EXPECT_EQ(queue_.Delivered(1, false, Time(seconds(1))).progress, Progress::kUnknown);
  EXPECT_TRUE(queue_.TakeDue(Time(seconds(100))).empty());
}

}  // namespace
}  // namespace coppice::robot::assistance
