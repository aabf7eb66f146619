#include "editor/timeline/time_view.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

using std::chrono::seconds;

TEST(TimeViewTest, FollowsTheEndOfTheRunUntilItIsMoved) {
  TimeView view;
  view.Follow(Time(seconds(100)));
  EXPECT_LT(view.begin(), Time(seconds(91)));
  EXPECT_GT(view.end(), Time(seconds(100)));
  view.Pan(-0.5);
  const Time begin = view.begin();
  view.Follow(Time(seconds(200)));
  EXPECT_EQ(view.begin(), begin);
  view.StartFollowing();
  view.Follow(Time(seconds(200)));
  EXPECT_GT(view.end(), Time(seconds(200)));
}

TEST(TimeViewTest, ZoomsAtTheMouse) {
  TimeView view;
  view.Fit(Time(seconds(0)), Time(seconds(100)));
  const Time fixed = view.At(0.25);
  view.Zoom(0.1, 0.25);
  EXPECT_NEAR(view.PartOf(fixed), 0.25, 1e-6);
  EXPECT_LT(view.span(), seconds(11));
  for (int i = 0; i < 200; ++i) view.Zoom(0.5, 0.5);
  EXPECT_GT(view.span(), Duration::zero()) << "it stops somewhere";
  for (int i = 0; i < 200; ++i) view.Zoom(2, 0.5);
  EXPECT_LE(view.span(), std::chrono::hours(24 * 365));
}

TEST(TimeViewTest, RevealsAMomentByMovingAsLittleAsNeeded) {
  TimeView view;
  view.Fit(Time(seconds(10)), Time(seconds(20)));
  const Time begin = view.begin();
  view.Reveal(Time(seconds(15)));
  EXPECT_EQ(view.begin(), begin);
  view.Reveal(Time(seconds(30)));
  EXPECT_GT(view.end(), Time(seconds(30)));
  EXPECT_LT(view.begin(), Time(seconds(30)));
  view.Reveal(Time(seconds(1)));
  EXPECT_LT(view.begin(), Time(seconds(1)));
}

}  // namespace
}  // namespace coppice::editor
