#include "robot_app/training/people_figures.h"

#include <gtest/gtest.h>

namespace coppice::robot::training {
namespace {

TEST(PeopleFigures, WhoIsNearASightIsFoundAndTheRestIsMissedOrFalse) {
  PeopleCount count;
  count.Add({{2, 0.3}, {0, 7}}, {{{2, 0}, 1, false}, {{0, -3}, 1, false}});
  const PeopleFigures figures = count.figures();
  EXPECT_EQ(figures.scans, 1);
  EXPECT_EQ(figures.of(Distance::kNear, Occlusion::kFree).people, 2);
  EXPECT_EQ(figures.of(Distance::kNear, Occlusion::kFree).missed, 1);
  EXPECT_EQ(figures.false_people[1], 1);
  EXPECT_NEAR(figures.position_error, 0.3, 1e-9);
}

TEST(PeopleFigures, WhoIsHiddenIsNeitherMissedNorFalse) {
  PeopleCount count;
  count.Add({{2, 0}}, {{{2, 0}, 0.1, false}, {{3, 0}, 0.2, false}});
  EXPECT_EQ(count.figures().of(Distance::kNear, Occlusion::kFree).people, 0);
  EXPECT_EQ(count.figures().false_per_scan(), 0);
}

TEST(PeopleFigures, TheTableNamesDistancesAndOcclusions) {
  PeopleFigures figures;
  figures.scans = 10;
  figures.misses[0][1] = {20, 1};
  figures.false_people[2] = 3;
  const std::string table = Table(figures);
  EXPECT_NE(table.find("| 0-5 m | 0.0 % of 0 missed | 5.0 % of 20 missed |"), std::string::npos);
  EXPECT_NE(table.find("| 0.300 |"), std::string::npos) << table;
}

}  // namespace
}  // namespace coppice::robot::training
