#include "robot_app/training/labelled_sweep.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot::training {
namespace {

LabelledSweep SweepOf(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return MakeLabelledSweep(MakeRandomHall(random), {{}, 8}, random);
}

TEST(LabelledSweep, TheSameSeedGivesTheSameScan) {
  EXPECT_EQ(SweepOf(3).scan.ranges, SweepOf(3).scan.ranges);
  EXPECT_NE(SweepOf(3).scan.ranges, SweepOf(4).scan.ranges);
}

TEST(LabelledSweep, WhomABeamMeetsStandsWhereItEnds) {
  int met = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const LabelledSweep sweep = SweepOf(seed);
    ASSERT_EQ(sweep.owner.size(), sweep.scan.ranges.size());
    for (std::size_t i = 0; i < sweep.owner.size(); ++i) {
      if (sweep.owner[i] == LabelledSweep::kNobody) continue;
      ++met;
      const double angle = sweep.scan.angle_min + double(i) * sweep.scan.angle_increment;
      const simulation::Vec2 end = simulation::Direction(angle) * sweep.scan.ranges[i];
      EXPECT_LT(simulation::Length(end - sweep.people[sweep.owner[i]].position), 0.37);
    }
  }
  EXPECT_GT(met, 500);
}

TEST(LabelledSweep, WhoIsBehindTheRobotIsNotSeen) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const PersonTruth& person : SweepOf(seed).people) {
      const double angle = std::atan2(person.position.y, person.position.x);
      if (std::abs(angle) > 2.7 && simulation::Length(person.position) > 1.5) {
        EXPECT_EQ(person.visible, 0);
      }
      EXPECT_LE(person.visible, 1);
    }
  }
}

}  // namespace
}  // namespace coppice::robot::training
