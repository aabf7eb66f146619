#include "bt_nodes/operators/tell_faults.h"

#include <gtest/gtest.h>

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

class TellFaultsTest : public testing::Test {
 protected:
  TellFaultsTest() { leaf_.Set("except", std::string("node;topic")); }
  // One tick a second with these kinds of monitors in error.
  void Live(int seconds, const std::vector<std::string>& monitors) {
    Health health;
    for (const std::string& monitor : monitors) {
      health.entries.push_back({monitor, "host", "", HealthLevel::kError, "busy"});
    }
    for (; seconds > 0; --seconds) {
      leaf_.Advance(std::chrono::seconds(1));
      leaf_.Set("health", health);
      EXPECT_EQ(leaf_.Tick(), Status::kSuccess);
    }
  }
  FakeRobot robot_;
  LeafHarness leaf_ = LeafHarness::For<TellFaults>(std::ref<SupervisorChannel>(robot_));
};

TEST_F(TellFaultsTest, TellsOnceOfAFaultThatLasts) {
  Live(4, {"cpu"});
  EXPECT_TRUE(robot_.calls.empty());
  Live(100, {"cpu"});
  EXPECT_EQ(robot_.calls, std::vector<std::string>{"Tell cpu host: busy"});
}

TEST_F(TellFaultsTest, TellsWhenTheFaultHasGone) {
  Live(10, {"cpu"});
  Live(29, {});
  EXPECT_EQ(robot_.calls.size(), 1u);
  Live(3, {});
  EXPECT_EQ(robot_.calls.back(), "Tell cpu host: has gone");
}

TEST_F(TellFaultsTest, DoesNotRepeatItselfWithinTheCooldown) {
  Live(10, {"cpu"});
  Live(40, {});
  Live(100, {"cpu"});
  EXPECT_EQ(robot_.calls.size(), 2u);
  Live(600, {"cpu"});
  EXPECT_EQ(robot_.calls.size(), 3u);
}

TEST_F(TellFaultsTest, LeavesOutWhatOthersHandle) {
  Live(100, {"node", "disk"});
  EXPECT_EQ(robot_.calls, std::vector<std::string>{"Tell disk host: busy"});
}

TEST_F(TellFaultsTest, TellsOnlyOfTheKindsThatItIsFor) {
  leaf_.Set("only", std::string("network;clock"));
  Live(100, {"network", "disk"});
  EXPECT_EQ(robot_.calls, std::vector<std::string>{"Tell network host: busy"});
}

TEST_F(TellFaultsTest, LeavesOutWhatNobodyKnowsIfToldSo) {
  leaf_.Set("stale", false);
  Health health;
  health.entries = {{"cpu", "a", "", HealthLevel::kError, "x"},
                    {"cpu", "b", "", HealthLevel::kStale, "y"}};
  leaf_.Set("health", health);
  for (int i = 0; i < 10; ++i) {
    leaf_.Advance(std::chrono::seconds(1));
    leaf_.Tick();
  }
  EXPECT_EQ(robot_.calls, std::vector<std::string>{"Tell cpu a: x"});
}

TEST_F(TellFaultsTest, KeepsSubjectsApart) {
  Health health;
  health.entries = {{"cpu", "a", "", HealthLevel::kError, "x"},
                    {"cpu", "b", "", HealthLevel::kStale, "y"},
                    {"cpu", "c", "", HealthLevel::kWarn, "z"}};
  for (int i = 0; i < 10; ++i) {
    leaf_.Advance(std::chrono::seconds(1));
    leaf_.Set("health", health);
    leaf_.Tick();
  }
  EXPECT_EQ(robot_.calls, (std::vector<std::string>{"Tell cpu a: x", "Tell cpu b: y"}));
}

}  // namespace
}  // namespace coppice::leaves
