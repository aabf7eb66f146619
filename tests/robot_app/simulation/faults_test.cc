#include "robot_app/simulation/faults.h"

#include <gmock/gmock.h>

#include <cmath>
#include <csignal>

#include "tests/robot_app/simulation/test_floor.h"

namespace coppice::robot::simulation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

class FaultsTest : public testing::Test {
 protected:
  FaultsTest() : world_(LoadInstitute()), faults_(world_, {"/scan", "/odom"}, Recorder()) {}

  // Records the signals instead of sending them; "/lost" cannot be signalled.
  SignalNode Recorder() {
    return [this](const std::string& node, int signal) -> Change {
      signals_.emplace_back(node, signal);
      if (node == "/lost") return Problem{"it cannot be signalled"};
      return "signalled";
    };
  }

  void Pass(double seconds) {
    const double end = world_.time() + seconds - 1e-9;
    while (world_.time() < end) {
      world_.Step(0.02);
      faults_.Update();
    }
  }

  bool Blocked(const std::string& place) const {
    for (std::size_t i = 0; i < world_.floor().places.size(); ++i) {
      if (world_.floor().places[i].name == place) return world_.place_blocked()[i];
    }
    ADD_FAILURE() << place;
    return false;
  }

  // How many messages go out when ten are due.
  int CopiesOfTen(const std::string& topic) {
    int copies = 0;
    for (int i = 0; i < 10; ++i) copies += faults_.Copies(topic);
    return copies;
  }

  World world_;
  std::vector<std::pair<std::string, int>> signals_;
  Faults faults_;
};

TEST_F(FaultsTest, ABlockedCorridorHealsAfterItsDuration) {
  EXPECT_TRUE(faults_.Inject({"block_corridor", "corridor_east", 0, 5}));
  Pass(4.9);
  EXPECT_TRUE(Blocked("corridor_east"));
  Pass(0.2);
  EXPECT_FALSE(Blocked("corridor_east"));
}

TEST_F(FaultsTest, ANewRequestReplacesWhatWasToHealTheOldOne) {
  ASSERT_TRUE(faults_.Inject({"block_corridor", "corridor_east", 0, 2}));
  EXPECT_TRUE(faults_.Inject({"block_corridor", "corridor_east", 0, 0}));
  Pass(3);
  EXPECT_TRUE(Blocked("corridor_east"));
  EXPECT_TRUE(faults_.Inject({"clear_corridor", "corridor_east", 0, 0}));
  EXPECT_FALSE(Blocked("corridor_east"));
}

TEST_F(FaultsTest, DoorsCloseForAWhile) {
  EXPECT_TRUE(faults_.Inject({"close_door", "door_101", 0, 1}));
  EXPECT_FALSE(world_.door_open()[0]);
  Pass(1.1);
  EXPECT_TRUE(world_.door_open()[0]);
}

TEST_F(FaultsTest, SetsTheBattery) {
  EXPECT_TRUE(faults_.Inject({"set_battery", "", 0.2, 0}));
  EXPECT_NEAR(world_.battery().state_of_charge(), 0.2, 1e-9);
  EXPECT_FALSE(faults_.Inject({"set_battery", "", 20, 0}));
}

TEST_F(FaultsTest, SilencesATopicForAWhile) {
  EXPECT_TRUE(faults_.Inject({"silence_topic", "/scan", 0, 1}));
  EXPECT_EQ(CopiesOfTen("/scan"), 0);
  EXPECT_EQ(CopiesOfTen("/odom"), 10);
  Pass(1.1);
  EXPECT_EQ(CopiesOfTen("/scan"), 10);
  EXPECT_THAT(faults_.Inject({"silence_topic", "/scam", 0, 0}).problem(),
              HasSubstr("did you mean \"/scan\"?"));
}

TEST_F(FaultsTest, ATopicComesTooSlowlyOrTooFastForAWhile) {
  EXPECT_TRUE(faults_.Inject({"slow_topic", "/scan", 0.3, 1}));
  EXPECT_EQ(CopiesOfTen("/scan"), 3);
  Pass(1.1);
  EXPECT_EQ(CopiesOfTen("/scan"), 10);
  EXPECT_TRUE(faults_.Inject({"fast_topic", "/scan", 2.5, 1}));
  EXPECT_EQ(CopiesOfTen("/scan"), 25);
  EXPECT_EQ(CopiesOfTen("/odom"), 10);
  Pass(1.1);
  EXPECT_EQ(CopiesOfTen("/scan"), 10);
}

TEST_F(FaultsTest, TheNewestWordOnATopicCounts) {
  ASSERT_TRUE(faults_.Inject({"silence_topic", "/scan", 0, 1}));
  ASSERT_TRUE(faults_.Inject({"slow_topic", "/scan", 0.5, 0}));
  Pass(1.1);
  EXPECT_EQ(CopiesOfTen("/scan"), 5);
  EXPECT_TRUE(faults_.Inject({"restore_topic", "/scan", 0, 0}));
  EXPECT_EQ(CopiesOfTen("/scan"), 10);
}

TEST_F(FaultsTest, RefusesFactorsThatMakeNoSense) {
  EXPECT_FALSE(faults_.Inject({"slow_topic", "/scan", 1, 0}));
  EXPECT_FALSE(faults_.Inject({"slow_topic", "/scan", 0, 0}));
  EXPECT_FALSE(faults_.Inject({"fast_topic", "/scan", 0.5, 0}));
  EXPECT_FALSE(faults_.Inject({"fast_topic", "/scan", 1e9, 0}));
  EXPECT_FALSE(faults_.Inject({"fast_topic", "/scan", std::nan(""), 0}));
  EXPECT_EQ(CopiesOfTen("/scan"), 10);
}

TEST_F(FaultsTest, ATopicLagsAndGoesBlindUntilItIsRestored) {
  EXPECT_TRUE(faults_.Inject({"delay_topic", "/scan", 0.5, 0}));
  EXPECT_TRUE(faults_.Inject({"blind_topic", "/scan", 0, 0}));
  EXPECT_EQ(faults_.sensors().Lag("/scan"), 0.5);
  EXPECT_TRUE(faults_.sensors().IsBlind("/scan"));
  EXPECT_TRUE(faults_.Inject({"restore_topic", "/scan", 0, 0}));
  EXPECT_EQ(faults_.sensors().Lag("/scan"), 0);
  EXPECT_FALSE(faults_.sensors().IsBlind("/scan"));
  EXPECT_FALSE(faults_.Inject({"delay_topic", "/scan", 11, 0}));
  EXPECT_FALSE(faults_.Inject({"blind_topic", "/odom", 0, 0}));
}

TEST_F(FaultsTest, ASonarGoesDeaf) {
  for (const char* const topic : {"/sonar/left", "/sonar/front", "/sonar/right"}) {
    EXPECT_TRUE(faults_.Inject({"blind_topic", topic, 0, 0})) << topic;
    EXPECT_TRUE(faults_.sensors().IsBlind(topic));
  }
}

TEST_F(FaultsTest, ARingIsLostForAWhile) {
  EXPECT_TRUE(faults_.Inject({"lose_ring", "", 3, 1}));
  EXPECT_EQ(faults_.sensors().lost_rings(), std::set<int>{3});
  Pass(1.1);
  EXPECT_TRUE(faults_.sensors().lost_rings().empty());
  EXPECT_FALSE(faults_.Inject({"lose_ring", "", 16, 0}));
  EXPECT_FALSE(faults_.Inject({"lose_ring", "", 2.5, 0}));
}

TEST_F(FaultsTest, ACameraIsCoveredAndItsDataIsDamagedMoreAndMore) {
  EXPECT_TRUE(faults_.Inject({"cover_lens", "front", 0, 0}));
  EXPECT_TRUE(faults_.sensors().Of("front", world_.time()).is_covered);
  EXPECT_FALSE(faults_.sensors().Of("rear", world_.time()).is_covered);
  EXPECT_TRUE(faults_.Inject({"uncover_lens", "front", 0, 0}));
  EXPECT_FALSE(faults_.sensors().Of("front", world_.time()).is_covered);
  EXPECT_TRUE(faults_.Inject({"wear_camera", "rear", 0.1, 0}));
  EXPECT_NEAR(faults_.sensors().Of("rear", world_.time() + 1800).broken, 0.05, 1e-9);
  EXPECT_EQ(faults_.sensors().Of("rear", world_.time() + 1e6).broken, 1);
  EXPECT_TRUE(faults_.Inject({"mend_camera", "rear", 0, 0}));
  EXPECT_EQ(faults_.sensors().Of("rear", world_.time() + 1e6).broken, 0);
  EXPECT_FALSE(faults_.Inject({"cover_lens", "top", 0, 0}));
}

TEST_F(FaultsTest, FreezesTheBatteryForAWhile) {
  EXPECT_TRUE(faults_.Inject({"freeze_battery", "", 0, 1}));
  EXPECT_TRUE(faults_.battery_frozen());
  Pass(1.1);
  EXPECT_FALSE(faults_.battery_frozen());
}

TEST_F(FaultsTest, AChargerThatIsOffGivesNoCurrentThoughTheRobotStandsInTheStation) {
  ASSERT_TRUE(faults_.Inject({"set_battery", "", 0.5, 0}));
  Pass(0.1);
  ASSERT_TRUE(world_.battery().charging());
  EXPECT_TRUE(faults_.Inject({"contact_without_current", "", 0, 1}));
  Pass(0.1);
  EXPECT_TRUE(world_.docked());
  EXPECT_FALSE(world_.battery().charging());
  Pass(1.1);
  EXPECT_TRUE(world_.battery().charging());
}

TEST_F(FaultsTest, BentContactsDoNotTouchUntilTheyAreStraight) {
  EXPECT_TRUE(faults_.Inject({"docking_offset", "", 0.05, 1}));
  EXPECT_FALSE(world_.docked());
  Pass(1.1);
  EXPECT_TRUE(world_.docked());
  EXPECT_TRUE(faults_.Inject({"docking_offset", "", -0.05, 0}));
  EXPECT_FALSE(world_.docked());
  EXPECT_TRUE(faults_.Inject({"docking_offset", "", 0, 0}));
  EXPECT_TRUE(world_.docked());
  EXPECT_FALSE(faults_.Inject({"docking_offset", "", 5, 0}));
}

TEST_F(FaultsTest, MovesTheStationAndTakesItsLandmarkAway) {
  EXPECT_TRUE(faults_.Inject({"move_station", "-0.1 0.3 0.1", 0, 0}));
  EXPECT_FALSE(world_.docked());
  EXPECT_NEAR(world_.station_moved().y, 0.3, 1e-12);
  EXPECT_FALSE(faults_.Inject({"move_station", "aside", 0, 0}));
  EXPECT_TRUE(faults_.Inject({"move_station", "0 0 0", 0, 0}));
  EXPECT_TRUE(world_.docked());
  EXPECT_TRUE(faults_.Inject({"take_landmark", "", 0, 1}));
  EXPECT_FALSE(world_.landmark());
  Pass(1.1);
  EXPECT_TRUE(world_.landmark());
}

TEST_F(FaultsTest, OneOfThePeopleFollowsTheRobotForAWhile) {
  const std::string person = world_.floor().people.front().name;
  EXPECT_TRUE(faults_.Inject({"follow_robot", person, 0, 5}));
  const Change nobody = faults_.Inject({"follow_robot", "nobody", 0, 0});
  ASSERT_FALSE(nobody);
  EXPECT_NE(nobody.problem().find("there is no person \"nobody\""), std::string::npos);
  EXPECT_TRUE(faults_.Inject({"leave_robot", person, 0, 0}));
}

TEST_F(FaultsTest, AnEmergencyStopHoldsTheRobotForAWhile) {
  ASSERT_TRUE(faults_.Inject({"kidnap", "10 0 0", 0, 0}));
  EXPECT_TRUE(faults_.Inject({"emergency_stop", "", 0, 1}));
  EXPECT_TRUE(world_.emergency_stop());
  world_.Step(0.02, Velocity{0.5, 0});
  Pass(0.4);
  EXPECT_NEAR(world_.robot().x, 10, 0.01);
  Pass(1);
  EXPECT_FALSE(world_.emergency_stop());
  world_.Step(0.02, Velocity{0.5, 0});
  Pass(0.4);
  EXPECT_GT(world_.robot().x, 10.02);
}

TEST_F(FaultsTest, KidnapsTheRobotToAPoseOrAWaypoint) {
  EXPECT_TRUE(faults_.Inject({"kidnap", "10 0.2 1.5", 0, 0}));
  EXPECT_NEAR(world_.robot().x, 10, 1e-6);
  EXPECT_NEAR(world_.robot().yaw, 1.5, 1e-6);
  const FloorWaypoint& waypoint = world_.floor().waypoints.back();
  EXPECT_TRUE(faults_.Inject({"kidnap", waypoint.name, 0, 0}));
  EXPECT_NEAR(world_.robot().x, waypoint.pose.x, 1e-5);
  EXPECT_FALSE(faults_.Inject({"kidnap", "10 0", 0, 0}));
  EXPECT_FALSE(faults_.Inject({"kidnap", "10 0 0 0", 0, 0}));
  EXPECT_FALSE(faults_.Inject({"kidnap", "10 0 0", 0, 5}));
}

TEST_F(FaultsTest, SignalsNodesAndWakesAHungOneUpAgain) {
  EXPECT_TRUE(faults_.Inject({"kill_node", "/nav", 0, 0}));
  EXPECT_TRUE(faults_.Inject({"hang_node", "/nav", 0, 1}));
  Pass(1.1);
  EXPECT_THAT(signals_,
              ElementsAre(Pair("/nav", SIGKILL), Pair("/nav", SIGSTOP), Pair("/nav", SIGCONT)));
  EXPECT_FALSE(faults_.Inject({"hang_node", "/lost", 0, 1}));
}

TEST_F(FaultsTest, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(faults_.Inject({"block_coridor", "corridor_east", 0, 0}).problem(),
              HasSubstr("did you mean \"block_corridor\"?"));
  EXPECT_THAT(faults_.Inject({"explode", "", 0, 0}).problem(), HasSubstr("known: blind_topic"));
  EXPECT_FALSE(faults_.Inject({"kill_node", "/nav", 0, 5}));
  EXPECT_FALSE(faults_.Inject({"block_corridor", "corridor_east", 0, -1}));
  EXPECT_FALSE(Blocked("corridor_east"));
}

}  // namespace
}  // namespace coppice::robot::simulation
