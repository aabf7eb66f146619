#include "robot_app/perception/clouds/people_finder.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/robot_app/perception/clouds/painted_image.h"
#include "tests/support/folders.h"

namespace coppice::robot::perception {
namespace {

constexpr double kNoise = 0.03;  // of a Velodyne Puck [m]

PeopleFinder Shipped() {
  auto classifier =
      PersonClassifier::Load(SourceFolder() + "/robot_app/perception/data/people_in_clouds.yaml");
  EXPECT_TRUE(classifier) << classifier.problem();
  return {{}, std::move(*classifier)};
}

// A body of legs, torso with arms, and head.
std::vector<PaintedCloud::Pillar> Body(double x, double y) {
  return {{x, y - 0.1, 0.075, 0.85},       {x, y + 0.1, 0.075, 0.85},
          {x, y - 0.22, 0.05, 1.43, 0.75}, {x, y + 0.22, 0.05, 1.43, 0.75},
          {x, y, 0.17, 1.43, 0.85},        {x, y, 0.1, 1.75, 1.43}};
}

TEST(PeopleFinder, FindsSomebodyWhereHeStands) {
  PeopleFinder finder = Shipped();
  const auto& people = finder.Find(PaintedCloud(Body(3, 1), kNoise).points());
  ASSERT_EQ(people.size(), 1U);
  EXPECT_NEAR(people[0].position.x(), 3, 0.12);
  EXPECT_NEAR(people[0].position.y(), 1, 0.12);
  EXPECT_GT(people[0].probability, 0.9F);
}

TEST(PeopleFinder, FindsNobodyOnAnEmptyFloorOrInAWall) {
  PeopleFinder finder = Shipped();
  EXPECT_TRUE(finder.Find(PaintedCloud({}, kNoise).points()).empty());
  EXPECT_TRUE(finder.Find(PaintedCloud({{20, 0, 15, 3}}, kNoise).points()).empty());
}

TEST(PeopleFinder, FindsNobodyTwice) {
  PeopleFinder finder = Shipped();
  auto bodies = Body(3, 0.6);
  for (const auto& pillar : Body(4, -0.7)) bodies.push_back(pillar);
  EXPECT_EQ(finder.Find(PaintedCloud(bodies, kNoise).points()).size(), 2U);
}

TEST(PeopleFinder, CloudsOfNothingAndOfAnythingAreNoHarm) {
  PeopleFinder finder = Shipped();
  EXPECT_TRUE(finder.Find({}).empty());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(finder.Find(std::vector<LidarPoint>(14400, {nan, nan, nan, nan, 3})).empty());
  std::mt19937 random(6);
  for (int round = 0; round < 20; ++round) {
    std::vector<LidarPoint> points(14400);
    std::uniform_real_distribution<float> place(-10, 10);
    for (auto& point : points) {
      point = {place(random), place(random), place(random), place(random),
               static_cast<std::uint16_t>(random() % 20)};
    }
    for (const SeenPerson& person : finder.Find(points)) {
      EXPECT_TRUE(person.position.allFinite());
    }
  }
}

}  // namespace
}  // namespace coppice::robot::perception
