#include "robot_app/common/occupancy_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/robot_app/navigation/test_floor.h"

namespace coppice::robot {
namespace {

TEST(OccupancyGrid, CellsAndPointsMatch) {
  GridFrame frame{0.05, -3, -7, 100, 50};
  const Cell cell = frame.CellAt(-2.99, -6.91);
  EXPECT_EQ(cell, (Cell{0, 1}));
  EXPECT_NEAR(frame.Center(cell).x, -2.975, 1e-12);
  EXPECT_EQ(frame.CellOf(frame.Index({7, 9})), (Cell{7, 9}));
  EXPECT_FALSE(frame.Contains(frame.CellAt(-3.01, -6.9)));
}

TEST(OccupancyGrid, UnknownIsBlocked) {
  OccupancyGrid grid{{0.05, 0, 0, 4, 1}, {0, -1, 64, 65}};
  EXPECT_FALSE(grid.Blocked(0));
  EXPECT_TRUE(grid.Blocked(1));
  EXPECT_FALSE(grid.Blocked(2));
  EXPECT_TRUE(grid.Blocked(3));
}

TEST(DistanceTransform, AgreesWithTheNearestBlockedCellOnRandomGrids) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    GridFrame frame{0.1, 0, 0, 5 + static_cast<int>(random() % 30),
                    5 + static_cast<int>(random() % 30)};
    std::vector<std::uint8_t> blocked(frame.size());
    for (auto& value : blocked) value = random() % 40 == 0;
    const double limit = 1.2;
    const std::vector<float> distance = DistanceTransform(frame, blocked, limit);
    for (int i = 0; i < frame.size(); ++i) {
      double nearest = limit;
      for (int j = 0; j < frame.size(); ++j) {
        if (blocked[j] == 0) continue;
        nearest = std::min(nearest,
                           Distance(frame.Center(frame.CellOf(i)), frame.Center(frame.CellOf(j))));
      }
      ASSERT_NEAR(distance[i], nearest, 1e-4) << "cell " << i << " of round " << round;
    }
  }
}

TEST(TraceLine, VisitsAConnectedChainThatHoldsEveryPointOfTheLine) {
  GridFrame frame{0.05, -1, -1, 80, 80};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.9, 2.9);
  for (int round = 0; round < 200; ++round) {
    const Point2D a{place(random), place(random)};
    const Point2D b{place(random), place(random)};
    std::vector<Cell> visited;
    EXPECT_TRUE(TraceLine(frame, a, b, [&](Cell cell) {
      visited.push_back(cell);
      return true;
    }));
    EXPECT_EQ(visited.front(), frame.CellAt(a.x, a.y));
    EXPECT_EQ(visited.back(), frame.CellAt(b.x, b.y));
    for (std::size_t i = 1; i < visited.size(); ++i) {
      EXPECT_EQ(
          std::abs(visited[i].x - visited[i - 1].x) + std::abs(visited[i].y - visited[i - 1].y), 1);
    }
    for (double part = 0; part < 1; part += 0.001) {
      const Cell on_line = frame.CellAt(a.x + part * (b.x - a.x), a.y + part * (b.y - a.y));
      EXPECT_NE(std::find(visited.begin(), visited.end(), on_line), visited.end());
    }
  }
}

TEST(TraceLine, StopsWhenToldTo) {
  GridFrame frame{0.05, 0, 0, 80, 80};
  int visits = 0;
  EXPECT_FALSE(TraceLine(frame, {0.1, 0.1}, {3, 0.1}, [&](Cell) { return ++visits < 5; }));
  EXPECT_EQ(visits, 5);
}

}  // namespace
}  // namespace coppice::robot
