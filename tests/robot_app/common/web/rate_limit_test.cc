#include "robot_app/common/web/rate_limit.h"

#include <gtest/gtest.h>

namespace coppice::robot {
namespace {

TEST(RateLimit, LetsABurstThroughAndThenSoManyASecond) {
  RateLimit limit(10);
  int passed = 0;
  for (int i = 0; i < 100; ++i) passed += limit.MayPass(1000);
  EXPECT_EQ(passed, 10);
  EXPECT_FALSE(limit.MayPass(1000.05));
  EXPECT_TRUE(limit.MayPass(1000.2));
}

}  // namespace
}  // namespace coppice::robot
