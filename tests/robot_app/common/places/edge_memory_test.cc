#include "robot_app/common/places/edge_memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

#include "robot_app/common/places/route.h"
#include "tests/robot_app/common/places/sample_map.h"

namespace coppice::robot {
namespace {

using std::chrono::hours;
using testing::HasSubstr;

class EdgeMemoryTest : public testing::Test {
 protected:
  int EdgeOf(const char* from, const char* to) {
    return map_.FindEdge(map_.Find(from), map_.Find(to));
  }
  double Cost(int edge, Time now) { return memory_.Costs(now)[static_cast<std::size_t>(edge)]; }
  const EdgeRecord& Record(int edge) { return memory_.records()[static_cast<std::size_t>(edge)]; }

  const TopologicalMap map_ = SampleMap();
  EdgeMemory memory_{map_};
  const Time now_ = Time{} + hours(100);
};

TEST_F(EdgeMemoryTest, AnEdgeThatNobodyTravelledCostsWhatIsExpected) {
  EXPECT_EQ(memory_.Costs(now_), ExpectedCosts(map_));
}

TEST_F(EdgeMemoryTest, AnEdgeCostsTheMeanOfItsTrips) {
  const int edge = EdgeOf("west", "middle");
  memory_.Travelled({edge}, 30);
  EXPECT_DOUBLE_EQ(Cost(edge, now_), 30);
  memory_.Travelled({edge}, 40);
  EXPECT_DOUBLE_EQ(Cost(edge, now_), 35);
}

TEST_F(EdgeMemoryTest, WhatChangedIsLearntWithinTwentyTrips) {
  const int edge = EdgeOf("west", "middle");
  for (int i = 0; i < 1000; ++i) memory_.Travelled({edge}, 20);
  for (int i = 0; i < 60; ++i) memory_.Travelled({edge}, 60);
  EXPECT_NEAR(Cost(edge, now_), 60, 2.5);
}

TEST_F(EdgeMemoryTest, TheTimeOfALegIsSharedByWhatIsExpectedOfItsEdges) {
  const int short_way = EdgeOf("middle", "east"), long_way = EdgeOf("west", "yard");
  const double expected = ExpectedCosts(map_)[static_cast<std::size_t>(short_way)] +
                          ExpectedCosts(map_)[static_cast<std::size_t>(long_way)];
  memory_.Travelled({short_way, long_way}, 2 * expected);
  EXPECT_NEAR(Cost(short_way, now_), 40, 1e-9);
  EXPECT_GT(Cost(long_way, now_), 80);
}

TEST_F(EdgeMemoryTest, ABlockedEdgeIsAvoidedForADayInBothDirections) {
  const int edge = EdgeOf("west", "middle"), back = EdgeOf("middle", "west");
  memory_.Failed(edge, now_);
  EXPECT_GT(Cost(edge, now_ + hours(23)), 3600);
  EXPECT_GT(Cost(back, now_ + hours(23)), 3600);
  EXPECT_LT(Cost(edge, now_ + hours(24)), 100);
  EXPECT_EQ(Record(edge).failures, 1);
  EXPECT_EQ(Record(back).failures, 0);
}

TEST_F(EdgeMemoryTest, WhoGetsThroughUnblocksIt) {
  const int edge = EdgeOf("west", "middle"), back = EdgeOf("middle", "west");
  memory_.Failed(edge, now_);
  memory_.Travelled({back}, 20, false);
  EXPECT_LT(Cost(edge, now_), 100);
  EXPECT_EQ(Record(back).trips, 0);
}

TEST_F(EdgeMemoryTest, ReadsBackWhatItWrote) {
  memory_.Travelled({EdgeOf("west", "middle")}, 30);
  memory_.Failed(EdgeOf("middle", "room"), now_);
  const std::string path = testing::TempDir() + "edges.yaml";
  std::ofstream(path) << memory_.ToText();
  EdgeMemory read(map_);
  Diagnostics diagnostics;
  read.Read(path, now_, diagnostics);
  EXPECT_EQ(diagnostics.ToString(), "");
  EXPECT_EQ(read.Costs(now_), memory_.Costs(now_));
}

TEST_F(EdgeMemoryTest, EdgesThatAreGoneAndBlocksOfAnotherClockAreForgotten) {
  const std::string path = testing::TempDir() + "old_edges.yaml";
  std::ofstream(path) << "edges:\n"
                         "  - {edge: \"west -> cellar\", trips: 3, seconds: 20}\n"
                         "  - {edge: \"west -> middle\", failures: 1, blocked_until: 3000000000}\n";
  Diagnostics diagnostics;
  memory_.Read(path, now_, diagnostics);
  EXPECT_EQ(diagnostics.ToString(), "");
  EXPECT_EQ(memory_.Costs(now_), ExpectedCosts(map_));
}

TEST_F(EdgeMemoryTest, ABrokenFileIsToldWithItsLine) {
  const std::string path = testing::TempDir() + "broken_edges.yaml";
  std::ofstream(path) << "edges:\n  - {edge: \"west -> middle\", trips: many}\n";
  Diagnostics diagnostics;
  memory_.Read(path, now_, diagnostics);
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("broken_edges.yaml:2"));
}

TEST_F(EdgeMemoryTest, AFileThatIsNotThereIsNoProblem) {
  Diagnostics diagnostics;
  memory_.Read("/no/such/edges.yaml", now_, diagnostics);
  EXPECT_EQ(diagnostics.ToString(), "");
}

}  // namespace
}  // namespace coppice::robot
