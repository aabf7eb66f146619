#include "bt_core/live/zmtp/zmtp_peer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice::zmtp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Step = ZmtpPeer::Step;

constexpr std::size_t kLimit = 1000;

std::string Frame(std::uint8_t flags, std::string_view body) {
  std::string bytes;
  AppendFrame(flags, body, bytes);
  return bytes;
}

std::string Hello(const std::string& type, const std::string& identity = {}) {
  std::string properties;
  AppendProperty("Socket-Type", type, properties);
  AppendProperty("Identity", identity, properties);
  return MakeGreeting("NULL") + Frame(kCommand, MakeCommand("READY", properties));
}

class ZmtpPeerTest : public ::testing::Test {
 protected:
  Step Say(const std::string& bytes) {
    peer_.Receive(bytes);
    return peer_.Next(message_);
  }

  ZmtpPeer peer_{ZmtpPeer::Type::kRouter, nullptr, kLimit};
  groot2::Parts message_;
};

TEST_F(ZmtpPeerTest, OpensAndAnswersWithoutTheNameThatTheClientGivesItself) {
  EXPECT_EQ(Say(Hello("DEALER", std::string("\0web1", 5))), Step::kIncomplete);
  EXPECT_TRUE(peer_.is_open());
  EXPECT_TRUE(peer_.may_control());
  const std::string output = peer_.TakeOutput();
  EXPECT_THAT(output, HasSubstr("READY"));
  EXPECT_EQ(output.find("web1"), std::string::npos);
}

TEST_F(ZmtpPeerTest, PutsMessagesTogetherAlsoByteByByte) {
  for (const char byte : Hello("REQ") + Frame(kMore, "") + Frame(0, "x")) {
    const Step step = Say(std::string(1, byte));
    if (step == Step::kMessage) break;
    ASSERT_EQ(step, Step::kIncomplete);
  }
  EXPECT_THAT(message_, ElementsAre("", "x"));
}

TEST_F(ZmtpPeerTest, RefusesOtherVersionsMechanismsAndSockets) {
  EXPECT_EQ(Say(std::string(64, 'x')), Step::kRefused);
  ZmtpPeer other(ZmtpPeer::Type::kRouter, nullptr, kLimit);
  other.Receive(MakeGreeting("CURVE"));
  EXPECT_EQ(other.Next(message_), Step::kRefused);
  ZmtpPeer third(ZmtpPeer::Type::kRouter, nullptr, kLimit);
  third.Receive(Hello("SUB"));
  EXPECT_EQ(third.Next(message_), Step::kRefused);
}

TEST_F(ZmtpPeerTest, RefusesAMessageOfEverMoreParts) {
  Say(Hello("DEALER"));
  Step step = Step::kIncomplete;
  int parts = 0;
  while (step == Step::kIncomplete && parts < 1000) {
    step = Say(Frame(kMore, "x"));
    ++parts;
  }
  EXPECT_EQ(step, Step::kRefused);
  EXPECT_LE(parts, 9);
}

TEST_F(ZmtpPeerTest, RefusesAMessageThatIsLongInAll) {
  Say(Hello("DEALER"));
  EXPECT_EQ(Say(Frame(kMore, std::string(600, 'x'))), Step::kIncomplete);
  EXPECT_EQ(Say(Frame(0, std::string(600, 'x'))), Step::kRefused);
}

TEST_F(ZmtpPeerTest, TakesTheLongestMessageAndThenTheNext) {
  Say(Hello("DEALER"));
  EXPECT_EQ(Say(Frame(kMore, "") + Frame(0, std::string(kLimit, 'x'))), Step::kMessage);
  EXPECT_EQ(Say(Frame(kMore, "") + Frame(0, std::string(kLimit, 'x'))), Step::kMessage);
}

TEST_F(ZmtpPeerTest, RefusesALongHandshake) {
  EXPECT_EQ(Say(MakeGreeting("NULL") + std::string("\6\0\0\0\0\0\1\0\0", 9)), Step::kRefused);
}

TEST_F(ZmtpPeerTest, SaysPongWithoutRepeatingAllThatItIsTold) {
  Say(Hello("DEALER"));
  peer_.TakeOutput();
  Say(Frame(kCommand, MakeCommand("PING", std::string("\0\1", 2) + std::string(200, 'c'))));
  EXPECT_EQ(peer_.TakeOutput(), Frame(kCommand, MakeCommand("PONG", std::string(16, 'c'))));
  for (int i = 0; i < 10000; ++i) {
    Say(Frame(kCommand, MakeCommand("PING", std::string("\0\1abc", 5))));
  }
  EXPECT_LE(peer_.TakeOutput().size(), 5000u);
}

}  // namespace
}  // namespace coppice::zmtp
