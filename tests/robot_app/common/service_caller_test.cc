#include "robot_app/common/service_caller.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>

namespace coppice::robot {
namespace {

TEST(ServiceCaller, CallsOnItsThreadAndFinishesOnTheCallers) {
  ServiceCaller caller;
  std::thread::id called;
  std::thread::id finished;
  ASSERT_TRUE(caller.Add([&]() -> ServiceCaller::Finish {
    called = std::this_thread::get_id();
    return [&] { finished = std::this_thread::get_id(); };
  }));
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (finished == std::thread::id() && std::chrono::steady_clock::now() < deadline) {
    caller.RunFinished();
  }
  EXPECT_EQ(finished, std::this_thread::get_id());
  EXPECT_NE(called, finished);
}

TEST(ServiceCaller, TakesOnlySoManyWhileOneHangs) {
  std::atomic<bool> go_on{false};
  ServiceCaller caller;
  const auto hang = [&]() -> ServiceCaller::Finish {
    while (!go_on) std::this_thread::yield();
    return [] {};
  };
  std::size_t taken = 0;
  while (taken < 100 && caller.Add(hang)) ++taken;
  EXPECT_GE(taken, ServiceCaller::kMostWaiting);
  EXPECT_LE(taken, ServiceCaller::kMostWaiting + 1);
  go_on = true;
}

}  // namespace
}  // namespace coppice::robot
