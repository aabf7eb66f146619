#include "robot_app/slam/clouds/cloud_places.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot_app/slam/graph/floor_pose.h"
#include "tests/robot_app/slam/clouds/room.h"
#include "tests/support/folders.h"

namespace coppice::robot::slam {
namespace {

std::optional<TurnGuess> All(std::uint32_t) { return TurnGuess{}; }

CloudPoints Hall(double x, double yaw, std::uint64_t seed) {
  simulation::StillScene still = Walls({{-6, -5}, {6, -5}, {6, 5}, {-6, 5}, {-6, -5}});
  still.AddBox({{2, 2}, {0.4, 0.4}, 0}, 2.5, simulation::Material::kWall);
  still.AddBox({{-3, -1}, {1, 3}, 0.4}, 1.6, simulation::Material::kFurniture);
  return TurnIn(still, {x, 0, yaw}, seed);
}

class CloudPlacesTest : public testing::Test {
 protected:
  CloudPlacesTest() {
    places_.Add(4, Keep(RoomFrom(0, 0, 0)));
    places_.Add(5, Keep(Hall(0, 0, 1)));
  }

  const PlaceClassifier classifier_ =
      *PlaceClassifier::Load(SourceFolder() + "/robot_app/slam/data/places_in_clouds.yaml");
  CloudPlaces places_{classifier_};
};

TEST_F(CloudPlacesTest, APlaceIsRecognizedHoweverTheRobotIsTurned) {
  const auto room = places_.Find(Keep(RoomFrom(0.3, 0.2, 2.2, 7)), All);
  ASSERT_TRUE(room);
  EXPECT_EQ(room->key_frame, 4U);
  EXPECT_TRUE(IsSure(room->registration)) << room->registration.overlap;
  EXPECT_NEAR(room->registration.relative.translation().x(), 0.3, 0.06);
  EXPECT_NEAR(room->registration.relative.translation().y(), 0.2, 0.06);
  const auto hall = places_.Find(Keep(Hall(0.4, -1, 8)), All);
  ASSERT_TRUE(hall);
  EXPECT_EQ(hall->key_frame, 5U);
}

TEST_F(CloudPlacesTest, ACorridorIsNoneOfThem) {
  const auto found = places_.Find(Keep(CorridorFrom(0, 0, 0, 3)), All);
  EXPECT_FALSE(found && IsSure(found->registration));
}

TEST_F(CloudPlacesTest, OnlyWhatIsAskedForIsFound) {
  const auto found = places_.Find(Keep(RoomFrom(0, 0, 1, 7)), [](std::uint32_t place) {
    return place == 5 ? std::optional(TurnGuess{}) : std::nullopt;
  });
  EXPECT_FALSE(found && IsSure(found->registration));
}

// It looks the same from all four sides.
CloudPoints SquareFrom(double x, double yaw, std::uint64_t seed) {
  return TurnIn(Walls({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}, {-3, -3}}), {x, 0.1, yaw}, seed);
}

TEST_F(CloudPlacesTest, OfSeveralTurnsThatFitItIsTheOneThatTheRobotCanHaveMade) {
  CloudPlaces places(classifier_);
  places.Add(0, Keep(SquareFrom(0, 0, 1)));
  for (const double turn : {0.0, M_PI_2, M_PI, -M_PI_2}) {
    const KnownCloud cloud = Keep(SquareFrom(0.3, turn + 0.1, 7));
    const auto found = places.Find(cloud, [turn](std::uint32_t) {
      return std::optional(TurnGuess{turn, 0.3});
    });
    ASSERT_TRUE(found) << turn;
    EXPECT_TRUE(IsSure(found->registration)) << turn;
    const Pose2D relative = ToPose2D(found->registration.relative);
    EXPECT_NEAR(std::remainder(relative.yaw - turn, 2 * M_PI), 0.1, 0.02) << turn;
    EXPECT_NEAR(relative.x, 0.3, 0.06) << turn;
  }
}

TEST_F(CloudPlacesTest, WhatFitsBestIsNotTheOneIfTheRobotCannotBeTurnedSo) {
  CloudPlaces places(classifier_);
  places.Add(0, Keep(SquareFrom(0, 0, 1)));
  const KnownCloud cloud = Keep(SquareFrom(0.3, 0.1, 7));
  ASSERT_TRUE(places.Find(cloud, All));
  // 45 degrees beside each of the turns that fit.
  const auto between = [](std::uint32_t) { return std::optional(TurnGuess{0.1 + M_PI_4, 0.6}); };
  EXPECT_FALSE(places.Find(cloud, between));
}

TEST_F(CloudPlacesTest, APlaceThatIsTurnedAsTheRobotCannotBeIsNotBelieved) {
  const auto found = places_.Find(Keep(RoomFrom(0.3, 0.2, 2.2, 7)), [](std::uint32_t) {
    return std::optional(TurnGuess{2.2 - M_PI, 0.3});
  });
  EXPECT_FALSE(found && IsSure(found->registration));
}

TEST_F(CloudPlacesTest, WhatWasTakenOutIsNotFound) {
  places_.Remove(4);
  const auto found = places_.Find(Keep(RoomFrom(0, 0, 1, 7)), All);
  EXPECT_FALSE(found && IsSure(found->registration));
}

TEST(PlaceClassifier, ToLearnExamplesOfBothKindsAreNeeded) {
  EXPECT_FALSE(PlaceClassifier::Train({{PairFeatures{}, true}}));
  EXPECT_FALSE(PlaceClassifier::Load("/nowhere"));
}

}  // namespace
}  // namespace coppice::robot::slam
