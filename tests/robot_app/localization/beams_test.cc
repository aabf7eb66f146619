#include "robot_app/localization/beams.h"

#include <gtest/gtest.h>

#include "tests/robot_app/navigation/test_floor.h"

namespace coppice::robot::localization {
namespace {

using navigation::EmptyRoom;
using navigation::ScanOf;

TEST(Beams, AreSpreadOverTheWallsNotOverTheAngles) {
  const OccupancyGrid room = EmptyRoom(10, 4);
  const Pose2D pose{1, 2, 0};
  const std::vector<Beam> beams = BeamsOf(ScanOf(room, pose, 0), 0.2, 1000);
  ASSERT_GT(beams.size(), 40u);
  for (std::size_t i = 1; i < beams.size(); ++i) {
    EXPECT_GE(Distance(beams[i - 1].to, beams[i].to), 0.2);
  }
  EXPECT_LE(BeamsOf(ScanOf(room, pose, 0), 0.2, 20).size(), 20u);
}

TEST(Beams, ThatAreNoNumbersOrTooNearAreLeftOut) {
  LaserScan scan;
  scan.ranges = {NAN, -1, 0.01F, 2, 1, -INFINITY};
  EXPECT_EQ(BeamsOf(scan, 0.1, 100).size(), 2u);
  scan.ranges.assign(541, INFINITY);
  const std::vector<Beam> nothing = BeamsOf(scan, 0.1, 1000);
  EXPECT_FALSE(nothing.empty());
  for (const Beam& beam : nothing) EXPECT_FALSE(beam.hit);
}

TEST(Beams, AgreeWithTheMapWhereTheyWereTaken) {
  const OccupancyGrid room = EmptyRoom(10, 4);
  const LikelihoodField field(room);
  const Pose2D pose{3, 2, 0.3};
  const std::vector<Beam> beams = BeamsOf(ScanOf(room, pose, 0), 0.1, 200);
  const Agreement here = Agree(field, beams, pose);
  EXPECT_EQ(here.agree, static_cast<int>(beams.size()));
  EXPECT_DOUBLE_EQ(here.score(), 1);
  EXPECT_LT(Agree(field, beams, {3, 2, 1.3}).score(), 0.6);
  EXPECT_GT(Agree(field, beams, {5, 2, 0.3}).through, 5);  // the far wall would be nearer
}

TEST(Beams, WhoStandsInTheWayCountsLittleAndASeenThroughWallMuch) {
  OccupancyGrid room = EmptyRoom(10, 4);
  const LikelihoodField without(room);
  navigation::Fill(room, {4, 1}, {4.5, 3});
  const LikelihoodField with(room);
  const Pose2D pose{2, 2, 0};
  LaserScan scan = ScanOf(room, pose, 0);
  const Agreement hidden = Agree(without, BeamsOf(scan, 0.1, 200), pose);
  EXPECT_GT(hidden.hidden, 10);
  EXPECT_EQ(hidden.through, 0);
  EXPECT_GT(hidden.score(), 0.85);
  navigation::Fill(room, {4, 1}, {4.5, 3}, 0);
  const Agreement through = Agree(with, BeamsOf(ScanOf(room, pose, 0), 0.1, 200), pose);
  EXPECT_GT(through.through, 10);
  EXPECT_LT(through.score(), hidden.score());
}

TEST(Beams, MoveWithTheRobot) {
  const std::vector<Beam> beams = {{{0.2, 0}, {2, 0}, true}};
  const std::vector<Beam> moved = Moved(beams, RelativeTo({1, 0, M_PI / 2}, {0, 0, 0}));
  EXPECT_NEAR(moved[0].to.x, 0, 1e-9);
  EXPECT_NEAR(moved[0].to.y, -1, 1e-9);
}

}  // namespace
}  // namespace coppice::robot::localization
