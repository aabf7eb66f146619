#include "bt_core/base/status.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

TEST(Status, HasTheNamesThatTheProtocolShows) {
  EXPECT_STREQ(ToString(Status::kIdle), "IDLE");
  EXPECT_STREQ(ToString(Status::kRunning), "RUNNING");
  EXPECT_STREQ(ToString(Status::kSuccess), "SUCCESS");
  EXPECT_STREQ(ToString(Status::kFailure), "FAILURE");
  EXPECT_STREQ(ToString(Status::kSkipped), "SKIPPED");
}

TEST(Status, HasTheNumbersOfTheProtocol) {
  EXPECT_EQ(static_cast<int>(Status::kIdle), 0);
  EXPECT_EQ(static_cast<int>(Status::kRunning), 1);
  EXPECT_EQ(static_cast<int>(Status::kSuccess), 2);
  EXPECT_EQ(static_cast<int>(Status::kFailure), 3);
  EXPECT_EQ(static_cast<int>(Status::kSkipped), 4);
}

TEST(Status, OnlySuccessAndFailureAreCompleted) {
  EXPECT_TRUE(IsCompleted(Status::kSuccess));
  EXPECT_TRUE(IsCompleted(Status::kFailure));
  EXPECT_FALSE(IsCompleted(Status::kIdle));
  EXPECT_FALSE(IsCompleted(Status::kRunning));
  EXPECT_FALSE(IsCompleted(Status::kSkipped));
}

}  // namespace
}  // namespace coppice
