#include "bt_nodes/operators/open_requests.h"

#include <gtest/gtest.h>

#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

class OpenRequestsTest : public testing::Test {
 protected:
  void Assert(const std::string& question, double at, const std::string& faults = {}) {
    requests_.Assert({"navigation", question, faults}, Time(Seconds(at)), [this] {
      ++senders_;
      return Sender<ActionResult>();
    });
  }
  void Settle(double at, const Health* health = nullptr) {
    requests_.Settle(Time(Seconds(at)), Seconds(1), health);
  }
  static Duration Seconds(double seconds) {
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
  }

  FakeRobot robot_;
  OpenRequests requests_{robot_};
  int senders_ = 0;
};

TEST_F(OpenRequestsTest, AskOnceHoweverOftenTheRequestIsAsserted) {
  for (double t = 0; t < 100; t += 0.5) {
    Assert("stuck", t);
    Settle(t);
  }
  EXPECT_EQ(robot_.calls, std::vector<std::string>{"Ask navigation: stuck"});
  EXPECT_EQ(senders_, 1);
}

TEST_F(OpenRequestsTest, AskAgainWhenTheQuestionIsAnother) {
  Assert("stuck", 0);
  Assert("very stuck", 0);
  EXPECT_EQ(robot_.calls.back(), "Ask navigation: very stuck");
  EXPECT_EQ(senders_, 2);
}

TEST_F(OpenRequestsTest, AreWithdrawnWhenNobodyAssertsThemAnyMore) {
  Assert("stuck", 0);
  Settle(1);
  EXPECT_TRUE(requests_.IsOpen("navigation"));
  Settle(1.1);
  EXPECT_FALSE(requests_.IsOpen("navigation"));
  EXPECT_EQ(robot_.calls.back(), "Withdraw navigation");
}

TEST_F(OpenRequestsTest, StayWhileTheirFaultIsThere) {
  Health health;
  health.entries = {{"navigation", "path", "", HealthLevel::kError, ""}};
  Assert("stuck", 0, "docking;navigation");
  Settle(100, &health);
  EXPECT_TRUE(requests_.IsOpen("navigation"));
  health.entries[0].level = HealthLevel::kWarn;
  Settle(101, &health);
  EXPECT_FALSE(requests_.IsOpen("navigation"));
}

TEST_F(OpenRequestsTest, AreForgottenWithoutAWordWhenTheyWereAnswered) {
  Assert("stuck", 0);
  requests_.Forget("navigation");
  Settle(10);
  EXPECT_EQ(robot_.calls.size(), 1u);
  requests_.Forget("navigation");
}

}  // namespace
}  // namespace coppice::leaves
