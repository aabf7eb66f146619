#include "bt_core/engine/events/word_ring.h"

#include <gtest/gtest.h>

#include <thread>

namespace coppice {
namespace {

using Words = std::vector<std::uint32_t>;

TEST(WordRing, GivesBackWhatWasPushedInItsOrder) {
  WordRing ring(5);
  const Words words{1, 2, 3};
  Words out;
  for (int round = 0; round < 10; ++round) {  // around the end of the ring
    ring.Push(words.data(), words.size());
    EXPECT_EQ(ring.room(), 5U);
    ring.Publish();
    EXPECT_EQ(ring.room(), 2U);
    ring.PopAll(out);
    EXPECT_EQ(out, words);
  }
  EXPECT_EQ(ring.published(), 30U);
}

TEST(WordRing, WhatIsNotPublishedIsNotSeen) {
  WordRing ring(4);
  const std::uint32_t word = 7;
  ring.Push(&word, 1);
  Words out;
  ring.PopAll(out);
  EXPECT_TRUE(out.empty());
  ring.Publish();
  ring.PopAll(out);
  EXPECT_EQ(out, Words{7});
}

TEST(WordRing, TwoThreadsLoseNothing) {
  constexpr std::uint32_t kCount = 200000;
  WordRing ring(64);
  std::thread writer([&ring] {
    for (std::uint32_t i = 0; i < kCount;) {
      if (ring.room() == 0) {
        std::this_thread::yield();
        continue;
      }
      ring.Push(&i, 1);
      ring.Publish();
      ++i;
    }
  });
  Words out;
  std::uint32_t expected = 0;
  while (expected < kCount) {
    ring.PopAll(out);
    if (out.empty()) std::this_thread::yield();
    for (const std::uint32_t word : out) ASSERT_EQ(word, expected++);
  }
  writer.join();
}

}  // namespace
}  // namespace coppice
