#include "bt_nodes/recovery/budget.h"

#include <gtest/gtest.h>

namespace coppice::leaves {
namespace {

using std::chrono::seconds;

TEST(Budget, AllowsSoManyInSoLong) {
  Budget budget;
  EXPECT_TRUE(budget.Take(Time(seconds(0)), 2, seconds(60)));
  EXPECT_TRUE(budget.Take(Time(seconds(30)), 2, seconds(60)));
  EXPECT_FALSE(budget.Take(Time(seconds(59)), 2, seconds(60)));
  EXPECT_EQ(budget.used(Time(seconds(59)), seconds(60)), 2);
  EXPECT_TRUE(budget.Take(Time(seconds(60)), 2, seconds(60)));
  EXPECT_EQ(budget.used(Time(seconds(200)), seconds(60)), 0);
}

TEST(Budget, OfNoneAllowsNone) { EXPECT_FALSE(Budget().Take(Time(seconds(0)), 0, seconds(60))); }

}  // namespace
}  // namespace coppice::leaves
