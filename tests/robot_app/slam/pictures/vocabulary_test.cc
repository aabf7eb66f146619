#include "robot_app/slam/pictures/vocabulary.h"

#include <gtest/gtest.h>

#include <random>

#include "robot_app/slam/pictures/place_index.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::slam {
namespace {

// 30 pictures of 40 corners, out of 60 kinds of corners of which each seen one differs a little.
std::vector<std::vector<Descriptor>> Pictures(std::uint64_t seed) {
  std::mt19937_64 kinds(3);
  std::vector<Descriptor> corners(60);
  for (Descriptor& corner : corners) {
    for (std::uint64_t& part : corner) part = kinds();
  }
  std::mt19937_64 random(seed);
  std::vector<std::vector<Descriptor>> pictures(30);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    for (std::size_t k = 0; k < 40; ++k) {
      Descriptor corner = corners[(7 * i + k * k) % corners.size()];
      for (int flip = 0; flip < 10; ++flip)
        corner[random() % 4] ^= std::uint64_t{1} << random() % 64;
      pictures[i].push_back(corner);
    }
  }
  return pictures;
}

Vocabulary Learnt() { return *Vocabulary::Train(Pictures(1), {6, 2, 1}); }

TEST(Vocabulary, ADescriptionThatDiffersALittleIsTheSameWord) {
  const Vocabulary vocabulary = Learnt();
  const auto first = Pictures(1), again = Pictures(2);
  int same = 0;
  for (std::size_t k = 0; k < 40; ++k) {
    same += vocabulary.WordOf(first[4][k]) == vocabulary.WordOf(again[4][k]) ? 1 : 0;
  }
  EXPECT_GE(same, 36);
  EXPECT_GE(vocabulary.size(), 20U);
}

TEST(Vocabulary, ThePictureOfTheSamePlaceHasTheMostWordsInCommon) {
  const Vocabulary vocabulary = Learnt();
  PlaceIndex index(vocabulary.size());
  const auto known = Pictures(1), again = Pictures(2);
  for (std::uint32_t i = 0; i < known.size(); ++i) index.Add(i, vocabulary.BagOf(known[i]));
  const auto found = index.Find(vocabulary.BagOf(again[11]), 3, [](std::uint32_t) { return true; });
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].picture, 11U);
  EXPECT_GT(found[0].score, 0.8F);
  const auto others =
      index.Find(vocabulary.BagOf(again[11]), 3, [](std::uint32_t i) { return i != 11; });
  EXPECT_LT(others[0].score, found[0].score);
}

TEST(Vocabulary, TheWeightsOfAPictureSumUpToOne) {
  float sum = 0;
  for (const WeighedWord& word : Learnt().BagOf(Pictures(1)[0])) sum += word.weight;
  EXPECT_NEAR(sum, 1, 1e-5);
}

TEST(Vocabulary, TheSamePicturesGiveTheSameFile) {
  const TemporaryFolder folder;
  ASSERT_TRUE(Learnt().Save(folder.Path("a")));
  ASSERT_TRUE(Learnt().Save(folder.Path("b")));
  EXPECT_EQ(ReadFile(folder.Path("a")), ReadFile(folder.Path("b")));
}

TEST(Vocabulary, WhatWasSavedFindsTheSameWords) {
  const TemporaryFolder folder;
  const Vocabulary learnt = Learnt();
  ASSERT_TRUE(learnt.Save(folder.Path("words")));
  const auto read = Vocabulary::Load(folder.Path("words"));
  ASSERT_TRUE(read) << read.problem();
  const auto pictures = Pictures(5);
  for (const Descriptor& corner : pictures[3]) {
    EXPECT_EQ(read->WordOf(corner), learnt.WordOf(corner));
  }
}

TEST(Vocabulary, ADamagedFileIsAProblemWithItsLine) {
  const TemporaryFolder folder;
  WriteFile(folder.Path("words"), "coppice vocabulary 1\n3\n2 0 0\n");
  const auto read = Vocabulary::Load(folder.Path("words"));
  ASSERT_FALSE(read);
  EXPECT_NE(read.problem().find("words:3: expected children"), std::string::npos) << read.problem();
  EXPECT_FALSE(Vocabulary::Load(folder.Path("none")));
}

TEST(Vocabulary, OfTooFewCornersNothingIsLearnt) {
  EXPECT_FALSE(Vocabulary::Train({{Descriptor{}}}, {6, 2, 1}));
}

}  // namespace
}  // namespace coppice::robot::slam
