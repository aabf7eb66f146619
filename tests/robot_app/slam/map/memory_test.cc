#include "robot_app/slam/map/memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice::robot::slam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Memory OfFive(std::size_t most) {
  Memory memory(most);
  for (int i = 0; i < 5; ++i) memory.Add();
  return memory;
}

TEST(Memory, WhatWasNotOfUseForTheLongestTimeMakesRoom) {
  Memory memory = OfFive(4);
  EXPECT_THAT(memory.Use({0}, 2).forgotten, ElementsAre(1));
  EXPECT_FALSE(memory.IsWorking(1));
  EXPECT_TRUE(memory.IsWorking(0));
}

TEST(Memory, WhatIsOfUseAgainIsRetrieved) {
  Memory memory = OfFive(4);
  memory.Use({}, 0);
  const MemoryChange change = memory.Use({0}, 2);
  EXPECT_THAT(change.retrieved, ElementsAre(0));
  EXPECT_THAT(change.forgotten, ElementsAre(1));
}

TEST(Memory, OnlySoManyAreRetrievedAtOnce) {
  Memory memory = OfFive(2);
  memory.Use({}, 0);
  EXPECT_THAT(memory.Use({0, 1, 2}, 1).retrieved, ElementsAre(0));
}

TEST(Memory, TheWorkingMemoryIsNeverLargerThanItMayBe) {
  Memory memory(10);
  for (std::uint32_t i = 0; i < 200; ++i) {
    memory.Add();
    memory.Use({i / 2, i / 3}, 4);
    EXPECT_LE(memory.working(), 10U);
    EXPECT_TRUE(memory.IsWorking(i));
  }
  EXPECT_EQ(memory.size(), 200U);
}

TEST(Memory, WithRoomForAllNothingIsForgotten) {
  EXPECT_THAT(OfFive(5).Use({1, 2}, 4).forgotten, IsEmpty());
}

}  // namespace
}  // namespace coppice::robot::slam
