#include "robot_app/localization/scan_matcher.h"

#include <gtest/gtest.h>

#include "tests/robot_app/localization/localized_robot.h"

namespace coppice::robot::localization {
namespace {

using navigation::InstituteFloor;
using navigation::MapOf;
using simulation::Floor;

std::vector<Beam> SeenFrom(const Floor& floor, const Pose2D& pose) {
  simulation::WorldOptions options;
  options.start = simulation::Pose2{pose.x, pose.y, pose.yaw};
  return BeamsOf(navigation::ScanOf(simulation::World(floor, options)), 0.12, 180);
}

TEST(MatchScan, FindsThePoseToACentimetre) {
  Floor floor = InstituteFloor();
  floor.people.clear();
  const LikelihoodField field(MapOf(floor));
  int coarse = 0;
  for (const Pose2D& pose : RandomPoses(MapOf(floor), 30, 3)) {
    const std::vector<Beam> beams = SeenFrom(floor, pose);
    const Pose2D start = Compose(pose, {0.1, -0.08, 0.05});
    const Pose2D matched = MatchScan(field, beams, start);
    // The furniture's edges are drawn on the map to half a cell.
    EXPECT_LT(Distance(matched, pose), 0.06) << pose.x << " " << pose.y << " " << pose.yaw;
    if (Distance(matched, pose) > 0.02 || std::abs(NormalizeAngle(matched.yaw - pose.yaw)) > 0.01) {
      ++coarse;
    }
  }
  EXPECT_LE(coarse, 1);
}

TEST(MatchScan, StaysWhereItIsAlongABareCorridor) {
  Floor floor = InstituteFloor();
  floor.walls = {{{-60, 1}, {60, 1}}, {{60, -1}, {-60, -1}}};
  floor.doors.clear();
  floor.furniture.clear();
  floor.people.clear();
  const LikelihoodField field(MapOf(floor));
  const Pose2D matched = MatchScan(field, SeenFrom(floor, {0, 0.2, 0}), {1, 0.3, 0.05});
  EXPECT_NEAR(matched.x, 1, 0.02);
  EXPECT_NEAR(matched.y, 0.2, 0.02);
  EXPECT_NEAR(matched.yaw, 0, 0.005);
}

TEST(MatchScan, WithoutBeamsIsWhereItWas) {
  const LikelihoodField field(MapOf(InstituteFloor()));
  EXPECT_EQ(MatchScan(field, {}, {3, 0, 1}).x, 3);
}

}  // namespace
}  // namespace coppice::robot::localization
