#include "robot_app/common/limits/run_apart.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <vector>

namespace coppice::robot {
namespace {

TEST(RunApart, ReturnsWhatWasReturned) {
  const auto result = RunApart([] { return 7; }, {});
  ASSERT_TRUE(result) << result.problem();
  EXPECT_EQ(*result, 7);
}

TEST(RunApart, ChangesNothingHere) {
  int value = 1;
  ASSERT_TRUE(RunApart([&] { return value = 2; }, {}));
  EXPECT_EQ(value, 1);
}

TEST(RunApart, SurvivesWhatCrashes) {
  EXPECT_EQ(RunApart([] { return std::raise(SIGSEGV); }, {}).problem(), "crashed (signal 11)");
  EXPECT_EQ(RunApart([]() -> int { throw std::runtime_error("no"); }, {}).problem(),
            "crashed (signal 6)");
}

TEST(RunApart, WhatThisProgramDoesWhenItCrashesTheCopyDoesNot) {
  const auto before = std::signal(SIGFPE, [](int) { _exit(0); });
  EXPECT_EQ(RunApart([] { return std::raise(SIGFPE); }, {}).problem(), "crashed (signal 8)");
  std::signal(SIGFPE, before);
}

TEST(RunApart, EndsWhatTakesTooLong) {
  EXPECT_EQ(RunApart([] { return pause(); }, {0, std::chrono::seconds(1)}).problem(),
            "took longer than 1 s");
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(RunApart, HasNoMoreMemoryThanItIsGiven) {
  const auto grow = [] {
    try {
      std::vector<char> bytes(std::size_t{100} << 20, 'x');
      return bytes[1000] == 'x' ? 1 : 2;
    } catch (const std::bad_alloc&) {
      return 3;
    }
  };
  const auto result = RunApart(grow, {std::size_t{64} << 20, {}});
  ASSERT_TRUE(result) << result.problem();
  EXPECT_EQ(*result, 3);
}
#endif

}  // namespace
}  // namespace coppice::robot
