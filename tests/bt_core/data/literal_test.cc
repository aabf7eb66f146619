#include "bt_core/data/literal.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace coppice {
namespace {

TEST(GuessValue, WholeNumbersAreInt64) {
  for (const char* text : {"0", "42", "-7", "9000000000"}) {
    ASSERT_TRUE(GuessValue(text).Is<std::int64_t>()) << text;
    EXPECT_EQ(GuessValue(text).Print(), text);
  }
}

TEST(GuessValue, OtherNumbersAreDouble) {
  EXPECT_EQ(GuessValue("0.5").Get<double>(), 0.5);
  EXPECT_EQ(GuessValue("-1e3").Get<double>(), -1000);
  EXPECT_TRUE(GuessValue("99999999999999999999").Is<double>());
}

TEST(GuessValue, WhatANumberWouldNotGiveBackStaysText) {
  for (const char* text :
       {"", "00042", "-007", "1;2", "+1", " 1", "12abc", "0x1F", "inf", "nan", "-", ".5", "true"}) {
    ASSERT_TRUE(GuessValue(text).Is<std::string>()) << text;
    EXPECT_EQ(GuessValue(text).Print(), text);
  }
}

}  // namespace
}  // namespace coppice
