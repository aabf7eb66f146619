#include "robot_app/localization/local_view.h"

#include <gtest/gtest.h>

namespace coppice::robot::localization {
namespace {

const std::vector<Beam> kOneBeam = {{{0, 0}, {2, 0}, true}};

TEST(LocalView, IsCompleteAfterATurn) {
  LocalView view;
  EXPECT_TRUE(view.empty());
  EXPECT_TRUE(view.Add({}, kOneBeam));
  EXPECT_FALSE(view.Add({0, 0, 0.1}, kOneBeam));  // nothing new to see
  for (double yaw = 0.1; yaw < 2; yaw += 0.1) view.Add({0, 0, yaw}, kOneBeam);
  EXPECT_FALSE(view.complete());
  for (double yaw = 2; yaw < 3.2; yaw += 0.1) view.Add({0, 0, yaw}, kOneBeam);
  EXPECT_TRUE(view.complete());
  view.Clear();
  EXPECT_FALSE(view.complete());
  EXPECT_TRUE(view.empty());
}

TEST(LocalView, IsCompleteAfterAWay) {
  LocalView view;
  for (double x = 0; x < 3.7; x += 0.1) view.Add({x, 0, 0}, kOneBeam);
  EXPECT_TRUE(view.complete());
}

TEST(LocalView, PutsWhatWasSeenTogether) {
  LocalView view;
  view.Add({}, kOneBeam);
  view.Add({1, 0, M_PI / 2}, kOneBeam);
  const std::vector<Beam> all = view.From({1, 0, M_PI / 2});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_NEAR(all[0].to.x, 0, 1e-9);
  EXPECT_NEAR(all[0].to.y, -1, 1e-9);
  EXPECT_NEAR(all[1].to.x, 2, 1e-9);
}

TEST(LocalView, ForgetsTheOldest) {
  LocalView view;
  for (int i = 0; i < 100; ++i) view.Add({i * 1.0, 0, 0}, kOneBeam);
  EXPECT_LE(view.From({}).size(), 10u);
}

}  // namespace
}  // namespace coppice::robot::localization
