#include "robot_app/localization/place_search.h"

#include <gtest/gtest.h>

#include "tests/robot_app/localization/localized_robot.h"

namespace coppice::robot::localization {
namespace {

class PlaceSearchTest : public testing::Test {
 protected:
  // What a robot that stands there sees at once.
  std::vector<Beam> SeenFrom(const Pose2D& pose) const {
    simulation::WorldOptions options;
    options.start = simulation::Pose2{pose.x, pose.y, pose.yaw};
    return BeamsOf(navigation::ScanOf(simulation::World(floor_, options)), 0.12, 180);
  }

  const simulation::Floor floor_ = navigation::InstituteFloor();
  const LikelihoodField field_{navigation::MapOf(floor_)};
  const PlaceSearch search_{field_};
};

TEST_F(PlaceSearchTest, TheTruePlaceIsAlwaysAmongThoseThatFitBest) {
  for (const Pose2D& pose : RandomPoses(navigation::MapOf(floor_), 60, 5)) {
    const std::vector<FittingPlace> places = search_.Find(SeenFrom(pose), 8);
    ASSERT_FALSE(places.empty()) << pose.x << " " << pose.y << " " << pose.yaw;
    bool found = false;
    for (const FittingPlace& place : places) {
      found = found || (Distance(place.pose, pose) < 0.05 &&
                        place.agreement.share() > places.front().agreement.share() - 0.05);
    }
    EXPECT_TRUE(found) << pose.x << " " << pose.y << " " << pose.yaw;
  }
}

TEST_F(PlaceSearchTest, NothingElseLooksLikeTheHall) {
  const std::vector<FittingPlace> places = search_.Find(SeenFrom({46.5, -0.5, 1}), 8);
  ASSERT_FALSE(places.empty());
  EXPECT_GT(places[0].agreement.share(), 0.9);
  for (std::size_t i = 1; i < places.size(); ++i) {
    EXPECT_LT(places[i].agreement.share(), places[0].agreement.share() - 0.2);
    EXPECT_FALSE(IsSamePlace(places[i].pose, places[0].pose));
  }
}

TEST_F(PlaceSearchTest, OfficesThatLookAlikeFitEquallyWell) {
  // 101 and 104 are the same, 24 m apart.
  const std::vector<FittingPlace> places = search_.Find(SeenFrom({8, 5, -2}), 8);
  ASSERT_GE(places.size(), 2u);
  EXPECT_NEAR(places[0].agreement.share(), places[1].agreement.share(), 0.02);
  EXPECT_NEAR(Distance(places[0].pose, places[1].pose), 24, 0.1);
}

TEST_F(PlaceSearchTest, FindsNothingWithoutBeams) {
  EXPECT_TRUE(search_.Find({}, 8).empty());
  EXPECT_TRUE(search_.Find({{{0, 0}, {1, 0}, true}, {{0, 0}, {0, 20}, false}}, 8).empty());
}

}  // namespace
}  // namespace coppice::robot::localization
