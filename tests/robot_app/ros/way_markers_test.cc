#include "robot_app/ros/way_markers.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "tests/robot_app/common/places/sample_map.h"

namespace coppice::robot::adapters {
namespace {

using visualization_msgs::Marker;

class WayMarkersTest : public testing::Test {
 protected:
  int EdgeOf(const char* from, const char* to) {
    return map_.FindEdge(map_.Find(from), map_.Find(to));
  }
  Marker WordsOf(int edge) {
    const auto message = MarkersOf(map_, memory_, now_, "map");
    for (const Marker& marker : message.markers) {
      if (marker.id == edge + 1) return marker;
    }
    ADD_FAILURE() << "no words of edge " << edge;
    return {};
  }

  const TopologicalMap map_ = SampleMap();
  EdgeMemory memory_{map_};
  const Time now_ = Time{} + std::chrono::hours(100);
};

TEST_F(WayMarkersTest, OfAWayThatNobodyTravelledThereIsALineWithoutWords) {
  const auto message = MarkersOf(map_, memory_, now_, "map");
  const Marker& lines = message.markers[0];
  EXPECT_EQ(lines.header.frame_id, "map");
  EXPECT_GT(lines.points.size(), 4U);
  EXPECT_EQ(lines.points.size(), lines.colors.size());
  EXPECT_EQ(lines.points.size(), 2 * (message.markers.size() - 1));
  EXPECT_EQ(lines.colors[0].r, lines.colors[0].g);
  EXPECT_EQ(WordsOf(EdgeOf("west", "middle")).action, Marker::DELETE);
}

TEST_F(WayMarkersTest, SaysWhatAWayTakesAndHowOftenItWasTravelled) {
  const int edge = EdgeOf("west", "middle");
  const double expected = memory_.expected()[static_cast<std::size_t>(edge)];
  memory_.Travelled({edge}, expected);
  memory_.Travelled({edge}, expected);
  const Marker usual = WordsOf(edge);
  EXPECT_EQ(usual.action, Marker::ADD);
  const std::string seconds = std::to_string(std::lround(expected));
  EXPECT_EQ(usual.text, seconds + " s (expected " + seconds + "), travelled 2 times");
  EXPECT_GT(usual.color.g, usual.color.r);
  for (int i = 0; i < 30; ++i) memory_.Travelled({edge}, 3 * expected);
  EXPECT_GT(WordsOf(edge).color.r, WordsOf(edge).color.g);
}

TEST_F(WayMarkersTest, ABlockedWayIsRedAndSaysForHowLong) {
  const int edge = EdgeOf("west", "middle");
  memory_.Failed(edge, now_ - std::chrono::hours(6));
  const Marker words = WordsOf(edge);
  EXPECT_NE(words.text.find("travelled 0 times, 1 failed, blocked for 18.0 h"), std::string::npos)
      << words.text;
  EXPECT_GT(words.color.r, 3 * words.color.g);
}

TEST_F(WayMarkersTest, BothDirectionsKeepToTheirRight) {
  const auto y_of = [&](const char* from, const char* to) {
    return WordsOf(EdgeOf(from, to)).pose.position.y;
  };
  EXPECT_LT(y_of("west", "middle"), y_of("middle", "west"));  // eastwards, right is south
}

}  // namespace
}  // namespace coppice::robot::adapters
