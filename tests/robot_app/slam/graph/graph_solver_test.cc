#include "robot_app/slam/graph/graph_solver.h"

#include <gtest/gtest.h>

#include "robot_app/training/maps/building_tour.h"

namespace coppice::robot::slam {
namespace {

training::BuildingTourSettings Building(int sessions, std::uint64_t seed) {
  training::BuildingTourSettings building;
  building.seed = seed;
  building.sessions = sessions;
  return building;
}

TEST(GraphSolver, AnUpdateSolvesNoMoreInALargeMapThanInASmallOne) {
  const auto tour = training::TourOfABuilding(Building(3, 1));
  const training::GraphFigures large = training::MeasureGraph(tour, {});
  EXPECT_EQ(large.key_frames, 3000U);
  EXPECT_GT(large.believed, 1000);
  const SolverSettings settings;
  // Groups, a part around a closure, a part that was rough; and the poses around parts, which stay.
  EXPECT_LE(large.most_poses, settings.coarse.most_groups + 3 * settings.part_poses);
  EXPECT_LE(large.most_links, 2 * settings.part_links);
}

TEST(GraphSolver, SolvedInPartsAMapIsVeryNearlyAsGoodAsSolvedAtOnce) {
  const training::GraphFigures figures =
      training::MeasureGraph(training::TourOfABuilding(Building(2, 2)), {});
  EXPECT_EQ(figures.refused, 0);
  EXPECT_LT(figures.error, 1.2 * figures.error_at_once);
}

TEST(GraphSolver, AFalseClosureIsRefusedAlsoWhereTheMapIsSolvedInParts) {
  auto tour = training::TourOfABuilding(Building(2, 4));
  int right = 0, wrong = 0;
  for (training::TourStep& step : tour) {
    if (step.closures.empty()) continue;
    // Not while a session is joined or a first loop is closed, where nothing contradicts.
    if (++right < 600 && right % 20 == 0 && right > 100) {
      step.closures[0].relative.translation().x() += 2;
      ++wrong;
    }
  }
  ASSERT_GT(wrong, 10);
  const training::GraphFigures figures = training::MeasureGraph(tour, {});
  EXPECT_EQ(figures.refused, wrong);
  EXPECT_LT(figures.error, 1.2 * figures.error_at_once);
}

TEST(GraphSolver, TheSameCallsGiveTheSamePoses) {
  training::BuildingTourSettings building = Building(2, 5);
  building.key_frames = 300;
  const auto tour = training::TourOfABuilding(building);
  const training::GraphFigures once = training::MeasureGraph(tour, {});
  const training::GraphFigures again = training::MeasureGraph(tour, {});
  EXPECT_EQ(once.error, again.error);
  EXPECT_EQ(once.most_links, again.most_links);
}

}  // namespace
}  // namespace coppice::robot::slam
