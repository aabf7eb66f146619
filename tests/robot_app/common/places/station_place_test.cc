#include "robot_app/common/places/station_place.h"

#include <gtest/gtest.h>

#include "tests/support/folders.h"

namespace coppice::robot {
namespace {

const std::string kPlaces = SourceFolder() + "/robot_app/config/sites/institute/places.yaml";

TEST(StationPlace, IsThePlaceOfTheCategoryStation) {
  std::optional<Pose2D> station;
  ASSERT_TRUE(ReadStation(kPlaces, station));
  ASSERT_TRUE(station);
  EXPECT_EQ(station->x, -2.4);
  EXPECT_NEAR(station->yaw, 3.1416, 1e-3);
}

TEST(StationPlace, WithoutAFileItStaysAsItIs) {
  std::optional<Pose2D> station = Pose2D{1, 2, 3};
  ASSERT_TRUE(ReadStation("none", station));
  EXPECT_EQ(station->x, 1);
}

TEST(StationPlace, TheHomeOfASiteWithoutAStationIsWhereItIsPickedUp) {
  const std::string upper = SourceFolder() + "/robot_app/config/sites/institute_upper/places.yaml";
  std::optional<Pose2D> station, home;
  ASSERT_TRUE(ReadStation(upper, station));
  EXPECT_FALSE(station);
  ASSERT_TRUE(ReadHome(upper, home));
  ASSERT_TRUE(home);
  EXPECT_EQ(home->x, 1.6);
}

TEST(StationPlace, TheHomeOfASiteWithAStationIsThat) {
  std::optional<Pose2D> home;
  ASSERT_TRUE(ReadHome(kPlaces, home));
  ASSERT_TRUE(home);
  EXPECT_EQ(home->x, -2.4);
}

TEST(StationPlace, AFileThatIsMissingIsAnError) {
  std::optional<Pose2D> station;
  EXPECT_FALSE(ReadStation("/nowhere/places.yaml", station));
  EXPECT_FALSE(station);
}

}  // namespace
}  // namespace coppice::robot
