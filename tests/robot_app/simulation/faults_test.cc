#include "robot_app/simulation/faults.h"

#include <gmock/gmock.h>

#include <csignal>

#include "tests/robot_app/simulation/test_floor.h"

namespace coppice::robot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

class FaultsTest : public testing::Test {
 protected:
  FaultsTest() : world_(LoadInstitute()), faults_(world_, {"/scan", "/odom"}, Recorder()) {}

  // Records the signals instead of sending them; "/lost" cannot be signalled.
  SignalNode Recorder() {
    return [this](const std::string& node, int signal) {
      signals_.emplace_back(node, signal);
      return Outcome{node != "/lost", "signalled"};
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
      if (world_.floor().places[i].name == place) return world_.place_blocked(i);
    }
    ADD_FAILURE() << place;
    return false;
  }

  World world_;
  std::vector<std::pair<std::string, int>> signals_;
  Faults faults_;
};

TEST_F(FaultsTest, ABlockedCorridorHealsAfterItsDuration) {
  EXPECT_TRUE(faults_.Inject({"block_corridor", "corridor_east", 0, 5}).ok);
  Pass(4.9);
  EXPECT_TRUE(Blocked("corridor_east"));
  Pass(0.2);
  EXPECT_FALSE(Blocked("corridor_east"));
}

TEST_F(FaultsTest, ANewRequestReplacesWhatWasToHealTheOldOne) {
  faults_.Inject({"block_corridor", "corridor_east", 0, 2});
  EXPECT_TRUE(faults_.Inject({"block_corridor", "corridor_east", 0, 0}).ok);
  Pass(3);
  EXPECT_TRUE(Blocked("corridor_east"));
  EXPECT_TRUE(faults_.Inject({"clear_corridor", "corridor_east", 0, 0}).ok);
  EXPECT_FALSE(Blocked("corridor_east"));
}

TEST_F(FaultsTest, DoorsCloseForAWhile) {
  EXPECT_TRUE(faults_.Inject({"close_door", "door_101", 0, 1}).ok);
  EXPECT_FALSE(world_.door_open(0));
  Pass(1.1);
  EXPECT_TRUE(world_.door_open(0));
}

TEST_F(FaultsTest, SetsTheBattery) {
  EXPECT_TRUE(faults_.Inject({"set_battery", "", 0.2, 0}).ok);
  EXPECT_NEAR(world_.battery().state_of_charge(), 0.2, 1e-9);
  EXPECT_FALSE(faults_.Inject({"set_battery", "", 20, 0}).ok);
}

TEST_F(FaultsTest, SilencesATopicForAWhile) {
  EXPECT_TRUE(faults_.Inject({"silence_topic", "/scan", 0, 1}).ok);
  EXPECT_TRUE(faults_.silenced("/scan"));
  EXPECT_FALSE(faults_.silenced("/odom"));
  Pass(1.1);
  EXPECT_FALSE(faults_.silenced("/scan"));
  EXPECT_THAT(faults_.Inject({"silence_topic", "/scam", 0, 0}).message,
              HasSubstr("did you mean \"/scan\"?"));
}

TEST_F(FaultsTest, SignalsNodesAndWakesAHungOneUpAgain) {
  EXPECT_TRUE(faults_.Inject({"kill_node", "/nav", 0, 0}).ok);
  EXPECT_TRUE(faults_.Inject({"hang_node", "/nav", 0, 1}).ok);
  Pass(1.1);
  EXPECT_THAT(signals_,
              ElementsAre(Pair("/nav", SIGKILL), Pair("/nav", SIGSTOP), Pair("/nav", SIGCONT)));
  EXPECT_FALSE(faults_.Inject({"hang_node", "/lost", 0, 1}).ok);
}

TEST_F(FaultsTest, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(faults_.Inject({"block_coridor", "corridor_east", 0, 0}).message,
              HasSubstr("did you mean \"block_corridor\"?"));
  EXPECT_THAT(faults_.Inject({"explode", "", 0, 0}).message, HasSubstr("known: block_corridor"));
  EXPECT_FALSE(faults_.Inject({"kill_node", "/nav", 0, 5}).ok);
  EXPECT_FALSE(faults_.Inject({"block_corridor", "corridor_east", 0, -1}).ok);
  EXPECT_FALSE(Blocked("corridor_east"));
}

}  // namespace
}  // namespace coppice::robot
