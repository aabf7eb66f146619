#include "robot_app/slam/map/memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice::robot::slam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Each key frame at a place of its own.
std::uint64_t Apart(std::uint32_t key_frame) { return key_frame; }

Memory OfFive(std::size_t most) {
  Memory memory(most);
  for (int i = 0; i < 5; ++i) memory.Add();
  return memory;
}

TEST(Memory, WhatWasNotOfUseForTheLongestTimeMakesRoom) {
  Memory memory = OfFive(4);
  EXPECT_THAT(memory.Use({0}, 9, 2, Apart).forgotten, ElementsAre(1));
  EXPECT_FALSE(memory.IsWorking(1));
  EXPECT_TRUE(memory.IsWorking(0));
}

TEST(Memory, WhatIsOfUseAgainIsRetrieved) {
  Memory memory = OfFive(4);
  memory.Use({}, 9, 0, Apart);
  const MemoryChange change = memory.Use({0}, 9, 2, Apart);
  EXPECT_THAT(change.retrieved, ElementsAre(0));
  EXPECT_THAT(change.forgotten, ElementsAre(1));
}

TEST(Memory, OnlySoManyAreRetrievedAtOnce) {
  Memory memory = OfFive(2);
  memory.Use({}, 9, 0, Apart);
  EXPECT_THAT(memory.Use({0, 1, 2}, 9, 1, Apart).retrieved, ElementsAre(0));
}

TEST(Memory, WhereEnoughIsKnownNothingIsRetrieved) {
  Memory memory = OfFive(3);
  memory.Use({}, 9, 0, Apart);
  EXPECT_THAT(memory.Use({0, 3, 4}, 2, 9, Apart).retrieved, IsEmpty());
  EXPECT_THAT(memory.Use({0, 3, 4}, 3, 9, Apart).retrieved, ElementsAre(0));
}

TEST(Memory, SomethingOfEachPlaceStays) {
  Memory memory(10);
  const auto place_of = [](std::uint32_t key_frame) -> std::uint64_t {
    return key_frame < 5 ? key_frame : 5 + key_frame % 2;
  };
  for (std::uint32_t i = 0; i < 100; ++i) {
    memory.Add();
    memory.Use({i}, 9, 0, place_of);
  }
  for (std::uint32_t i = 0; i < 5; ++i) EXPECT_TRUE(memory.IsWorking(i)) << i;
  EXPECT_EQ(memory.working(), 10U);
}

TEST(Memory, WhatCouldNotBeReadIsNotWorkedWith) {
  Memory memory = OfFive(4);
  memory.Use({}, 9, 0, Apart);
  memory.Use({0}, 9, 1, Apart);
  memory.PutBack(0);
  memory.PutBack(0);
  EXPECT_FALSE(memory.IsWorking(0));
  EXPECT_EQ(memory.working(), 3U);
}

TEST(Memory, TheWorkingMemoryIsNeverLargerThanItMayBe) {
  Memory memory(10);
  for (std::uint32_t i = 0; i < 200; ++i) {
    memory.Add();
    memory.Use({i / 2, i / 3}, 9, 4, Apart);
    EXPECT_LE(memory.working(), 10U);
    EXPECT_TRUE(memory.IsWorking(i));
  }
  EXPECT_EQ(memory.size(), 200U);
}

TEST(Memory, WithRoomForAllNothingIsForgotten) {
  EXPECT_THAT(OfFive(5).Use({1, 2}, 9, 4, Apart).forgotten, IsEmpty());
}

}  // namespace
}  // namespace coppice::robot::slam
