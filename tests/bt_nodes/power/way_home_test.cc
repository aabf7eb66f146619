#include "bt_nodes/power/way_home.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::leaves {
namespace {

constexpr Time At(int seconds) { return Time(std::chrono::seconds(100 + seconds)); }

TEST(WayHome, IsEstimatedAsLongAsNobodyHasMeasuredIt) {
  EXPECT_DOUBLE_EQ(WayHome().Length(10, At(0)), 15);
  EXPECT_DOUBLE_EQ(WayHome(2).Length(10, At(0)), 20);
}

TEST(WayHome, IsWhatTheNavigationHasMeasured) {
  WayHome way;
  way.OnMeasured(37, At(0));
  EXPECT_DOUBLE_EQ(way.Length(10, At(3)), 37);
}

TEST(WayHome, IsEstimatedAgainWhenTheNavigationIsSilent) {
  WayHome way;
  way.OnMeasured(37, At(0));
  EXPECT_DOUBLE_EQ(way.Length(10, At(4)), 15);
  way.OnMeasured(36, At(5));
  EXPECT_DOUBLE_EQ(way.Length(10, At(5)), 36);
}

TEST(WayHome, DoesNotBelieveWhatIsNoLength) {
  WayHome way;
  way.OnMeasured(-1, At(0));
  way.OnMeasured(NAN, At(0));
  way.OnMeasured(INFINITY, At(0));
  EXPECT_DOUBLE_EQ(way.Length(10, At(0)), 15);
}

}  // namespace
}  // namespace coppice::leaves
