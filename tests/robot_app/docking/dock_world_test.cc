// Docking and undocking of the simulated robot, without ROS.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "robot_app/docking/dock_controller.h"
#include "tests/robot_app/navigation/world_robot.h"

namespace coppice::robot::docking {
namespace {

using simulation::Pose2;
using Phase = DockController::Phase;

class DockingInWorld : public testing::Test {
 protected:
  void Place(const std::optional<Pose2>& start, double charge = 0.5) {
    simulation::WorldOptions options;
    options.start = start;
    options.state_of_charge = charge;
    world_.emplace(floor_, options);
    world_->Step(0.02);
  }
  DockInput Input() const {
    return {world_->time(),
            navigation::PoseOf(*world_),
            world_->battery().current(),
            true,
            world_->docked(),
            world_->battery().full(),
            PointsInBase(navigation::ScanOf(*world_), 3)};
  }
  void Run() {
    const double stop = world_->time() + 300;
    while (controller_.active() && world_->time() < stop) {
      const Velocity2D velocity = controller_.Update(Input());
      for (int i = 0; i < 5; ++i)
        world_->Step(0.01, simulation::Velocity{velocity.linear, velocity.angular});
    }
  }

  simulation::Floor floor_ = navigation::InstituteFloor();
  std::optional<simulation::World> world_;
  DockController controller_;
};

TEST_F(DockingInWorld, DocksFromPlacesNearTheStagingPose) {
  for (const Pose2& start : {floor_.staging, Pose2{0.3, 0.6, 1}, Pose2{-0.6, -0.5, -2}}) {
    SCOPED_TRACE(testing::Message() << start.x << ' ' << start.y << ' ' << start.yaw);
    Place(start);
    controller_.StartDocking(Input());
    Run();
    EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
    EXPECT_TRUE(world_->docked());
    EXPECT_TRUE(world_->battery().charging());
    EXPECT_LT(std::abs(navigation::PoseOf(*world_).y), 0.02);
  }
}

TEST_F(DockingInWorld, UndocksAndDocksAgain) {
  Place(std::nullopt);
  ASSERT_TRUE(world_->docked());
  controller_.StartUndocking(Input());
  Run();
  ASSERT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
  EXPECT_FALSE(world_->docked());
  controller_.StartDocking(Input());
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kDone) << controller_.message();
  EXPECT_TRUE(world_->docked());
}

TEST_F(DockingInWorld, FindsAStationThatHasMovedByTryingFromAside) {
  for (const double moved : {0.06, -0.06}) {
    Place(floor_.staging);
    ASSERT_TRUE(world_->SetStationOffset(moved));
    bool charging = false;
    for (const double offset : {0.0, 0.04, -0.04, 0.08, -0.08}) {
      if (charging) break;
      controller_.StartDocking(Input(), offset, 1);
      Run();
      charging = controller_.phase() == Phase::kDone;
    }
    EXPECT_TRUE(charging) << moved << ": " << controller_.message();
    EXPECT_TRUE(world_->docked());
  }
}

TEST_F(DockingInWorld, ABoxBeforeTheStationFailsWithoutATouch) {
  Place(floor_.staging);
  ASSERT_TRUE(world_->SetPlaceBlocked("dock_front", true));
  world_->Step(0.2);
  controller_.StartDocking(Input());
  Run();
  EXPECT_EQ(controller_.phase(), Phase::kFailed);
  EXPECT_THAT(controller_.message(), testing::HasSubstr("obstacle"));
  EXPECT_FALSE(world_->touching());
}

}  // namespace
}  // namespace coppice::robot::docking
