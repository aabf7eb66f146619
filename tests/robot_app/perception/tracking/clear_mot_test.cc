#include "robot_app/perception/tracking/clear_mot.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot::perception {
namespace {

TEST(ClearMot, PerfectTrackingIsOne) {
  ClearMot mot;
  for (int i = 0; i < 5; ++i)
    mot.Add({{1, {i, 0}}, {2, {0, i + 3}}}, {{7, {i, 0}}, {8, {0, i + 3}}});
  EXPECT_EQ(mot.mota(), 1);
  EXPECT_EQ(mot.position_error(), 0);
}

TEST(ClearMot, AMissAndAFalseTrackCountOneEach) {
  ClearMot mot;
  mot.Add({{1, {0, 0}}, {2, {5, 0}}}, {{7, {0, 0}}, {8, {9, 9}}});
  EXPECT_EQ(mot.missed, 1);
  EXPECT_EQ(mot.extra, 1);
  EXPECT_EQ(mot.mota(), 0);
}

TEST(ClearMot, TwoTracksThatChangeTheirPeopleAreTwoSwitches) {
  ClearMot mot;
  mot.Add({{1, {0, 0}}, {2, {5, 0}}}, {{7, {0, 0}}, {8, {5, 0}}});
  mot.Add({{1, {0, 0}}, {2, {5, 0}}}, {{8, {0, 0}}, {7, {5, 0}}});
  EXPECT_EQ(mot.switches, 2);
}

TEST(ClearMot, APairIsKeptThoughAnotherTrackIsNearer) {
  ClearMot mot;
  mot.Add({{1, {0, 0}}}, {{7, {0, 0}}});
  mot.Add({{1, {0, 0}}}, {{7, {0.4, 0}}, {8, {0.1, 0}}});
  EXPECT_EQ(mot.switches, 0);
  EXPECT_EQ(mot.extra, 1);
}

TEST(ClearMot, WhoeverIsHiddenIsNeitherMissedNorFalse) {
  ClearMot mot;
  mot.Add({{1, {0, 0}, true}, {2, {5, 0}, true}}, {{7, {0, 0}}});
  EXPECT_EQ(mot.missed + mot.extra + mot.people, 0);
}

TEST(ClearMot, ThePositionErrorIsTheRootOfTheMeanSquare) {
  ClearMot mot;
  mot.Add({{1, {0, 0}}, {2, {5, 0}}}, {{7, {0.3, 0}}, {8, {5.1, 0}}});
  EXPECT_NEAR(mot.position_error(), std::sqrt((0.09 + 0.01) / 2), 1e-12);
}

}  // namespace
}  // namespace coppice::robot::perception
