#include "bt_core/record/byte_ring.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <thread>

namespace coppice {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(ByteRing, TakesAllOrNothing) {
  ByteRing ring(8);
  const Bytes five(5, 1);
  EXPECT_TRUE(ring.Push(five.data(), 5));
  EXPECT_FALSE(ring.Push(five.data(), 5));
  EXPECT_TRUE(ring.Push(five.data(), 3));
  EXPECT_EQ(ring.size(), 8u);
  Bytes out;
  ring.PopAll(out);
  EXPECT_EQ(out, Bytes(8, 1));
  EXPECT_EQ(ring.size(), 0u);
  EXPECT_FALSE(ring.Push(five.data(), 9));
}

TEST(ByteRing, KeepsTheOrderAroundItsEnd) {
  ByteRing ring(7);
  Bytes in(5);
  for (std::uint8_t round = 0; round < 50; ++round) {
    std::iota(in.begin(), in.end(), round);
    ASSERT_TRUE(ring.Push(in.data(), in.size()));
    Bytes out;
    ring.PopAll(out);
    EXPECT_EQ(out, in);
  }
}

TEST(ByteRing, BringsEveryByteToTheOtherThread) {
  ByteRing ring(1000);
  std::thread writer([&] {
    std::mt19937 random(5);
    std::uint8_t next = 0;
    for (int sent = 0; sent < 3000;) {
      Bytes bytes(random() % 100);
      for (std::uint8_t& byte : bytes) byte = next++;
      while (!ring.Push(bytes.data(), bytes.size())) std::this_thread::yield();
      ++sent;
    }
    const std::uint8_t end[2] = {next, next};  // twice the same
    while (!ring.Push(end, 2)) std::this_thread::yield();
  });
  Bytes out;
  while (out.size() < 2 || out.back() != out[out.size() - 2]) {
    ring.PopAll(out);
    std::this_thread::yield();
  }
  writer.join();
  for (std::size_t i = 0; i + 1 < out.size(); ++i) {
    ASSERT_EQ(out[i], static_cast<std::uint8_t>(i));
  }
}

}  // namespace
}  // namespace coppice
