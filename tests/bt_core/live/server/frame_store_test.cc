#include "bt_core/live/server/frame_store.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

StoredFrame Make(FrameType type, std::uint64_t tick, const std::string& bytes = "0123456789") {
  return {type, tick, Time{}, bytes};
}

// The memory of so many frames that are made as above.
std::size_t MemoryOf(std::size_t frames) {
  return frames * FrameStore::CostOf(Make(FrameType::kEvents, 0));
}

TEST(FrameStore, CountsWhatAFrameTakesNotOnlyItsBytes) {
  const StoredFrame small = Make(FrameType::kEvents, 0, "x");
  const StoredFrame large = Make(FrameType::kEvents, 0, std::string(100, 'x'));
  EXPECT_EQ(FrameStore::CostOf(small), sizeof(StoredFrame));
  EXPECT_EQ(FrameStore::CostOf(large), sizeof(StoredFrame) + 112);
}

TEST(FrameStore, NumbersFramesAndKnowsWhereReadingCanBegin) {
  FrameStore store(MemoryOf(100));
  store.Add(Make(FrameType::kTree, 0, "tree"));
  EXPECT_FALSE(store.has_entry());
  store.Add(Make(FrameType::kState, 0));
  store.Add(Make(FrameType::kEvents, 5));
  store.Add(Make(FrameType::kState, 5));
  EXPECT_TRUE(store.has_entry());
  EXPECT_EQ(store.first(), 0u);
  EXPECT_EQ(store.next(), 4u);
  EXPECT_EQ(store.oldest_state(), 1u);
  EXPECT_EQ(store.youngest_state(), 3u);
  EXPECT_EQ(store.TreeAt(store.youngest_state()).bytes, "tree");
  EXPECT_EQ(store[2].tick, 5u);
}

TEST(FrameStore, DropsTheOldestUpToAState) {
  FrameStore store(MemoryOf(6));
  store.Add(Make(FrameType::kTree, 0));
  store.Add(Make(FrameType::kState, 0));
  for (std::uint64_t tick = 1; tick <= 3; ++tick) store.Add(Make(FrameType::kEvents, tick));
  store.Add(Make(FrameType::kState, 3));  // number 5
  EXPECT_EQ(store.first(), 0u);
  store.Add(Make(FrameType::kEvents, 4));
  EXPECT_EQ(store.first(), 5u);
  EXPECT_EQ(store.oldest_state(), 5u);
  EXPECT_EQ(store.next(), 7u);
}

TEST(FrameStore, KeepsTheYoungestStateWhateverTheLimit) {
  FrameStore store(0);
  store.Add(Make(FrameType::kTree, 0));
  store.Add(Make(FrameType::kState, 0));
  for (std::uint64_t tick = 1; tick <= 100; ++tick) store.Add(Make(FrameType::kEvents, tick));
  EXPECT_EQ(store.oldest_state(), 1u);
  store.Add(Make(FrameType::kState, 100));
  EXPECT_EQ(store.first(), 102u);
}

TEST(FrameStore, RemembersTheTreeOfEachState) {
  FrameStore store(MemoryOf(5));
  store.Add(Make(FrameType::kTree, 0, "first"));
  store.Add(Make(FrameType::kState, 0));
  store.Add(Make(FrameType::kTree, 1, "second"));
  store.Add(Make(FrameType::kState, 1));
  EXPECT_EQ(store.TreeAt(store.oldest_state()).bytes, "first");
  EXPECT_EQ(store.TreeAt(store.youngest_state()).bytes, "second");
  store.Add(Make(FrameType::kEvents, 2, std::string(80, 'x')));
  EXPECT_EQ(store.TreeAt(store.oldest_state()).bytes, "second");
  store.Add(Make(FrameType::kTree, 2, "third"));
  EXPECT_EQ(store.TreeAt(store.oldest_state()).bytes, "second");
}

}  // namespace
}  // namespace coppice
