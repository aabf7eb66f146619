#include "robot_app/common/transforms/message_time.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace coppice::robot {
namespace {

using testing::HasSubstr;

const ros::Time kNow(1000, 0);

std::string ProblemOf(double stamp) { return CheckStamp(ros::Time(stamp), kNow).problem(); }

TEST(MessageTime, MayBeALittleOldOrAhead) {
  EXPECT_EQ(ProblemOf(1000), "");
  EXPECT_EQ(ProblemOf(945), "");
  EXPECT_EQ(ProblemOf(1009), "");
}

TEST(MessageTime, IsRefusedFromElsewhere) {
  EXPECT_EQ(ProblemOf(930), "its stamp is 70 s old");
  EXPECT_EQ(ProblemOf(0), "its stamp is 1e+03 s old");
  EXPECT_EQ(ProblemOf(1020), "its stamp is 20 s ahead of now");
  const ros::Time last(std::numeric_limits<std::uint32_t>::max(), 999'999'999);
  EXPECT_THAT(CheckStamp(last, kNow).problem(), HasSubstr("ahead"));
}

TEST(MessageTime, IsBelievedToBeHalfASecondAheadAtTheMost) {
  EXPECT_EQ(BelievedStamp(ros::Time(940), kNow), ros::Time(940));
  EXPECT_EQ(BelievedStamp(ros::Time(1000.25), kNow), ros::Time(1000.25));
  EXPECT_EQ(BelievedStamp(ros::Time(1009), kNow), ros::Time(1000.5));
}

TEST(MessageTime, HasNoMoreNanosecondsThanASecond) {
  ros::Time wild = kNow;
  wild.nsec = 1'000'000'000;
  EXPECT_THAT(CheckStamp(wild, kNow).problem(), HasSubstr("none"));
}

}  // namespace
}  // namespace coppice::robot
