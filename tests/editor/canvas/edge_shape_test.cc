#include "editor/canvas/edge_shape.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

constexpr Box kParent{{100, 0}, {200, 30}};
constexpr Box kChild{{0, 100}, {80, 130}};

TEST(EdgeShape, ACurveGoesFromTheMiddleOfTheParentToTheMiddleOfTheChild) {
  const EdgeShape down = ShapeOfEdge(kParent, kChild, Link::kCurve, Orientation::kTopToBottom, 1);
  EXPECT_EQ(down.a.x, 150);
  EXPECT_EQ(down.a.y, 30);
  EXPECT_EQ(down.d.x, 40);
  EXPECT_EQ(down.d.y, 100);
  EXPECT_TRUE(down.branch.empty());
  const Box beside = {{300, 100}, {380, 130}};
  const EdgeShape right = ShapeOfEdge(kParent, beside, Link::kCurve, Orientation::kLeftToRight, 1);
  EXPECT_EQ(right.a.x, 200);
  EXPECT_EQ(right.d.x, 300);
  EXPECT_EQ(right.d.y, 115);
}

TEST(EdgeShape, ALeafInAColumnHangsOnTheTrunkLeftOfIt) {
  const EdgeShape edge = ShapeOfEdge(kParent, kChild, Link::kTrunk, Orientation::kTopToBottom, 1);
  ASSERT_FALSE(edge.branch.empty());
  const Point end = PointsAlong(edge).back();
  EXPECT_EQ(end.x, kChild.min.x);
  EXPECT_GT(end.y, kChild.min.y);
  EXPECT_LT(end.y, kChild.max.y);
  EXPECT_LT(edge.d.x, kChild.min.x);
}

TEST(EdgeShape, TheDistanceIsThatOfTheNearestPlace) {
  const EdgeShape edge = ShapeOfEdge(kParent, kChild, Link::kCurve, Orientation::kTopToBottom, 1);
  for (const Point at : PointsAlong(edge)) EXPECT_NEAR(DistanceTo(edge, at), 0, 0.01F);
  EXPECT_NEAR(DistanceTo(edge, edge.a - Point{0, 20}), 20, 0.5F);
  EXPECT_NEAR(DistanceTo(edge, edge.d + Point{0, 7}), 7, 0.5F);
}

}  // namespace
}  // namespace coppice::editor
