#include "robot_app/perception/clouds/candidates.h"

#include <gtest/gtest.h>

#include "tests/robot_app/perception/clouds/painted_image.h"

namespace coppice::robot::perception {
namespace {

// Whether some candidate lies around this place and is no wider than a person.
bool IsCandidateAt(const CandidateFinder& finder, float x, float y) {
  for (std::size_t i = 0; i < finder.candidates().size(); ++i) {
    Eigen::Vector2f low(1e6F, 1e6F), high(-1e6F, -1e6F);
    for (const std::uint32_t cell : finder.candidates()[i]) {
      low = low.cwiseMin(finder.image().points[cell].head<2>());
      high = high.cwiseMax(finder.image().points[cell].head<2>());
    }
    if (((low + high) / 2 - Eigen::Vector2f(x, y)).norm() < 0.3F && (high - low).norm() < 1.2F) {
      return true;
    }
  }
  return false;
}

TEST(CandidateFinder, WhoStandsAloneIsACandidate) {
  CandidateFinder finder({});
  finder.Find(PaintedCloud({{3, 1, 0.25, 1.7}}).points());
  EXPECT_TRUE(IsCandidateAt(finder, 3, 1));
}

TEST(CandidateFinder, ThreeWhoTouchAreACandidateEach) {
  CandidateFinder finder({});
  finder.Find(
      PaintedCloud({{4, -0.5, 0.26, 1.6}, {4, 0, 0.26, 1.8}, {4, 0.5, 0.26, 1.7}}).points());
  for (const float y : {-0.5F, 0.0F, 0.5F}) EXPECT_TRUE(IsCandidateAt(finder, 4, y)) << y;
}

TEST(CandidateFinder, WhatIsLowerThanAChildIsNone) {
  CandidateFinder finder({});
  finder.Find(PaintedCloud({{5, 0, 0.25, 0.4}}).points());
  EXPECT_EQ(finder.candidates().size(), 0U);
}

TEST(CandidateFinder, AnEmptyCloudHasNone) {
  CandidateFinder finder({});
  EXPECT_EQ(finder.Find({}).size(), 0U);
}

}  // namespace
}  // namespace coppice::robot::perception
