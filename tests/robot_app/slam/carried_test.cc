// The robot finds out where it is by the places that it recognizes; few places of the study that
// `./dev bench localization` makes.
#include <gtest/gtest.h>

#include "tests/robot_app/slam/carried_study.h"

namespace coppice::robot::slam {
namespace {

using localization::LocalizationPhase;

// The station, and two offices that look alike to a scanner.
KnownInstitute& Institute() {
  static KnownInstitute institute({{-0.8, 0},
                                   {-0.4, 0},
                                   {8, 0},
                                   {8, 3.4},
                                   {9.6, 4},
                                   {8, 3},
                                   {8, 0},
                                   {32, 0},
                                   {32, 3.4},
                                   {33.6, 4},
                                   {32, 3}});
  return institute;
}

TEST(Carried, WithPicturesItKnowsWhichOfTwoOfficesThatLookAlikeItIsIn) {
  const Pose2D hall{46, 0, 0}, office_104{32.2, 3.6, 1.2};
  const CarriedOutcome alone = PutAt(Institute(), hall, office_104, 1, {false, true});
  EXPECT_EQ(alone.phase, LocalizationPhase::kUncertain);
  const CarriedOutcome seeing = PutAt(Institute(), hall, office_104, 1, {true, true});
  EXPECT_TRUE(seeing.lost);
  EXPECT_GT(seeing.hints, 0);
  EXPECT_EQ(seeing.wrong_hints, 0);
  EXPECT_TRUE(seeing.found()) << seeing.error;
}

TEST(Carried, WhereItHasNeverBeenNothingIsRecognizedAndNoWrongPlaceIsCalledOk) {
  const CarriedOutcome outcome = PutAt(Institute(), {46, 0, 0}, {16.1, -3.6, 0.5}, 2, {true, true});
  EXPECT_EQ(outcome.wrong_hints, 0);
  EXPECT_EQ(outcome.wrong, 0);
}

TEST(Carried, ThePosterAboveTheStationTellsARobotThatHasJustUndockedWhereItIs) {
  const Pose2D undocked{-0.95, 0.1, M_PI - 0.1};
  const CarriedOutcome outcome = PutAt(Institute(), {}, undocked, 3, {true, false});
  EXPECT_TRUE(outcome.found_standing);
  EXPECT_EQ(outcome.wrong, 0);
  EXPECT_TRUE(outcome.found()) << outcome.error;
}

}  // namespace
}  // namespace coppice::robot::slam
