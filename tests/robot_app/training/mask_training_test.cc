#include "robot_app/training/mask_training.h"

#include <gtest/gtest.h>

#include <utility>

#include "robot_app/perception/detection/mask_detector.h"
#include "tests/support/folders.h"

namespace coppice::robot::training {
namespace {

TEST(MaskTraining, TheSameOptionsLearnTheSameToTheLastBit) {
  MaskTrainingOptions options;
  options.pictures = 6;
  options.rounds = 2;
  const auto first = TrainMasks(options, [](double) {});
  const auto second = TrainMasks(options, [](double) {});
  ASSERT_TRUE(first) << first.problem();
  EXPECT_EQ(first->face, second->face);
  EXPECT_EQ(first->mask, second->mask);
}

// The robot of the paper: 92.9 % with mask, 82.34 % without.
TEST(MaskTraining, WhatIsShippedIsNoWorseThanThePaperOnPicturesNeverSeen) {
  auto classifier = perception::LoadMaskClassifier(
      SourceFolder() + "/robot_app/perception/data/faces_and_masks.yaml");
  ASSERT_TRUE(classifier) << classifier.problem();
  const auto detector = perception::MakeMaskDetector(std::move(*classifier));
  const MaskFigures figures = MeasureMasks(*detector, 60, 77, true);
  EXPECT_GT(figures.with_mask.there() + figures.without_mask.there(), 60);
  EXPECT_GE(figures.with_mask.average_precision(), 0.929);
  EXPECT_GE(figures.without_mask.average_precision(), 0.8234);
}

TEST(MaskTraining, TheTableHasTheFiguresOfThePaperBeside) {
  const std::string table = Table(MaskFigures{});
  EXPECT_NE(table.find("| with mask | 0.0 % | 92.90 % |"), std::string::npos) << table;
  EXPECT_NE(table.find("| without mask | 0.0 % | 82.34 % |"), std::string::npos) << table;
}

}  // namespace
}  // namespace coppice::robot::training
