#include "bt_core/live/zmtp/zmtp_frames.h"

#include <gtest/gtest.h>

namespace coppice::zmtp {
namespace {

using Result = FrameReader::Result;

TEST(ZmtpFrames, GreetsAsLibzmqDoes) {
  const std::string greeting = MakeGreeting("CURVE");
  EXPECT_EQ(greeting.size(), kGreetingSize);
  EXPECT_TRUE(IsGreetingOf(greeting, "CURVE"));
  EXPECT_FALSE(IsGreetingOf(greeting, "NULL"));
  std::string old = greeting;
  old[10] = 1;
  EXPECT_FALSE(IsGreetingOf(old, "CURVE"));
  EXPECT_FALSE(IsGreetingOf(std::string(kGreetingSize, 'x'), "CURVE"));
}

TEST(ZmtpFrames, AreReadAsTheyWereWrittenAlsoByteByByte) {
  std::string bytes;
  AppendFrame(kMore, "", bytes);
  AppendFrame(0, std::string(300, 'x'), bytes);
  FrameReader reader;
  std::uint8_t flags = 0;
  std::string body;
  std::string read;
  for (const char byte : bytes) {
    reader.Append({&byte, 1});
    while (reader.TakeFrame(300, flags, body) == Result::kDone) {
      read += std::to_string(flags) + ":" + std::to_string(body.size()) + " ";
    }
  }
  EXPECT_EQ(read, "1:0 2:300 ");
}

TEST(ZmtpFrames, RefuseALongOneBeforeItIsThere) {
  FrameReader reader;
  reader.Append(std::string_view("\2\0\0\0\0\0\1\0\0", 9));
  std::uint8_t flags = 0;
  std::string body;
  EXPECT_EQ(reader.TakeFrame(65535, flags, body), Result::kTooLarge);
  EXPECT_EQ(reader.TakeFrame(65536, flags, body), Result::kIncomplete);
}

TEST(ZmtpFrames, FindPropertiesAndNamesOfCommands) {
  std::string properties;
  AppendProperty("Identity", std::string("\0web1", 5), properties);
  AppendProperty("Socket-Type", "REQ", properties);
  const std::string command = MakeCommand("READY", properties);
  std::string_view body = command;
  EXPECT_EQ(TakeName(body), "READY");
  EXPECT_EQ(FindProperty(body, "Socket-Type"), "REQ");
  EXPECT_EQ(FindProperty(body, "Identity").size(), 5u);
  EXPECT_EQ(FindProperty(body, "Colour"), "");
  EXPECT_EQ(FindProperty(body.substr(0, body.size() - 1), "Socket-Type"), "");
  EXPECT_EQ(FindProperty("\xff", "Socket-Type"), "");
  body = "\x50READY";
  EXPECT_EQ(TakeName(body), "");
}

}  // namespace
}  // namespace coppice::zmtp
