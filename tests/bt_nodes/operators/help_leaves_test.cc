#include "bt_nodes/operators/help_leaves.h"

#include <gtest/gtest.h>

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

class RequestHelpTest : public testing::Test {
 protected:
  RequestHelpTest() {
    help_.Set("subject", std::string("navigation"));
    help_.Set("question", std::string("stuck"));
  }
  FakeRobot robot_;
  std::shared_ptr<OpenRequests> requests_ = std::make_shared<OpenRequests>(robot_);
  LeafHarness help_ = LeafHarness::For<RequestHelp>(requests_);
};

TEST_F(RequestHelpTest, FailsWhileNobodyHasFixedIt) {
  for (int i = 0; i < 10; ++i) EXPECT_EQ(help_.Tick(), Status::kFailure);
  EXPECT_EQ(robot_.calls, std::vector<std::string>{"Ask navigation: stuck"});
}

TEST_F(RequestHelpTest, SucceedsOnceWhenAPersonConfirms) {
  help_.Tick();
  robot_.AnswerRequest("navigation", true);
  EXPECT_EQ(help_.Tick(), Status::kSuccess);
  EXPECT_FALSE(requests_->IsOpen("navigation"));
  help_.Advance(std::chrono::seconds(9));
  EXPECT_EQ(help_.Tick(), Status::kFailure) << "the monitors may not have seen it yet";
  EXPECT_EQ(robot_.calls.size(), 1u);
  help_.Advance(std::chrono::seconds(1));
  EXPECT_EQ(help_.Tick(), Status::kFailure) << "the fault is still there: asks again";
  EXPECT_EQ(robot_.calls.size(), 2u);
}

TEST_F(RequestHelpTest, RestsWhenNobodyCouldHelp) {
  help_.Tick();
  robot_.AnswerRequest("navigation", false);
  EXPECT_EQ(help_.Tick(), Status::kFailure);
  EXPECT_EQ(help_.message(), "nobody could help: nobody could");
  for (int i = 1; i < 600; ++i) {
    help_.Advance(std::chrono::seconds(1));
    help_.Tick();
  }
  EXPECT_EQ(robot_.calls.size(), 1u);
  help_.Advance(std::chrono::seconds(1));
  help_.Tick();
  EXPECT_EQ(robot_.calls.size(), 2u);
}

TEST_F(RequestHelpTest, DoesNotRestWhenTheFaultIsAnotherOne) {
  help_.Tick();
  robot_.AnswerRequest("navigation", false);
  help_.Tick();
  help_.Advance(std::chrono::seconds(61));
  help_.Tick();
  EXPECT_EQ(robot_.calls.size(), 2u);
}

TEST_F(RequestHelpTest, DoesNotTakeAnOldAnswerForANewOne) {
  help_.Tick();
  robot_.AnswerRequest("navigation", true);
  requests_->Settle(Time(std::chrono::hours(1)), Duration(0),
                    nullptr);  // withdrawn before it was seen
  EXPECT_EQ(help_.Tick(), Status::kFailure);
  EXPECT_TRUE(requests_->IsOpen("navigation"));
}

TEST_F(RequestHelpTest, PutsTheDetailBehindTheQuestion) {
  help_.Set("detail", std::string("here"));
  help_.Tick();
  EXPECT_EQ(robot_.calls.back(), "Ask navigation: stuck here");
}

TEST_F(RequestHelpTest, IsWithdrawnBySettleRequestsWhenItIsNotTicked) {
  LeafHarness settle = LeafHarness::For<SettleRequests>(requests_);
  help_.Tick();
  EXPECT_EQ(settle.Tick(), Status::kSuccess);
  settle.Advance(std::chrono::seconds(2));
  EXPECT_EQ(settle.Tick(), Status::kSuccess);
  EXPECT_EQ(robot_.calls.back(), "Withdraw navigation");
}

}  // namespace
}  // namespace coppice::leaves
