#include "bt_core/frames/coding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace coppice {
namespace {

using ::testing::ElementsAre;

Decoder Read(const Bytes& bytes) { return {bytes.data(), bytes.data() + bytes.size()}; }

TEST(Coding, WritesNumbersAsDocumented) {
  Bytes bytes;
  Encoder out(bytes);
  out.Unsigned(300);
  out.Signed(-2);
  out.Fixed32(0x01020304);
  out.Text("ab");
  EXPECT_THAT(bytes, ElementsAre(0xac, 0x02, 0x03, 4, 3, 2, 1, 2, 'a', 'b'));
}

TEST(Coding, ReadsBackTheLimitsOfAllTypes) {
  Bytes bytes;
  Encoder out(bytes);
  out.Unsigned(UINT64_MAX);
  out.Signed(INT64_MIN);
  out.Signed(INT64_MAX);
  out.Double(std::numeric_limits<double>::denorm_min());
  out.Double(std::numeric_limits<double>::quiet_NaN());
  out.At(kNever);
  Decoder in = Read(bytes);
  EXPECT_EQ(in.Unsigned(), UINT64_MAX);
  EXPECT_EQ(in.Signed(), INT64_MIN);
  EXPECT_EQ(in.Signed(), INT64_MAX);
  EXPECT_EQ(in.Double(), std::numeric_limits<double>::denorm_min());
  EXPECT_TRUE(std::isnan(in.Double()));
  EXPECT_EQ(in.At(), kNever);
  EXPECT_TRUE(in.ok() && in.at_end());
}

TEST(Coding, ReadsBackRandomNumbers) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) {
    const std::uint64_t number = random() >> random() % 64;
    const auto signed_number = static_cast<std::int64_t>(random()) >> random() % 64;
    Bytes bytes;
    Encoder out(bytes);
    out.Unsigned(number);
    out.Signed(signed_number);
    Decoder in = Read(bytes);
    EXPECT_EQ(in.Unsigned(), number);
    EXPECT_EQ(in.Signed(), signed_number);
    EXPECT_TRUE(in.ok() && in.at_end());
  }
}

TEST(Coding, NeverReadsPastTheEnd) {
  const Bytes endless(20, 0xff);
  const Bytes short_text = {5, 'a'};
  const Bytes two = {1, 2};
  const auto fails = [](const Bytes& bytes, auto read) {
    Decoder in = Read(bytes);
    read(in);
    return !in.ok() && in.at_end();
  };
  EXPECT_TRUE(fails(endless, [](Decoder& in) { in.Unsigned(); }));
  EXPECT_TRUE(fails(short_text, [](Decoder& in) { EXPECT_EQ(in.Text(), ""); }));
  EXPECT_TRUE(fails(short_text, [](Decoder& in) { EXPECT_EQ(in.Count(), 0u); }));
  EXPECT_TRUE(fails(short_text, [](Decoder& in) { EXPECT_EQ(in.Index(5), 0u); }));
  EXPECT_TRUE(fails(two, [](Decoder& in) { EXPECT_EQ(in.Fixed32(), 0u); }));
  EXPECT_TRUE(fails(two, [](Decoder& in) { EXPECT_EQ(in.Double(), 0); }));
  EXPECT_TRUE(fails({}, [](Decoder& in) { EXPECT_EQ(in.Byte(), 0); }));
}

}  // namespace
}  // namespace coppice
