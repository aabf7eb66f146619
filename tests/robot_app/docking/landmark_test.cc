#include "robot_app/docking/landmark.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "robot_app/docking/line_segments.h"
#include "tests/robot_app/docking/station_scans.h"
#include "tests/robot_app/localization/localized_robot.h"

namespace coppice::robot::docking {
namespace {

constexpr double kDegree = M_PI / 180;

// How the landmark is seen from one distance and angle.
struct Seen {
  int found = 0;        // of a hundred scans
  double place = 0;     // error, root of the mean square [m]
  double heading = 0;   // rad
  double surprise = 0;  // squared error in terms of the covariance, on average; 3 is right
};

Seen Look(double distance, double angle) {
  const simulation::Floor floor = navigation::InstituteFloor();
  const Pose2D landmark = LandmarkIn(floor);
  StationScans scans(Hall());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> turn(-0.8, 0.8);
  Seen seen;
  for (int i = 0; i < 100; ++i) {
    const Pose2D base = SeenFrom(landmark, distance, (i % 2 == 0 ? 1 : -1) * angle, turn(random));
    const auto sightings = FindLandmarks(scans.From(base), {});
    if (sightings.size() != 1) continue;
    const Pose2D truth = RelativeTo(base, landmark);
    const Pose2D at = sightings[0].pose;
    const Eigen::Vector3d off(at.x - truth.x, at.y - truth.y, NormalizeAngle(at.yaw - truth.yaw));
    ++seen.found;
    seen.place += off.head<2>().squaredNorm();
    seen.heading += off.z() * off.z();
    seen.surprise += off.dot(sightings[0].covariance.inverse() * off);
  }
  seen.place = std::sqrt(seen.place / seen.found);
  seen.heading = std::sqrt(seen.heading / seen.found);
  seen.surprise /= seen.found;
  return seen;
}

TEST(Landmark, IsFoundFromHalfAMetreToFourUpToSixtyDegreesAside) {
  for (const double distance : {0.5, 1.0, 2.0, 3.0, 4.0}) {
    for (const double angle : {0.0, 30.0, 60.0}) {
      const Seen seen = Look(distance, angle * kDegree);
      // From far aside and away hardly a beam tells where a leg ends.
      const int least = angle > 45 && distance > 2.5 ? 4 : 50;
      EXPECT_GE(seen.found, least) << distance << " m, " << angle << " degrees";
    }
  }
}

TEST(Landmark, IsMeasuredToMillimetresNearbyAndToAFewCentimetresFromAfar) {
  EXPECT_LT(Look(0.5, 0).place, 0.005);
  EXPECT_LT(Look(0.5, 0).heading, 0.6 * kDegree);
  EXPECT_LT(Look(1.5, 30 * kDegree).place, 0.01);
  EXPECT_LT(Look(3, 30 * kDegree).place, 0.02);
  EXPECT_LT(Look(4, 0).place, 0.02);
}

TEST(Landmark, KnowsHowWellItMeasures) {
  for (const double distance : {0.5, 1.5, 3.0}) {
    const double surprise = Look(distance, 20 * kDegree).surprise;
    EXPECT_GT(surprise, 0.5) << distance;
    EXPECT_LT(surprise, 6) << distance;
  }
}

TEST(Landmark, IsFoundAlthoughSomebodyStandsBesideIt) {
  const simulation::Floor floor = navigation::InstituteFloor();
  StationScans scans(floor);
  const Pose2D base{-0.8, 0, M_PI};
  int found = 0;
  for (int i = 0; i < 50; ++i) {
    const auto seen =
        FindLandmarks(scans.From(base, {{{-1.9, 0.55}, 0.25}, {{-2.2, -0.7}, 0.1}}), {});
    found += seen.size() == 1 && Distance(Compose(base, seen[0].pose), LandmarkIn(floor)) < 0.03;
  }
  EXPECT_GE(found, 45);
}

TEST(Landmark, NothingElseOnTheFloorIsTakenForIt) {
  simulation::Floor floor = navigation::InstituteFloor();
  floor.landmark.reset();
  const auto poses = localization::RandomPoses(navigation::MapOf(floor), 1000, 3);
  StationScans scans(floor);
  for (const Pose2D& pose : poses) {
    EXPECT_TRUE(FindLandmarks(scans.From(pose), {}).empty()) << pose.x << ' ' << pose.y;
  }
}

TEST(Landmark, NeitherPeopleNorTheirLegsNorFurnitureAreTakenForIt) {
  simulation::Floor floor = navigation::InstituteFloor();
  floor.landmark.reset();
  const auto poses = localization::RandomPoses(navigation::MapOf(floor), 1000, 4);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> away(0.6, 4), angle(-M_PI, M_PI), radius(0.05, 0.35),
      size(0.1, 1);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    std::vector<simulation::Disc> discs;
    std::vector<simulation::Segment> boxes;
    const auto near = [&] {
      const double direction = angle(random);
      const double distance = away(random);
      return simulation::Vec2{poses[i].x + distance * std::cos(direction),
                              poses[i].y + distance * std::sin(direction)};
    };
    for (int k = 0; k < 6; ++k) discs.push_back({near(), radius(random)});
    for (int k = 0; k < 3; ++k) {
      const auto corners =
          simulation::Corners({near(), {size(random), size(random)}, angle(random)});
      for (std::size_t c = 0; c < 4; ++c) boxes.push_back({corners[c], corners[(c + 1) % 4]});
    }
    StationScans scans(floor, i, boxes);
    EXPECT_TRUE(FindLandmarks(scans.From(poses[i], discs), {}).empty()) << i;
  }
}

TEST(Landmark, AScanWithoutEchoesShowsNothing) {
  LaserScan scan;
  EXPECT_TRUE(FindLandmarks(scan, {}).empty());
  scan.ranges.assign(541, std::numeric_limits<float>::infinity());
  EXPECT_TRUE(FindLandmarks(scan, {}).empty());
  scan.ranges.assign(541, std::nanf(""));
  EXPECT_TRUE(FindLandmarks(scan, {}).empty());
  EXPECT_FALSE(FitLandmark(scan, {}, {1, 0, 0}));
}

TEST(LineSegments, ACornerIsCutAtItsBeam) {
  LaserScan scan;
  scan.ranges.assign(541, std::numeric_limits<float>::infinity());
  // Two walls at a right angle: x = 2 up to its corner at 45 degrees, then y = 2.
  for (int i = 180; i <= 450; ++i) {
    const double a = scan.angle_min + i * scan.angle_increment;
    scan.ranges[static_cast<std::size_t>(i)] =
        static_cast<float>(std::min(2 / std::cos(a), std::sin(a) > 0 ? 2 / std::sin(a) : 1e9));
  }
  const auto segments = FindSegments(scan, 0.01, 5);
  ASSERT_EQ(segments.size(), 2U);
  EXPECT_NEAR(segments[0].to.x, 2, 0.02);
  EXPECT_NEAR(segments[0].to.y, 2, 0.04);
  EXPECT_NEAR(segments[1].from.y, 2, 0.02);
}

}  // namespace
}  // namespace coppice::robot::docking
