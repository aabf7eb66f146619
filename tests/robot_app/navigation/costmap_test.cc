#include "robot_app/navigation/costmap.h"

#include <gtest/gtest.h>

#include "robot_app/navigation/obstacle_layer.h"
#include "tests/robot_app/navigation/test_floor.h"

namespace coppice::robot::navigation {
namespace {

TEST(Costmap, IsLethalWhereTheRobotTouchesAWall) {
  Costmap costmap;
  const OccupancyGrid room = EmptyRoom(5, 5);
  costmap.Update(room);
  EXPECT_TRUE(costmap.Lethal(room.frame.CellAt(0.35, 2.5)));
  EXPECT_FALSE(costmap.Lethal(room.frame.CellAt(0.5, 2.5)));
  EXPECT_TRUE(costmap.Lethal(Cell{-1, 20})) << "outside";
}

TEST(Costmap, FallsWithTheDistanceToTheWall) {
  Costmap costmap;
  const OccupancyGrid room = EmptyRoom(5, 5);
  costmap.Update(room);
  double last = 1e9;
  for (double x = 0.5; x < 2.4; x += 0.1) {
    const double cost = costmap.cost(room.frame.Index(room.frame.CellAt(x, 2.5)));
    EXPECT_LE(cost, last);
    EXPECT_GE(cost, 1);
    last = cost;
  }
  EXPECT_DOUBLE_EQ(last, 1);
}

TEST(Costmap, ObstaclesOfTheLaserCountLikeWalls) {
  const OccupancyGrid room = EmptyRoom(5, 5);
  OccupancyGrid with_box = room;
  Fill(with_box, {2.5, 2.3}, {2.7, 2.7});
  ObstacleLayer layer;
  layer.Reset(room.frame);
  layer.Insert({1, 2.5, 0}, ScanOf(with_box, {1, 2.5, 0}, 0));
  Costmap costmap;
  costmap.Update(room, layer.marked());
  EXPECT_TRUE(costmap.Lethal(room.frame.CellAt(2.3, 2.5)));
  costmap.Update(room);
  EXPECT_FALSE(costmap.Lethal(room.frame.CellAt(2.3, 2.5)));
}

}  // namespace
}  // namespace coppice::robot::navigation
