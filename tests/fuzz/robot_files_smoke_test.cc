// The harnesses of the robot's files, as smoke_test.cc does it for the others.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/mutator.h"
#include "tests/fuzz/regressions.h"
#include "tests/fuzz/robot_file_seeds.h"

namespace coppice::fuzz {
namespace {

std::array<int, 3> Mutated(int (*fuzz)(std::string_view bytes), const std::string& seed) {
  std::array<int, 3> reached{};
  for (unsigned number = 0; number < 4000; ++number) {
    ++reached[fuzz(Mutator(number).Mutate(seed))];
  }
  return reached;
}

TEST(FuzzMap, MutatedMapsNeverCrash) {
  EXPECT_EQ(FuzzMap(SomeMap()), 1);
  const auto reached = Mutated(FuzzMap, SomeMap());
  EXPECT_GT(reached[0], 50) << "some are refused";
  EXPECT_GT(reached[1], 50) << "some are read";
}

TEST(FuzzMessage, MutatedMessagesNeverCrash) {
  EXPECT_EQ(FuzzMessage(SomeMessage()), 2);
  const auto reached = Mutated(FuzzMessage, SomeMessage());
  for (const int count : reached) EXPECT_GT(count, 20);
}

class FuzzWavTest : public testing::TestWithParam<std::string> {};

TEST_P(FuzzWavTest, MutatedSoundsNeverCrash) {
  EXPECT_EQ(FuzzWav(GetParam()), 2);
  const auto reached = Mutated(FuzzWav, GetParam());
  EXPECT_GT(reached[0], 50) << "some are refused";
  EXPECT_GT(reached[2], 50) << "some are read";
}

INSTANTIATE_TEST_SUITE_P(Kinds, FuzzWavTest, testing::Values(SomeWav(), SomePackedWav()));

TEST(FuzzRobotFiles, EmptyInputIsFine) {
  EXPECT_EQ(FuzzMap(""), 0);
  EXPECT_EQ(FuzzMessage(""), 2) << "a message of nothing";
  EXPECT_EQ(FuzzWav(""), 0);
}

// What once crashed must not do so again.
TEST(FuzzRobotFiles, WhatOnceCrashedDoesNotAnyMore) {
  RunRegressions("map", FuzzMap);
  RunRegressions("message", FuzzMessage);
  RunRegressions("wav", FuzzWav);
}

}  // namespace
}  // namespace coppice::fuzz
