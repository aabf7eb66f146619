#include "robot_app/teleoperation/velocity_mux.h"

#include <gtest/gtest.h>

namespace coppice::robot::teleoperation {
namespace {

using std::chrono::milliseconds;

constexpr std::size_t kPerson = 0;
constexpr std::size_t kRobot = 1;
constexpr Velocity2D kAhead{0.3, 0};
constexpr Velocity2D kStill{0, 0};

class Mux : public testing::Test {
 protected:
  VelocityMux mux_{{milliseconds(500), milliseconds(500)}};
  Time now_{std::chrono::seconds(1000)};
};

TEST_F(Mux, APersonGoesBeforeTheRobot) {
  EXPECT_TRUE(mux_.Offer(kRobot, kAhead, now_));
  EXPECT_TRUE(mux_.Offer(kPerson, kStill, now_));
  EXPECT_FALSE(mux_.Offer(kRobot, kAhead, now_ + milliseconds(499)));
  EXPECT_EQ(mux_.active(now_), kPerson);
}

TEST_F(Mux, TheRobotGoesOnWhenThePersonHasFallenSilent) {
  mux_.Offer(kPerson, kStill, now_);
  EXPECT_TRUE(mux_.Offer(kRobot, kAhead, now_ + milliseconds(500)));
}

TEST_F(Mux, WhoFallsSilentWhileDrivingIsStoppedOnce) {
  mux_.Offer(kRobot, kAhead, now_);
  EXPECT_FALSE(mux_.MustStop(now_ + milliseconds(499)));
  EXPECT_TRUE(mux_.MustStop(now_ + milliseconds(500)));
  EXPECT_FALSE(mux_.MustStop(now_ + milliseconds(501)));
}

TEST_F(Mux, WhatStandsStillIsNotStopped) {
  EXPECT_FALSE(mux_.MustStop(now_));
  mux_.Offer(kRobot, kAhead, now_);
  mux_.Offer(kRobot, kStill, now_);
  EXPECT_FALSE(mux_.MustStop(now_ + milliseconds(800)));
  EXPECT_EQ(mux_.active(now_ + milliseconds(800)), std::nullopt);
}

TEST_F(Mux, ThePersonIsStoppedEvenIfTheRobotTalksOn) {
  mux_.Offer(kPerson, kAhead, now_);
  EXPECT_FALSE(mux_.Offer(kRobot, kAhead, now_ + milliseconds(499)));
  EXPECT_TRUE(mux_.MustStop(now_ + milliseconds(500)));
}

}  // namespace
}  // namespace coppice::robot::teleoperation
