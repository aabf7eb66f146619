#include "bt_core/frames/frame.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

Bytes OneFrame() {
  Bytes bytes = {'x'};  // something before it
  const std::size_t frame = OpenFrame(bytes, FrameType::kNote);
  Encoder(bytes).Text("payload");
  CloseFrame(bytes, frame);
  EXPECT_EQ(SealFrame(bytes.data() + frame), bytes.size() - frame);
  bytes.erase(bytes.begin());
  return bytes;
}

TEST(Frame, KnowsSizeTypeAndChecksum) {
  const Bytes bytes = OneFrame();
  const FrameHeader header = ReadFrameHeader(bytes.data());
  EXPECT_EQ(header.payload_size, 8u);
  EXPECT_EQ(header.type, static_cast<std::uint8_t>(FrameType::kNote));
  EXPECT_TRUE(IsPlausible(header));
  EXPECT_TRUE(IsWhole(bytes.data(), header));
}

TEST(Frame, NoticesEveryFlippedBit) {
  const Bytes good = OneFrame();
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    Bytes bytes = good;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    const FrameHeader header = ReadFrameHeader(bytes.data());
    const bool fits = kFrameHeaderSize + header.payload_size <= bytes.size();
    EXPECT_FALSE(fits && IsPlausible(header) && IsWhole(bytes.data(), header)) << "bit " << bit;
  }
}

TEST(Frame, IsNotPlausibleWithAnUnknownTypeOrSize) {
  EXPECT_FALSE(IsPlausible({0, 0, 0}));
  EXPECT_FALSE(IsPlausible({0, 7, 0}));
  EXPECT_FALSE(IsPlausible({kMaxPayloadSize + 1, 2, 0}));
}

TEST(Frame, BeginsTheFileWithMagicBytesAndVersion) {
  Bytes bytes;
  AppendPreamble(bytes);
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), std::string("\x89"
                                                                 "Coppic\n\x02\0\0\0",
                                                                 12));
}

}  // namespace
}  // namespace coppice
