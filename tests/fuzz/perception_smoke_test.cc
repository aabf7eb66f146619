// The harnesses of what the robot's sensors send, as smoke_test.cc does it for the others.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/mutator.h"
#include "tests/fuzz/perception_seeds.h"
#include "tests/fuzz/regressions.h"

namespace coppice::fuzz {
namespace {

TEST(FuzzCloud, MutatedCloudsNeverCrash) {
  EXPECT_EQ(FuzzCloud(SomeCloud()), 2);
  std::array<int, 3> reached{};
  for (unsigned seed = 0; seed < 20000; ++seed) {
    ++reached[FuzzCloud(Mutator(seed).Mutate(SomeCloud()))];
  }
  EXPECT_GT(reached[0], 100) << "many are refused";
  EXPECT_GT(reached[2], 100) << "many are read";
}

class FuzzPictureTest : public testing::TestWithParam<std::string> {};

TEST_P(FuzzPictureTest, MutatedPicturesNeverCrash) {
  EXPECT_EQ(FuzzPicture(GetParam()), 1);
  std::array<int, 2> reached{};
  for (unsigned seed = 0; seed < 3000; ++seed) {
    ++reached[FuzzPicture(Mutator(seed).Mutate(GetParam()))];
  }
  EXPECT_GT(reached[0], 100) << "some are refused";
  EXPECT_GT(reached[1], 5) << "some are read";
}

INSTANTIATE_TEST_SUITE_P(Kinds, FuzzPictureTest,
                         testing::Values(SomeColourPicture(), SomeDepthPicture()));

TEST(FuzzPerception, EmptyInputIsFine) {
  EXPECT_EQ(FuzzCloud(""), 1) << "a cloud without points";
  EXPECT_EQ(FuzzPicture(""), 0);
}

// What once crashed must not do so again.
TEST(FuzzPerception, WhatOnceCrashedDoesNotAnyMore) {
  RunRegressions("cloud", FuzzCloud);
  RunRegressions("picture", FuzzPicture);
}

}  // namespace
}  // namespace coppice::fuzz
