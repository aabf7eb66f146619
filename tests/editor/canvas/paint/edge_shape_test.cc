#include "editor/canvas/paint/edge_shape.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::editor {
namespace {

constexpr Box kParent{{100, 0}, {200, 30}};
constexpr Box kChild{{0, 100}, {80, 130}};

EdgeEnds Ends(const Box& child, Link link, Orientation orientation = Orientation::kTopToBottom) {
  EdgeEnds ends;
  ends.parent = kParent;
  ends.child = child;
  ends.link = link;
  ends.orientation = orientation;
  return ends;
}

TEST(EdgeShape, ACurveGoesFromTheMiddleOfTheParentToTheMiddleOfTheChild) {
  const EdgeShape down = ShapeOfEdge(Ends(kChild, Link::kCurve));
  EXPECT_EQ(down.a.x, 150);
  EXPECT_EQ(down.a.y, 30);
  EXPECT_EQ(down.d.x, 40);
  EXPECT_EQ(down.d.y, 100);
  EXPECT_TRUE(down.branch.empty());
  const Box beside = {{300, 100}, {380, 130}};
  const EdgeShape right = ShapeOfEdge(Ends(beside, Link::kCurve, Orientation::kLeftToRight));
  EXPECT_EQ(right.a.x, 200);
  EXPECT_EQ(right.d.x, 300);
  EXPECT_EQ(right.d.y, 115);
}

// Its siblings without a note begin there too: the curve does not cross them.
TEST(EdgeShape, ACurveArrivesAtTheNoteAndGoesStraightBehindIt) {
  EdgeEnds ends = Ends(kChild, Link::kCurve);
  ends.child_note = 12;
  const EdgeShape edge = ShapeOfEdge(ends);
  EXPECT_EQ(edge.d.y, kChild.min.y);
  EXPECT_EQ(edge.arrival, edge.d);
  ASSERT_EQ(edge.branch.size(), 1U);
  EXPECT_EQ(edge.branch[0], edge.d + (Point{0, 12}));
}

TEST(EdgeShape, AcrossItMeetsTheMiddleOfTheNodesBelowTheirNotes) {
  EdgeEnds ends = Ends({{300, 100}, {380, 130}}, Link::kCurve, Orientation::kLeftToRight);
  ends.child_note = 10;
  ends.parent_note = 6;
  const EdgeShape edge = ShapeOfEdge(ends);
  EXPECT_EQ(edge.a.y, 18);
  EXPECT_EQ(edge.d.y, 120);
}

TEST(EdgeShape, ALeafInAColumnHangsOnTheTrunkLeftOfIt) {
  const EdgeShape edge = ShapeOfEdge(Ends(kChild, Link::kTrunk));
  ASSERT_FALSE(edge.branch.empty());
  const Point end = PointsAlong(edge).back();
  EXPECT_EQ(end.x, kChild.min.x);
  EXPECT_GT(end.y, kChild.min.y);
  EXPECT_LT(end.y, kChild.max.y);
  EXPECT_LT(edge.d.x, kChild.min.x);
}

// Down the side of the rows, along the top of its own, and down to it.
TEST(EdgeShape, ANodeInARowHangsOnTheLineAlongAllRows) {
  const Box child = {{400, 300}, {480, 330}};
  const EdgeShape edge = ShapeOfEdge(Ends(child, Link::kRow));
  const std::vector<Point> way = PointsAlong(edge);
  EXPECT_EQ(way.front().y, kParent.max.y);
  EXPECT_LT(way.front().x, kParent.min.x + 30) << "at the left side of the parent";
  EXPECT_EQ(way.back(), (Point{440, 300}));
  for (const Point at : way) {
    const bool at_the_side = std::abs(at.x - way.front().x) < 10;
    const bool above_the_row = at.y > 270;
    EXPECT_TRUE(at_the_side || above_the_row) << at.x << " " << at.y;
  }
}

TEST(EdgeShape, AcrossTheRowsAreColumns) {
  const Box child = {{600, 200}, {680, 230}};
  const std::vector<Point> way =
      PointsAlong(ShapeOfEdge(Ends(child, Link::kRow, Orientation::kLeftToRight)));
  EXPECT_EQ(way.front().x, kParent.max.x);
  EXPECT_EQ(way.back(), (Point{600, 215}));
}

bool Contains(const Box& box, Point at) { return Box{at, at}.Overlaps(box); }

TEST(EdgeShape, TheWholeLineIsInItsBounds) {
  for (const Orientation orientation : {Orientation::kTopToBottom, Orientation::kLeftToRight}) {
    for (const Link link : {Link::kCurve, Link::kTrunk, Link::kRow}) {
      EdgeEnds ends = Ends({{400, 380}, {480, 410}}, link, orientation);
      ends.zoom = 0.5F;
      const EdgeBounds bounds = BoundsOf(ends);
      for (const Point at : PointsAlong(ShapeOfEdge(ends))) {
        EXPECT_TRUE(Contains(bounds.stem, at) || Contains(bounds.rest, at))
            << at.x << " " << at.y << " link " << static_cast<int>(link);
      }
      for (const Point at : PartBehindStem(ShapeOfEdge(ends), ends)) {
        EXPECT_TRUE(Contains(bounds.rest, at)) << at.x << " " << at.y;
      }
    }
  }
}

// So what lies in the corner between them needs no line.
TEST(EdgeShape, TheBoundsOfALineToARowLeaveTheCornerFree) {
  const EdgeBounds bounds = BoundsOf(Ends({{900, 800}, {980, 830}}, Link::kRow));
  EXPECT_FALSE(Contains(bounds.stem, {500, 400}));
  EXPECT_FALSE(Contains(bounds.rest, {500, 400}));
}

TEST(EdgeShape, TheStemOfALaterSiblingCoversThoseBeforeIt) {
  for (const Link link : {Link::kTrunk, Link::kRow}) {
    const EdgeEnds before = Ends({{120, 100}, {200, 130}}, link);
    const EdgeEnds behind = Ends({{120, 200}, {200, 230}}, link);
    ASSERT_TRUE(HasStem(before));
    const EdgeShape covering = ShapeOfEdge(behind);
    for (const Point at : PointsAlong(ShapeOfEdge(before))) {
      const bool in_rest = Contains(BoundsOf(before).rest, at);
      EXPECT_TRUE(in_rest || DistanceTo(covering, at) < 1) << at.x << " " << at.y;
    }
  }
}

TEST(EdgeShape, ColumnsSideBySideHaveStemsOfTheirOwn) {
  const EdgeEnds left = Ends({{20, 100}, {100, 130}}, Link::kTrunk);
  const EdgeEnds below = Ends({{20, 200}, {60, 230}}, Link::kTrunk);
  const EdgeEnds right = Ends({{220, 200}, {300, 230}}, Link::kTrunk);
  EXPECT_EQ(BoundsOf(left).lane, BoundsOf(below).lane);
  EXPECT_NE(BoundsOf(left).lane, BoundsOf(right).lane);
}

TEST(EdgeShape, CurvesHaveNoStem) {
  EXPECT_FALSE(HasStem(Ends(kChild, Link::kCurve)));
  EXPECT_FALSE(HasStem(Ends(kChild, Link::kTrunk, Orientation::kLeftToRight)));
}

TEST(EdgeShape, TheDistanceIsThatOfTheNearestPlace) {
  const EdgeShape edge = ShapeOfEdge(Ends(kChild, Link::kCurve));
  for (const Point at : PointsAlong(edge)) EXPECT_NEAR(DistanceTo(edge, at), 0, 0.01F);
  EXPECT_NEAR(DistanceTo(edge, edge.a - Point{0, 20}), 20, 0.5F);
  EXPECT_NEAR(DistanceTo(edge, edge.d + Point{0, 7}), 7, 0.5F);
}

}  // namespace
}  // namespace coppice::editor
