#include "bt_core/base/stop_token.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace coppice {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;

TEST(StopToken, WaitsAsLongAsItIsTold) {
  const StopToken token;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_FALSE(token.WaitFor(milliseconds(5)));
  EXPECT_GE(std::chrono::steady_clock::now() - start, milliseconds(5));
}

TEST(StopToken, ARequestEndsTheWaitOfAnotherThread) {
  StopToken token;
  bool stopped = false;
  std::thread waiter([&] { stopped = token.WaitFor(hours(1)); });
  token.RequestStop();
  waiter.join();
  EXPECT_TRUE(stopped);
}

TEST(StopToken, ARequestStaysUntilItIsReset) {
  StopToken token;
  token.RequestStop();
  EXPECT_TRUE(token.stop_requested());
  EXPECT_TRUE(token.WaitFor(hours(1)));
  token.Reset();
  EXPECT_FALSE(token.stop_requested());
}

}  // namespace
}  // namespace coppice
