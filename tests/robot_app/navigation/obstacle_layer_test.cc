#include "robot_app/navigation/obstacle_layer.h"

#include <gtest/gtest.h>

#include "tests/robot_app/navigation/test_floor.h"

namespace coppice::robot::navigation {
namespace {

class ObstacleLayerTest : public testing::Test {
 protected:
  ObstacleLayerTest() {
    layer_.Reset(room_.frame);
    Fill(blocked_, {4, 1}, {4.3, 1.5});
  }
  bool MarkedAt(double x, double y) const {
    return layer_.Marked(room_.frame.Index(room_.frame.CellAt(x, y)));
  }

  OccupancyGrid room_ = EmptyRoom(6, 3);
  OccupancyGrid blocked_ = EmptyRoom(6, 3);
  Pose2D pose_{1, 1.25, 0};
  ObstacleLayer layer_;
};

TEST_F(ObstacleLayerTest, MarksWhatTheLaserHits) {
  layer_.Insert(pose_, ScanOf(blocked_, pose_, 1));
  EXPECT_TRUE(MarkedAt(4.02, 1.22));
  EXPECT_FALSE(MarkedAt(3.5, 1.22));
}

TEST_F(ObstacleLayerTest, ClearsWhatTheLaserSeesThrough) {
  layer_.Insert(pose_, ScanOf(blocked_, pose_, 1));
  layer_.Insert(pose_, ScanOf(room_, pose_, 1.1));
  EXPECT_FALSE(MarkedAt(4.02, 1.22));
}

TEST_F(ObstacleLayerTest, ForgetsWhatItHasNotSeenForLong) {
  layer_.Insert(pose_, ScanOf(blocked_, pose_, 1));
  layer_.Forget(20);
  EXPECT_TRUE(MarkedAt(4.02, 1.22));
  layer_.Forget(22);
  EXPECT_FALSE(MarkedAt(4.02, 1.22));
  EXPECT_TRUE(layer_.marked().empty());
}

TEST_F(ObstacleLayerTest, KeepsWhatLiesBehindTheRobot) {
  layer_.Insert(pose_, ScanOf(blocked_, pose_, 1));
  const Pose2D turned{1, 1.25, M_PI};
  layer_.Insert(turned, ScanOf(room_, turned, 2));
  EXPECT_TRUE(MarkedAt(4.02, 1.22));
}

TEST_F(ObstacleLayerTest, ClearForgetsEverything) {
  layer_.Insert(pose_, ScanOf(blocked_, pose_, 1));
  layer_.Clear();
  EXPECT_TRUE(layer_.marked().empty());
  EXPECT_FALSE(MarkedAt(4.02, 1.22));
}

TEST_F(ObstacleLayerTest, ListsEveryMarkedCellOnce) {
  for (int i = 0; i < 3; ++i) layer_.Insert(pose_, ScanOf(blocked_, pose_, i));
  std::vector<int> marked = layer_.marked();
  std::sort(marked.begin(), marked.end());
  EXPECT_EQ(std::unique(marked.begin(), marked.end()), marked.end());
  for (const int index : marked) EXPECT_TRUE(layer_.Marked(index));
}

TEST_F(ObstacleLayerTest, ReadingsWithoutAnEchoClearButDoNotMark) {
  layer_.Insert(pose_, ScanOf(blocked_, pose_, 1));
  LaserScan nothing = ScanOf(room_, pose_, 2);
  nothing.ranges.assign(nothing.ranges.size(), INFINITY);
  layer_.Insert(pose_, nothing);
  EXPECT_FALSE(MarkedAt(4.02, 1.22));
}

}  // namespace
}  // namespace coppice::robot::navigation
