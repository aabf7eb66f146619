#include "bt_core/live/board_copier.h"

#include <gtest/gtest.h>

#include <future>

#include "tests/bt_core/live/watched_tree.h"

namespace coppice {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

class BoardCopierTest : public ::testing::Test {
 protected:
  int NumberIn(const std::vector<Value>& values) const {
    const Value& value = values[program_->layout.Find(0, "number")];
    return value.has_value() ? value.Get<int>() : 0;
  }

  std::shared_ptr<const Program> program_ = WatchedProgram();
  SimulatedClock clock_;
  Executor executor_{program_, clock_};
};

TEST_F(BoardCopierTest, BringsTheValuesOfTheTickingTree) {
  BoardCopier copier(executor_);
  executor_.Tick();
  auto number = std::async(std::launch::async, [&] { return NumberIn(copier.Copy({0}, 30s)); });
  while (number.wait_for(0s) != std::future_status::ready) executor_.Tick();
  EXPECT_GT(number.get(), 0);
}

TEST_F(BoardCopierTest, GivesTheLastValuesOfATreeThatNobodyTicks) {
  executor_.Tick();
  BoardCopier copier(executor_);
  EXPECT_EQ(NumberIn(copier.Copy({0}, 1ms)), 1);
}

TEST_F(BoardCopierTest, DoesNotWaitTwiceForATreeThatNobodyTicks) {
  BoardCopier copier(executor_);
  copier.Copy({0}, 1ms);
  EXPECT_EQ(NumberIn(copier.Copy({0}, 1h)), 0);  // would not come back
}

TEST_F(BoardCopierTest, TakesAnAnswerThatCameLate) {
  BoardCopier copier(executor_);
  copier.Copy({0}, 1ms);
  executor_.Tick();  // copies before it ticks
  executor_.Tick();
  EXPECT_EQ(NumberIn(copier.Copy({0}, 1ms)), 0);
  executor_.RunCalls();
  EXPECT_EQ(NumberIn(copier.Copy({0}, 1ms)), 2);
}

TEST_F(BoardCopierTest, CopiesOnlyTheScopesThatAreAskedFor) {
  BoardCopier copier(executor_);
  executor_.Tick();
  copier.Copy({1}, 1ms);
  executor_.RunCalls();
  EXPECT_EQ(NumberIn(copier.Copy({1}, 1ms)), 0);
}

TEST_F(BoardCopierTest, CancelEndsTheWaiting) {
  BoardCopier copier(executor_);
  auto copy = std::async(std::launch::async, [&] { copier.Copy({0}, 1h); });
  copier.Cancel();
  EXPECT_EQ(copy.wait_for(30s), std::future_status::ready);
}

TEST_F(BoardCopierTest, MayDieBeforeItsAnswerComes) {
  {
    BoardCopier copier(executor_);
    copier.Copy({0}, 1ms);
  }
  executor_.Tick();
}

}  // namespace
}  // namespace coppice
