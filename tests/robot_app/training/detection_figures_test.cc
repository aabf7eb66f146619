#include "robot_app/training/detection_figures.h"

#include <gtest/gtest.h>

namespace coppice::robot::training {
namespace {

using perception::Box;
using perception::Sighting;
using perception::SightingKind;

Sighting At(double x, double confidence) {
  return {SightingKind::kPerson, Box{x, 0, 10, 20}, confidence};
}

TEST(DetectionFigures, ABoxIsRightIfHalfOfBothIsCommon) {
  DetectionFigures figures;
  figures.Add({At(0, 1), At(100, 1)}, {At(2, 0.9), At(106, 0.8)});
  EXPECT_EQ(figures.found(0.5), 1);
  EXPECT_EQ(figures.invented(0.5), 1);
  EXPECT_DOUBLE_EQ(figures.precision(0.5), 0.5);
  EXPECT_DOUBLE_EQ(figures.recall(0.5), 0.5);
}

TEST(DetectionFigures, TheSecondBoxForOnePersonIsWrong) {
  DetectionFigures figures;
  figures.Add({At(0, 1)}, {At(1, 0.7), At(0, 0.9)});
  EXPECT_EQ(figures.found(0), 1);
  EXPECT_EQ(figures.invented(0), 1);
}

TEST(DetectionFigures, WhoIsHiddenCountsNeitherWay) {
  DetectionFigures figures;
  figures.Add({At(0, 0), At(50, 0)}, {At(0, 0.9)});
  EXPECT_EQ(figures.there(), 0);
  EXPECT_EQ(figures.found(0) + figures.invented(0), 0);
}

TEST(DetectionFigures, WhatIsLessSureThanAskedForDoesNotCount) {
  DetectionFigures figures;
  figures.Add({At(0, 1)}, {At(0, 0.4)});
  EXPECT_EQ(figures.found(0.5), 0);
  EXPECT_EQ(figures.found(0.4), 1);
}

// Right, wrong, right, of three: precision 1 up to a third, 2/3 up to two thirds, then nothing.
TEST(DetectionFigures, AveragePrecisionIsTheAreaUnderTheCurve) {
  DetectionFigures figures;
  figures.Add({At(0, 1), At(100, 1), At(200, 1)}, {At(0, 0.9), At(50, 0.8), At(100, 0.7)});
  EXPECT_NEAR(figures.average_precision(), (1 + 2 / 3.0) / 3, 1e-12);
}

TEST(DetectionFigures, OfNothingAreZero) {
  const DetectionFigures figures;
  EXPECT_EQ(figures.average_precision(), 0);
  EXPECT_EQ(figures.precision(0), 0);
  EXPECT_EQ(figures.recall(0), 0);
}

}  // namespace
}  // namespace coppice::robot::training
