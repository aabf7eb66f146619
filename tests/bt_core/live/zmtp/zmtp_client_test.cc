#include "bt_core/live/zmtp/zmtp_client.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bt_core/live/zmtp/zmtp_peer.h"

namespace coppice::zmtp {
namespace {

using ::testing::ElementsAre;
using Step = ZmtpStream::Step;

constexpr std::size_t kLimit = 1000;
constexpr const char* kToken = "a token for tests";

std::string Frame(std::uint8_t flags, std::string_view body) {
  std::string bytes;
  AppendFrame(flags, body, bytes);
  return bytes;
}

std::string Greeting(const std::string& type) {
  std::string properties;
  AppendProperty("Socket-Type", type, properties);
  return MakeGreeting("NULL") + Frame(kCommand, MakeCommand("READY", properties));
}

Step Hear(ZmtpStream& end, const std::string& bytes) {
  groot2::Parts message;
  end.Receive(bytes);
  return end.Next(message);
}

// Hands over what both ends say until nobody says anything.
void Talk(ZmtpStream& client, ZmtpStream& robot) {
  for (int i = 0; i < 5; ++i) {
    Hear(robot, client.TakeOutput());
    Hear(client, robot.TakeOutput());
  }
}

TEST(ZmtpClient, OpensToARobot) {
  ZmtpClient client(ZmtpClient::Type::kDealer, nullptr, kLimit);
  ZmtpPeer robot(ZmtpPeer::Type::kRouter, nullptr, kLimit);
  Talk(client, robot);
  EXPECT_TRUE(client.is_open());
  EXPECT_TRUE(robot.is_open());
}

TEST(ZmtpClient, SpeaksEncryptedWithARobotOfItsToken) {
  const RobotKeys keys = KeysOfRobot(kToken);
  const WatcherKeys watcher = KeysOfWatcher(keys.read_token);
  ZmtpClient client(ZmtpClient::Type::kDealer, &watcher, kLimit);
  ZmtpPeer robot(ZmtpPeer::Type::kRouter, &keys, kLimit);
  Talk(client, robot);
  ASSERT_TRUE(client.is_open());
  EXPECT_FALSE(robot.may_control());
  const std::string secret = robot.Encode({"", "secret"});
  EXPECT_EQ(secret.find("secret"), std::string::npos);
  groot2::Parts message;
  client.Receive(secret);
  EXPECT_EQ(client.Next(message), Step::kMessage);
  EXPECT_THAT(message, ElementsAre("", "secret"));
  EXPECT_EQ(Hear(client, secret), Step::kRefused) << "nothing can be said twice";
}

TEST(ZmtpClient, DoesNotOpenToARobotOfAnotherToken) {
  const RobotKeys keys = KeysOfRobot("the token of others");
  const WatcherKeys watcher = KeysOfWatcher(kToken);
  ZmtpClient client(ZmtpClient::Type::kDealer, &watcher, kLimit);
  ZmtpPeer robot(ZmtpPeer::Type::kRouter, &keys, kLimit);
  Talk(client, robot);
  EXPECT_FALSE(client.is_open());
  EXPECT_FALSE(robot.is_open());
}

TEST(ZmtpClient, DoesNotOpenToWhoOnlyPretendsToBeTheRobot) {
  const WatcherKeys watcher = KeysOfWatcher(kToken);
  ZmtpClient client(ZmtpClient::Type::kDealer, &watcher, kLimit);
  EXPECT_EQ(Hear(client, MakeGreeting("CURVE", true)), Step::kIncomplete);
  EXPECT_EQ(Hear(client, Frame(kCommand, MakeCommand("WELCOME", std::string(160, 'w')))),
            Step::kRefused);
}

TEST(ZmtpClient, RefusesAnErrorOtherSocketsAndGarbage) {
  for (const std::string& said :
       {Greeting("SUB"), MakeGreeting("NULL") + Frame(kCommand, MakeCommand("ERROR", "\3400")),
        MakeGreeting("CURVE"), std::string("HTTP/1.1 400 Bad Request") + std::string(64, ' ')}) {
    ZmtpClient client(ZmtpClient::Type::kDealer, nullptr, kLimit);
    EXPECT_EQ(Hear(client, said), Step::kRefused);
    EXPECT_FALSE(client.is_open());
  }
}

TEST(ZmtpClient, RefusesAMessageOfEverMoreParts) {
  ZmtpClient client(ZmtpClient::Type::kDealer, nullptr, kLimit);
  Step step = Hear(client, Greeting("ROUTER"));
  int parts = 0;
  while (step == Step::kIncomplete && parts < 1000) {
    step = Hear(client, Frame(kMore, ""));
    ++parts;
  }
  EXPECT_EQ(step, Step::kRefused);
  EXPECT_LE(parts, 9);
}

TEST(ZmtpClient, RefusesAMessageThatIsTooLongAsSoonAsItIsAnnounced) {
  ZmtpClient client(ZmtpClient::Type::kDealer, nullptr, kLimit);
  EXPECT_EQ(Hear(client, Greeting("ROUTER")), Step::kIncomplete);
  EXPECT_EQ(Hear(client, Frame(kMore, std::string(600, 'x'))), Step::kIncomplete);
  EXPECT_EQ(Hear(client, Frame(0, std::string(600, 'x')).substr(0, 9)), Step::kRefused);
}

TEST(ZmtpClient, SubscribesToEverything) {
  ZmtpClient client(ZmtpClient::Type::kListener, nullptr, kLimit);
  EXPECT_EQ(Hear(client, Greeting("PUB")), Step::kIncomplete);
  const std::string output = client.TakeOutput();
  EXPECT_EQ(output.substr(output.size() - 3), Frame(0, "\1"));
}

}  // namespace
}  // namespace coppice::zmtp
