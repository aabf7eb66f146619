#include "bt_core/live/client/client_history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bt_core/frames/payload_coding.h"
#include "tests/bt_core/live/encoded_run.h"
#include "tests/bt_core/live/watcher.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ClientHistoryTest : public ::testing::Test {
 protected:
  const RunId run_ = {1};
  const EncodedRun frames_{5};  // frame 7 is a state after tick 5
  Watcher watcher_;
  ClientHistory history_{watcher_};
};

TEST_F(ClientHistoryTest, KnowsWhichFrameIsNext) {
  EXPECT_FALSE(history_.next());
  EXPECT_FALSE(history_.Begin(run_, 1));
  EXPECT_EQ(history_.Add(1, 3, frames_[0] + frames_[1] + frames_[2]).problem(), "");
  EXPECT_EQ(history_.next(), 3u);
  EXPECT_EQ(history_.Add(3, 5, frames_[3] + frames_[4]).problem(), "");
  EXPECT_EQ(history_.next(), 5u);
  EXPECT_THAT(watcher_.watched().ticks, ElementsAre(1, 2, 3));
  EXPECT_EQ(watcher_.watched().frames,
            frames_[0] + frames_[1] + frames_[2] + frames_[3] + frames_[4]);
}

TEST_F(ClientHistoryTest, GoesOnInAnotherConnection) {
  history_.Begin(run_, 1);
  EXPECT_TRUE(history_.Add(1, 3, frames_[0] + frames_[1] + frames_[2]));
  EXPECT_TRUE(history_.Begin(run_, 3));
  EXPECT_EQ(history_.Add(3, 4, frames_[3]).problem(), "");
  EXPECT_THAT(watcher_.watched().ticks, ElementsAre(1, 2));
  EXPECT_THAT(watcher_.watched().gaps, IsEmpty());
}

TEST_F(ClientHistoryTest, ReportsAGapIfItCannotGoOn) {
  history_.Begin(run_, 1);
  EXPECT_TRUE(history_.Add(1, 3, frames_[0] + frames_[1] + frames_[2]));
  EXPECT_FALSE(history_.Begin(run_, 7));
  EXPECT_EQ(history_.Add(7, 8, frames_[0] + frames_[7]).problem(), "");
  const Watched watched = watcher_.watched();
  ASSERT_EQ(watched.gaps.size(), 1u);
  EXPECT_EQ(watched.gaps[0].first_tick, 2u);
  EXPECT_EQ(watched.gaps[0].last_tick, 5u);
  EXPECT_EQ(watched.gaps[0].lost_ticks, 4u);
  EXPECT_THAT(watched.frames, HasSubstr(MakeGapFrame(watched.gaps[0])));
  EXPECT_EQ(history_.next(), 8u);
}

TEST_F(ClientHistoryTest, TakesAnotherRunWithoutAGap) {
  history_.Begin(run_, 1);
  EXPECT_TRUE(history_.Add(1, 3, frames_[0] + frames_[1] + frames_[2]));
  EXPECT_FALSE(history_.Begin(RunId{2}, 1));
  EXPECT_EQ(history_.Add(1, 2, frames_[0] + frames_[1]).problem(), "");
  EXPECT_THAT(watcher_.watched().gaps, IsEmpty());
  EXPECT_EQ(watcher_.watched().trees.size(), 2u);
}

TEST_F(ClientHistoryTest, UnderstandsAHoleThatTheRobotMade) {
  history_.Begin(run_, 1);
  EXPECT_TRUE(history_.Add(1, 3, frames_[0] + frames_[1] + frames_[2]));
  HistoryGap gap;
  gap.lost_ticks = 4;
  EXPECT_EQ(history_.Add(7, 8, MakeGapFrame(gap) + frames_[0] + frames_[7]).problem(), "");
  EXPECT_EQ(history_.next(), 8u);
  EXPECT_EQ(watcher_.watched().gaps.size(), 1u);
}

TEST_F(ClientHistoryTest, RefusesWhatCannotBeRead) {
  history_.Begin(run_, 1);
  EXPECT_THAT(history_.Add(1, 2, frames_[0].substr(0, 5)).problem(), HasSubstr("cut off"));
  EXPECT_THAT(history_.Add(1, 2, frames_[0].substr(0, 20)).problem(), HasSubstr("cut off"));
  std::string damaged = frames_[0];
  damaged.back() ^= 1;
  EXPECT_THAT(history_.Add(1, 2, damaged).problem(), HasSubstr("checksum"));
  history_.Begin(run_, 1);
  EXPECT_EQ(history_.Add(1, 2, frames_[0] + frames_[1]).problem(), "");
  EXPECT_THAT(history_.Add(1, 2, frames_[2]).problem(), HasSubstr("twice"));
}

}  // namespace
}  // namespace coppice
