#include "robot_app/slam/pictures/corner_pairs.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace coppice::robot::slam {
namespace {

PictureFeatures Draw(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  PictureFeatures features;
  for (std::size_t i = 0; i < count; ++i) {
    features.pixels.emplace_back(0, 0);
    features.descriptors.push_back({random(), random(), random(), random()});
    features.points.emplace_back(1, 0, 1);
  }
  return features;
}

// As seen again: some bits are others.
Descriptor Flipped(Descriptor descriptor, int bits) {
  for (int bit = 0; bit < bits; ++bit) descriptor[0] ^= std::uint64_t{1} << bit;
  return descriptor;
}

TEST(PairsOf, FindsEachCornerAgainInWhateverOrder) {
  const PictureFeatures before = Draw(50, 1);
  PictureFeatures after = Draw(10, 2);
  for (std::size_t i = 50; i-- > 0;) {
    after.pixels.emplace_back(0, 0);
    after.descriptors.push_back(Flipped(before.descriptors[i], 20));
    after.points.emplace_back(1, 0, 1);
  }
  const auto pairs = PairsOf(before, after);
  ASSERT_EQ(pairs.size(), 50U);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(pairs[i].old_corner, i);
    EXPECT_EQ(pairs[i].new_corner, 59 - i);
  }
}

TEST(PairsOf, WhatLooksAlikeTwiceOrTooUnlikeIsNoPair) {
  const PictureFeatures before = Draw(4, 1);
  PictureFeatures after = Draw(5, 2);
  after.descriptors[0] = Flipped(before.descriptors[0], 10);
  after.descriptors[1] = Flipped(before.descriptors[0], 11);  // nearly as well
  after.descriptors[2] = Flipped(before.descriptors[1], 64);
  after.descriptors[3] = before.descriptors[2];
  after.descriptors[3][3] ^= 0xFFFFFFFFFFFFFFFF;
  after.descriptors[3][2] ^= 1;  // 65 bits
  const auto pairs = PairsOf(before, after);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].old_corner, 1U);
  EXPECT_EQ(pairs[0].new_corner, 2U);
}

TEST(PairsOf, BothMustBeBestForEachOther) {
  PictureFeatures before = Draw(3, 1);
  before.descriptors[1] = Flipped(before.descriptors[0], 30);
  PictureFeatures after = Draw(3, 2);
  after.descriptors[2] = Flipped(before.descriptors[0], 2);
  const auto pairs = PairsOf(before, after);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].old_corner, 0U);
}

TEST(PairsOf, AnOldCornerWithoutDepthIsOfNoUse) {
  PictureFeatures before = Draw(3, 1);
  const PictureFeatures after = before;
  before.points[1].setConstant(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(PairsOf(before, after).size(), 2U);
  EXPECT_TRUE(PairsOf(Draw(1, 1), after).empty());
}

}  // namespace
}  // namespace coppice::robot::slam
