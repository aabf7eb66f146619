#include "bt_core/base/hex.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Hex, HasTwoDigitsForEachByte) {
  EXPECT_EQ(ToHex(std::vector<std::uint8_t>{0x00, 0x0f, 0xa5, 0xff}), "000fa5ff");
  EXPECT_EQ(ToHex(std::string("\xff\x01", 2)), "ff01");
  EXPECT_EQ(ToHex(std::string()), "");
}

TEST(Hex, IsReadBack) {
  EXPECT_THAT(FromHex("000fa5ff"), ElementsAre(0x00, 0x0f, 0xa5, 0xff));
  EXPECT_THAT(FromHex(""), IsEmpty());
}

TEST(Hex, WhatIsNoneReadsAsNothing) {
  for (const char* const text : {"0", "0ff", "0g", "FF", " 0", "0x"}) {
    EXPECT_THAT(FromHex(text), IsEmpty()) << text;
  }
}

}  // namespace
}  // namespace coppice
