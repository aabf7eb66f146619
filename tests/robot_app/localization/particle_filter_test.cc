#include "robot_app/localization/particle_filter.h"

#include <gtest/gtest.h>

#include "tests/robot_app/navigation/test_floor.h"

namespace coppice::robot::localization {
namespace {

class ParticleFilterTest : public testing::Test {
 protected:
  ParticleFilterTest() : room_(navigation::EmptyRoom(12, 6)) {
    navigation::Fill(room_, {3, 0}, {4, 2});  // so that the room looks like itself only once
    field_.emplace(room_);
  }
  std::vector<Beam> SeenFrom(const Pose2D& pose) const {
    return BeamsOf(navigation::ScanOf(room_, pose, 0), 0.12, 180);
  }
  // Drives an arc and weighs on the way; returns the true end.
  Pose2D DriveFrom(Pose2D pose, ParticleFilter& filter) const {
    const Pose2D step{0.1, 0, 0.05};
    for (int i = 0; i < 20; ++i) {
      pose = Compose(pose, step);
      filter.Move(step);
      filter.Weigh(*field_, SeenFrom(pose));
    }
    return pose;
  }

  OccupancyGrid room_;
  std::optional<LikelihoodField> field_;
};

TEST_F(ParticleFilterTest, ConvergesFromAVagueIdea) {
  ParticleFilter filter;
  filter.Set({6.3, 2.6, 0.2}, 0.4, 0.2);
  const Pose2D truth = DriveFrom({6, 3, 0}, filter);
  const Belief belief = filter.belief();
  EXPECT_LT(Distance(belief.pose, truth), 0.1);
  EXPECT_LT(std::abs(NormalizeAngle(belief.pose.yaw - truth.yaw)), 0.05);
  EXPECT_GT(belief.share, 0.95);
  EXPECT_LT(belief.deviation(), 0.15);
  EXPECT_GT(belief.deviation(), 0.005);
}

TEST_F(ParticleFilterTest, NeedsFewParticlesOnceItIsSure) {
  ParticleFilter filter;
  filter.Set({6, 3, 0}, 1, 0.5);
  EXPECT_EQ(filter.size(), 3000u);
  DriveFrom({6, 3, 0}, filter);
  EXPECT_LE(filter.size(), 600u);
  EXPECT_GE(filter.size(), 300u);
}

TEST_F(ParticleFilterTest, ItsUncertaintyGrowsWithTheMotion) {
  ParticleFilter filter;
  filter.Set({6, 3, 0}, 0.01, 0.01);
  double before = filter.belief().deviation();
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 10; ++j) filter.Move({0.1, 0, 0});
    EXPECT_GT(filter.belief().deviation(), before);
    before = filter.belief().deviation();
  }
}

TEST_F(ParticleFilterTest, NoticesThatScansFitWorseAndFindsBackByFreshParticles) {
  ParticleFilter filter;
  filter.Set({6, 3, 0}, 0.1, 0.05);
  DriveFrom({6, 3, 0}, filter);
  EXPECT_LT(filter.FreshShare(), 0.1);
  const Pose2D carried{10, 1.5, 2};
  DriveFrom(carried, filter);
  EXPECT_GT(filter.FreshShare(), 0.1);
  filter.Inject({{carried, {90, 10, 0}}, {{2, 4, 0}, {50, 30, 20}}}, 0.3);
  const Pose2D truth = DriveFrom(carried, filter);
  EXPECT_LT(Distance(filter.belief().pose, truth), 0.2);
  EXPECT_GT(filter.belief().share, 0.9);
}

TEST_F(ParticleFilterTest, TheSameSeedGivesTheSameBelief) {
  ParticleFilter a({}, 7), b({}, 7), c({}, 8);
  for (ParticleFilter* filter : {&a, &b, &c}) {
    filter->Set({6, 3, 0}, 0.3, 0.1);
    DriveFrom({6, 3, 0}, *filter);
  }
  EXPECT_EQ(a.belief().pose.x, b.belief().pose.x);
  EXPECT_NE(a.belief().pose.x, c.belief().pose.x);
}

TEST_F(ParticleFilterTest, IsEmptyAtFirst) {
  ParticleFilter filter;
  EXPECT_TRUE(filter.empty());
  filter.Move({1, 0, 0});
  filter.Weigh(*field_, {});
  filter.Inject({}, 0.5);
  EXPECT_TRUE(filter.empty());
  EXPECT_EQ(filter.belief().share, 0);
  filter.Inject({{{2, 4, 0}, {50, 0, 50}}}, 0.1);
  EXPECT_NEAR(filter.belief().pose.x, 2, 0.1);
}

}  // namespace
}  // namespace coppice::robot::localization
