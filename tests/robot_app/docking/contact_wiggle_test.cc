#include "robot_app/docking/contact_wiggle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coppice::robot::docking {
namespace {

constexpr Pose2D kDocked{-2.4, 0, M_PI};

// An ideal robot on a station whose contacts touch only in a part of the way.
class ContactWiggleTest : public testing::Test {
 protected:
  void Run(double from, double to) {
    wiggle_.Start(input_);
    for (const double stop = input_.now + 120; wiggle_.active() && input_.now < stop;) {
      input_.now += 0.05;
      const double along = RelativeTo(kDocked, input_.pose).x;
      farthest_ = std::max(farthest_, std::abs(along));
      const bool contact = along >= from && along <= to;
      input_.current = contact && input_.now > dead_until_ ? 12 : -6;
      const Velocity2D velocity = wiggle_.Update(input_);
      const Pose2D next = Advance(input_.pose, velocity, 0.05);
      if (RelativeTo(kDocked, next).x < wall_) input_.pose = next;
    }
    EXPECT_FALSE(wiggle_.active());
  }

  ContactWiggle wiggle_;
  DockInput input_{
      0, kDocked, -6, true, false, false, {}, StationSighting{kDocked, 0, 10, 0.001, 0.001}, {}};
  double wall_ = 1;         // the station ends so far behind the docked pose [m]
  double dead_until_ = -1;  // no current before that time
  double farthest_ = 0;
};

TEST_F(ContactWiggleTest, PressesOnUntilCurrentFlows) {
  Run(0.02, 0.06);
  EXPECT_TRUE(wiggle_.succeeded()) << wiggle_.message();
}

TEST_F(ContactWiggleTest, DrawsBackWhenPressingOnDoesNotHelp) {
  wall_ = 0.001;
  Run(-0.06, -0.02);
  EXPECT_TRUE(wiggle_.succeeded()) << wiggle_.message();
}

TEST_F(ContactWiggleTest, StandsStillWhileCurrentFlows) {
  Run(-1, 1);
  EXPECT_TRUE(wiggle_.succeeded());
  EXPECT_LT(farthest_, 0.005);
}

TEST_F(ContactWiggleTest, FailsWithoutCurrentAndStaysNearTheStation) {
  Run(1, 2);
  EXPECT_FALSE(wiggle_.succeeded());
  EXPECT_NE(wiggle_.message().find("no charging current"), std::string::npos);
  EXPECT_LT(farthest_, 0.06);
}

TEST_F(ContactWiggleTest, FailsWhenTheBatteryIsSilent) {
  input_.battery_known = false;
  Run(-1, 1);
  EXPECT_FALSE(wiggle_.succeeded());
  EXPECT_NE(wiggle_.message().find("does not report"), std::string::npos);
}

TEST_F(ContactWiggleTest, RefusesAwayFromTheStation) {
  input_.pose = Pose2D{};
  Run(-1, 1);
  EXPECT_FALSE(wiggle_.succeeded());
  EXPECT_NE(wiggle_.message().find("does not stand"), std::string::npos);
}

}  // namespace
}  // namespace coppice::robot::docking
