#include "editor/timeline/time_view.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

using std::chrono::seconds;

TEST(TimeViewTest, FollowsTheEndOfTheRunUntilItIsMoved) {
  TimeView view;
  view.Follow(seconds(100));
  EXPECT_LT(view.begin(), seconds(91));
  EXPECT_GT(view.end(), seconds(100));
  view.Pan(-0.5);
  const Time begin = view.begin();
  view.Follow(seconds(200));
  EXPECT_EQ(view.begin(), begin);
  view.StartFollowing();
  view.Follow(seconds(200));
  EXPECT_GT(view.end(), seconds(200));
}

TEST(TimeViewTest, ZoomsAtTheMouse) {
  TimeView view;
  view.Fit(seconds(0), seconds(100));
  const Time fixed = view.At(0.25);
  view.Zoom(0.1, 0.25);
  EXPECT_NEAR(view.PartOf(fixed), 0.25, 1e-6);
  EXPECT_LT(view.span(), seconds(11));
  for (int i = 0; i < 200; ++i) view.Zoom(0.5, 0.5);
  EXPECT_GT(view.span(), Time(0)) << "it stops somewhere";
  for (int i = 0; i < 200; ++i) view.Zoom(2, 0.5);
  EXPECT_LE(view.span(), std::chrono::hours(24 * 365));
}

TEST(TimeViewTest, RevealsAMomentByMovingAsLittleAsNeeded) {
  TimeView view;
  view.Fit(seconds(10), seconds(20));
  const Time begin = view.begin();
  view.Reveal(seconds(15));
  EXPECT_EQ(view.begin(), begin);
  view.Reveal(seconds(30));
  EXPECT_GT(view.end(), seconds(30));
  EXPECT_LT(view.begin(), seconds(30));
  view.Reveal(seconds(1));
  EXPECT_LT(view.begin(), seconds(1));
}

}  // namespace
}  // namespace coppice::editor
