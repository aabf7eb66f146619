#include "robot_app/perception/clouds/clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "tests/robot_app/perception/clouds/painted_image.h"

namespace coppice::robot::perception {
namespace {

struct Both {
  RangeImage image;
  Clusters by_steps;
  Clusters by_distance;

  explicit Both(const RangeImage& painted) : image(painted) {
    std::vector<Surface> surfaces;
    FindGround(image, {}, surfaces);
    ClusterByDepthSteps(image, surfaces, {}, by_steps);
    ClusterByDistance(image, surfaces, {}, by_distance);
  }
};

TEST(Clusters, APillarIsOneClusterInBothWays) {
  const Both found(PaintedCloud({{4, 1, 0.25, 1.7}}).image());
  EXPECT_EQ(found.by_steps.size(), 1U);
  EXPECT_EQ(found.by_distance.size(), 1U);
}

TEST(Clusters, APillarBehindTheSensorIsNotCutWhereTheTurnBegins) {
  const Both found(PaintedCloud({{-4, 0, 0.25, 1.7}}).image());
  EXPECT_EQ(found.by_steps.size(), 1U);
  EXPECT_EQ(found.by_distance.size(), 1U);
}

TEST(Clusters, TwoPillarsApartAreTwo) {
  const Both found(PaintedCloud({{4, 0, 0.25, 1.7}, {4, 1.2, 0.25, 1.7}}).image());
  EXPECT_EQ(found.by_steps.size(), 2U);
  EXPECT_EQ(found.by_distance.size(), 2U);
}

TEST(Clusters, OnlyStepsInDepthTellAPillarFromOneCloseBehind) {
  // The gap of 0.3 m is less than that between two rings there.
  const Both found(PaintedCloud({{8, 0, 0.3, 1.7}, {8.5, 0.35, 0.3, 1.7}}).image());
  EXPECT_EQ(found.by_steps.size(), 2U);
  EXPECT_EQ(found.by_distance.size(), 1U);
}

TEST(Clusters, OnlyDistanceJoinsWhatAPostBeforeItCutsInTwo) {
  const Both found(PaintedCloud({{4, 0, 0.3, 1.7}, {2, 0, 0.03, 1.7}}).image());
  EXPECT_EQ(found.by_steps.size(), 3U);
  EXPECT_EQ(found.by_distance.size(), 2U);
}

TEST(Clusters, LostReturnsDoNotCutAPillar) {
  RangeImage image = PaintedCloud({{4, 0, 0.3, 1.7}}).image();
  for (int ring = 0; ring < image.geometry.rings; ++ring) {
    image.ranges[image.cell(ring, 450)] = image.ranges[image.cell(ring, 451)] = 0;
  }
  EXPECT_EQ(Both(image).by_steps.size(), 1U);
}

TEST(Clusters, ACellIsInOneClusterAtMostAndEachIsAscending) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-9, 9);
  for (int round = 0; round < 20; ++round) {
    std::vector<PaintedCloud::Pillar> pillars;
    for (int i = 0; i < 12; ++i) pillars.push_back({place(random), place(random), 0.3, 1.7});
    const Both found(PaintedCloud(pillars).image());
    for (const Clusters* clusters : {&found.by_steps, &found.by_distance}) {
      std::set<std::uint32_t> cells(clusters->cells.begin(), clusters->cells.end());
      EXPECT_EQ(cells.size(), clusters->cells.size());
      for (std::size_t i = 0; i < clusters->size(); ++i) {
        EXPECT_TRUE(std::is_sorted((*clusters)[i].begin(), (*clusters)[i].end()));
      }
    }
  }
}

// The slow way: joins all pairs that are near enough, whatever lies where in the picture.
std::size_t CountByPairs(const RangeImage& image, const std::vector<Surface>& surfaces,
                         const DistanceOptions& options) {
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (surfaces[i] == Surface::kStanding) cells.push_back(i);
  }
  std::vector<std::size_t> group(cells.size());
  for (std::size_t i = 0; i < group.size(); ++i) group[i] = i;
  const auto root = [&](std::size_t i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  const float gap = 2 * std::tan(image.geometry.ring_step / 2);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const float range = std::max(image.ranges[cells[i]], image.ranges[cells[j]]);
      if ((image.points[cells[i]] - image.points[cells[j]]).norm() <= options.least + gap * range) {
        group[root(i)] = root(j);
      }
    }
  }
  std::vector<std::size_t> sizes(cells.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i) ++sizes[root(i)];
  return static_cast<std::size_t>(std::count_if(
      sizes.begin(), sizes.end(), [&](std::size_t size) { return size >= options.least_cells; }));
}

TEST(Clusters, NearInSpaceIsFoundAsIfAllPairsWereLookedAt) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-7, 7);
  for (int round = 0; round < 5; ++round) {
    std::vector<PaintedCloud::Pillar> pillars;
    for (int i = 0; i < 8; ++i) pillars.push_back({place(random), place(random), 0.2, 1.7});
    const Both found(PaintedCloud(pillars).image());
    std::vector<Surface> surfaces;
    FindGround(found.image, {}, surfaces);
    EXPECT_EQ(found.by_distance.size(), CountByPairs(found.image, surfaces, {}));
  }
}

}  // namespace
}  // namespace coppice::robot::perception
