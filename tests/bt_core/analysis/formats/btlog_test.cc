#include "bt_core/analysis/formats/btlog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice {
namespace {

using ::testing::HasSubstr;

constexpr std::int64_t kStart = 1'700'000'000'000'000;  // 2023

Btlog SomeLog() {
  return {"<root/>",
          {{kStart, 1, Status::kRunning},
           {kStart + 0x123456789AB, 65535, Status::kSkipped},
           {kStart + 2, 258, Status::kIdle}}};
}

class BtlogTest : public testing::Test {
 protected:
  std::optional<Btlog> Read(std::string_view bytes) {
    return ReadBtlog(bytes, "a.btlog", diagnostics_);
  }
  std::string Problem(std::string_view bytes) {
    diagnostics_ = {};
    EXPECT_FALSE(Read(bytes));
    return diagnostics_.ToString();
  }

  const std::string bytes_ = WriteBtlog(SomeLog());
  Diagnostics diagnostics_;
};

TEST_F(BtlogTest, HasItsBytesInLittleEndian) {
  EXPECT_EQ(bytes_.substr(0, 23), std::string("BTCPP4-FileLogger2\x01\x07\0\0\0", 23));
  EXPECT_EQ(bytes_.substr(23, 7), "<root/>");
  EXPECT_EQ(bytes_.size(), 23U + 7 + 8 + 3 * 9);
  EXPECT_EQ(bytes_.substr(38, 9), std::string("\0\0\0\0\0\0\x01\0\x01", 9));
  EXPECT_EQ(bytes_.substr(47, 9), std::string("\xAB\x89\x67\x45\x23\x01\xFF\xFF\x04", 9));
}

TEST_F(BtlogTest, IsReadAsItWasWritten) {
  const auto log = Read(bytes_);
  ASSERT_TRUE(log) << diagnostics_.ToString();
  EXPECT_EQ(log->xml, "<root/>");
  ASSERT_EQ(log->transitions.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(log->transitions[i].time, SomeLog().transitions[i].time);
    EXPECT_EQ(log->transitions[i].uid, SomeLog().transitions[i].uid);
    EXPECT_EQ(log->transitions[i].status, SomeLog().transitions[i].status);
  }
  EXPECT_TRUE(diagnostics_.all().empty());
  EXPECT_TRUE(Read(WriteBtlog({"", {}}))->transitions.empty());
}

TEST_F(BtlogTest, CutOffItIsReadUpToItsLastWholeTransition) {
  const auto log = Read(bytes_.substr(0, bytes_.size() - 1));
  ASSERT_TRUE(log);
  EXPECT_EQ(log->transitions.size(), 2U);
  EXPECT_FALSE(diagnostics_.has_errors());
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("cut off within its last transition"));
}

TEST_F(BtlogTest, WhatIsNoLogIsSaid) {
  EXPECT_THAT(Problem(""), HasSubstr("a.btlog: error: is no log"));
  EXPECT_THAT(Problem("BTCPP4-FileLogger3" + bytes_.substr(18)), HasSubstr("is no log"));
  std::string newer = bytes_;
  newer[18] = 2;
  EXPECT_THAT(Problem(newer), HasSubstr("version 2, expected 1"));
  for (std::size_t size = 23; size < 38; ++size) {
    EXPECT_THAT(Problem(bytes_.substr(0, size)), HasSubstr("ends within the XML")) << size;
  }
  std::string huge = bytes_;
  huge.replace(19, 4, "\xFF\xFF\xFF\xFF");
  EXPECT_THAT(Problem(huge), HasSubstr("ends within the XML"));
}

TEST_F(BtlogTest, TimesAndStatusesThatMakeNoSenseAreRefused) {
  std::string before_1970 = bytes_;
  before_1970[37] = '\x80';
  EXPECT_THAT(Problem(before_1970), HasSubstr("a time that makes no sense: -"));
  std::string far = bytes_;
  far[37] = '\x7F';
  EXPECT_THAT(Problem(far), HasSubstr("a time that makes no sense: 9"));
  std::string status = bytes_;
  status[46] = 5;
  EXPECT_THAT(Problem(status), HasSubstr("a transition to status 5"));
}

}  // namespace
}  // namespace coppice
