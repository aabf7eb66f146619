#include "robot_app/navigation/sonar_layer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/robot_app/navigation/test_floor.h"

namespace coppice::robot::navigation {
namespace {

using testing::HasSubstr;

constexpr double kNow = 100;

// The sensor is at (1, 3.02) and looks along x.
class SonarLayerTest : public testing::Test {
 protected:
  SonarLayerTest() { layer_.Reset(EmptyRoom(6, 6).frame); }

  static RangeReading Reading(double range, double stamp = kNow) {
    RangeReading reading;
    reading.stamp = stamp;
    reading.range = range;
    return reading;
  }
  Outcome Hear(const RangeReading& reading, const std::vector<Point2D>& seen = {}) {
    return layer_.Insert(pose_, reading, seen, reading.stamp);
  }
  bool MarkedAt(double x, double y) const {
    const GridFrame frame = EmptyRoom(6, 6).frame;
    return layer_.Marked(frame.Index(frame.CellAt(x, y)));
  }

  SonarLayer layer_;
  Pose2D pose_{1, 3.02, 0};
};

TEST_F(SonarLayerTest, AnEchoMarksTheArcAtItsRange) {
  EXPECT_TRUE(Hear(Reading(1.02)));
  for (const double bearing : {-0.25, -0.1, 0.0, 0.1, 0.25}) {
    EXPECT_TRUE(MarkedAt(1 + 1.02 * std::cos(bearing), 3.02 + 1.02 * std::sin(bearing))) << bearing;
  }
  EXPECT_FALSE(MarkedAt(1 + 1.02 * std::cos(0.4), 3.02 + 1.02 * std::sin(0.4)))
      << "beside the cone";
  EXPECT_FALSE(MarkedAt(1.9, 3.02)) << "nearer";
  EXPECT_FALSE(MarkedAt(2.2, 3.02)) << "farther";
}

TEST_F(SonarLayerTest, AnEchoCountsFromWhereTheSensorIsMounted) {
  RangeReading reading = Reading(1.02);
  reading.mount = {0, 0.5, M_PI / 2};
  EXPECT_TRUE(Hear(reading));
  EXPECT_TRUE(MarkedAt(1, 4.54));
}

TEST_F(SonarLayerTest, AnEchoThatTheLaserExplainsMarksNothing) {
  EXPECT_TRUE(Hear(Reading(1.02), {{2.05, 3.1}}));
  EXPECT_TRUE(layer_.marked().empty());
}

TEST_F(SonarLayerTest, WhatTheLaserSeesBehindOrBesideTheEchoExplainsNothing) {
  EXPECT_TRUE(Hear(Reading(1.02), {{2.4, 3}, {2, 3.6}, {1.5, 3}}));
  EXPECT_TRUE(MarkedAt(2.02, 3.02));
}

TEST_F(SonarLayerTest, AnEchoFromFarAwayMarksNothing) {
  EXPECT_TRUE(Hear(Reading(2)));
  EXPECT_TRUE(layer_.marked().empty());
}

TEST_F(SonarLayerTest, AnEchoFromBehindClearsWhatWasMarked) {
  EXPECT_TRUE(Hear(Reading(1)));
  EXPECT_TRUE(Hear(Reading(3)));
  EXPECT_TRUE(layer_.marked().empty());
}

TEST_F(SonarLayerTest, SilenceClearsWhatWasMarked) {
  EXPECT_TRUE(Hear(Reading(1)));
  EXPECT_TRUE(Hear(Reading(HUGE_VAL)));
  EXPECT_TRUE(layer_.marked().empty());
}

TEST_F(SonarLayerTest, ANearerEchoClearsNothingBehindIt) {
  EXPECT_TRUE(Hear(Reading(1.42)));
  EXPECT_TRUE(Hear(Reading(0.8)));
  EXPECT_TRUE(MarkedAt(2.42, 3.02));
}

TEST_F(SonarLayerTest, WhatLiesBesideTheConeIsNotCleared) {
  EXPECT_TRUE(Hear(Reading(1.02)));
  pose_.yaw = 0.8;
  EXPECT_TRUE(Hear(Reading(HUGE_VAL)));
  EXPECT_TRUE(MarkedAt(2.02, 3.02));
}

// A pane sends the sound of who looks at it at a slant elsewhere.
TEST_F(SonarLayerTest, SilenceFromAnotherSideRefutesNothing) {
  EXPECT_TRUE(Hear(Reading(1.02)));
  pose_ = {1.3, 2.32, M_PI / 4};
  EXPECT_TRUE(Hear(Reading(HUGE_VAL)));
  EXPECT_TRUE(MarkedAt(2.02, 3.02));
}

TEST_F(SonarLayerTest, SomethingTooNearIsMarkedBeforeTheSensor) {
  EXPECT_TRUE(Hear(Reading(-HUGE_VAL)));
  EXPECT_TRUE(MarkedAt(1.08, 3.02));
}

TEST_F(SonarLayerTest, SomethingTooNearThatTheLaserSeesIsNotMarked) {
  EXPECT_TRUE(Hear(Reading(-HUGE_VAL), {{1.15, 3}}));
  EXPECT_TRUE(layer_.marked().empty());
}

TEST_F(SonarLayerTest, MarksFade) {
  EXPECT_TRUE(Hear(Reading(1)));
  layer_.Forget(kNow + SonarSettings().forget_after - 0.1);
  EXPECT_FALSE(layer_.marked().empty());
  layer_.Forget(kNow + SonarSettings().forget_after + 0.1);
  EXPECT_TRUE(layer_.marked().empty());
}

TEST_F(SonarLayerTest, MarksThatAreHeardAgainStay) {
  EXPECT_TRUE(Hear(Reading(1.02)));
  EXPECT_TRUE(Hear(Reading(1.02, kNow + 8)));
  layer_.Forget(kNow + SonarSettings().forget_after + 0.1);
  EXPECT_TRUE(MarkedAt(2.02, 3.02));
}

TEST_F(SonarLayerTest, EveryMarkIsListedOnce) {
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(Hear(Reading(1, kNow + i)));
  std::vector<int> marked = layer_.marked();
  std::sort(marked.begin(), marked.end());
  EXPECT_EQ(std::unique(marked.begin(), marked.end()), marked.end());
}

TEST_F(SonarLayerTest, TellsTheMarksNearAPoseInItsFrame) {
  EXPECT_TRUE(Hear(Reading(1.02)));
  std::vector<Point2D> points;
  layer_.AddPoints({2, 2.02, M_PI / 2}, 3, points);
  ASSERT_FALSE(points.empty());
  for (const Point2D& point : points) EXPECT_NEAR(std::hypot(point.x - 1, point.y + 1), 1.02, 0.06);
  points.clear();
  layer_.AddPoints({5, 5, 0}, 3, points);
  EXPECT_TRUE(points.empty());
}

TEST_F(SonarLayerTest, AnEchoBeyondTheMapMarksNothing) {
  pose_ = {0.3, 3.02, M_PI};
  EXPECT_TRUE(Hear(Reading(1)));
  EXPECT_TRUE(layer_.marked().empty());
}

TEST_F(SonarLayerTest, ReadingsThatTellNothingAreRefusedAndChangeNothing) {
  EXPECT_TRUE(Hear(Reading(1.02)));
  for (const double range : {std::nan(""), -1.0, 0.0, 0.1, 4.1, 1e30}) {
    EXPECT_FALSE(Hear(Reading(range))) << range;
  }
  EXPECT_TRUE(MarkedAt(2.02, 3.02));
}

TEST_F(SonarLayerTest, AReadingThatIsOldOrOfTheFutureIsRefused) {
  for (const double stamp : {kNow - 0.6, kNow + 0.3, 0.0, 1e300, std::nan("")}) {
    EXPECT_THAT(layer_.Insert(pose_, Reading(1, stamp), {}, kNow).problem(), HasSubstr("old"))
        << stamp;
  }
  EXPECT_TRUE(layer_.marked().empty());
}

}  // namespace
}  // namespace coppice::robot::navigation
