#include "robot_app/perception/clouds/hidden.h"

#include <gtest/gtest.h>

#include "tests/robot_app/perception/clouds/painted_image.h"

namespace coppice::robot::perception {
namespace {

TEST(IsHidden, WhatIsBehindAPillarIsHidden) {
  const RangeImage image = PaintedCloud({{2, 0, 0.3, 1.8}}).image();
  EXPECT_TRUE(IsHidden(image, {4, 0}));
}

TEST(IsHidden, WhatIsBeforeOrBesideAPillarIsNot) {
  const RangeImage image = PaintedCloud({{2, 0, 0.3, 1.8}}).image();
  EXPECT_FALSE(IsHidden(image, {1.2F, 0}));
  EXPECT_FALSE(IsHidden(image, {2, 1}));
  EXPECT_FALSE(IsHidden(image, {-4, 0}));
}

TEST(IsHidden, WhoStandsThereDoesNotHideHimself) {
  const RangeImage image = PaintedCloud({{2, 0, 0.25, 1.8}}).image();
  EXPECT_FALSE(IsHidden(image, {2, 0}));
}

TEST(IsHidden, ALowDeskHidesNobody) {
  const RangeImage image = PaintedCloud({{2, 0, 0.4, 0.5}}).image();
  EXPECT_FALSE(IsHidden(image, {4, 0}));
}

TEST(IsHidden, WhatIsTooNearToBeMeasuredIsHidden) {
  EXPECT_TRUE(IsHidden(PaintedCloud({}).image(), {0.3F, 0}));
}

}  // namespace
}  // namespace coppice::robot::perception
