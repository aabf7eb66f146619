#include "bt_core/live/zmtp/zmtp_gateway.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "bt_core/live/zmtp/zmtp_frames.h"
#include "tests/bt_core/live/live_client.h"
#include "tests/bt_core/live/web_caller.h"
#include "tests/bt_core/live/zmtp/live_door.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string WhyNot(const std::string& address, std::uint16_t port) {
  try {
    LiveClients clients([] {});
    const ZmtpGateway gateway(address, port, {}, clients);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(ZmtpGateway, TakesAFreePair) {
  const LiveDoor first;
  const LiveDoor second;
  EXPECT_GT(first.gateway.port(), 0);
  EXPECT_NE(first.gateway.port(), second.gateway.port());
}

TEST(ZmtpGateway, SaysThatAPortIsInUseAndWhatToDo) {
  const LiveDoor first;
  const std::string port = std::to_string(first.gateway.port());
  EXPECT_EQ(WhyNot("127.0.0.1", first.gateway.port()),
            "live view: port 127.0.0.1:" + port +
                " is in use; end the program that has it or choose another port (each tree needs "
                "two neighbouring ones, for example 1669 and 1670)");
}

TEST(ZmtpGateway, NeedsTheSecondPortToo) {
  const LiveDoor first;
  const std::string why = WhyNot("127.0.0.1", static_cast<std::uint16_t>(first.gateway.port() - 1));
  EXPECT_THAT(why, HasSubstr("127.0.0.1:"));
  EXPECT_THAT(why, HasSubstr("is in use"));
}

TEST(ZmtpGateway, RefusesWhatIsNoAddress) {
  EXPECT_THAT(WhyNot("no such place", 1667), HasSubstr("cannot listen on no such place:1667"));
  EXPECT_THAT(WhyNot("127.0.0.1", 65535), HasSubstr("no neighbour"));
}

TEST(ZmtpGateway, FreesThePortsWhenItEnds) {
  std::uint16_t port = 0;
  {
    const LiveDoor door;
    port = door.gateway.port();
  }
  EXPECT_EQ(WhyNot("127.0.0.1", port), "");
}

class ConnectedGatewayTest : public ::testing::Test {
 protected:
  LiveDoor door_;
  SocketClient client_{zmq::socket_type::dealer, door_.gateway.port()};
};

TEST_F(ConnectedGatewayTest, AnswersTheClientThatAsked) {
  client_.Send({"", "hello", "there"});
  const auto request = door_.Receive();
  ASSERT_TRUE(request);
  EXPECT_THAT(request->parts, ElementsAre("hello", "there"));
  EXPECT_TRUE(request->may_control);
  EXPECT_EQ(door_.clients.Reply(request->client, {"welcome"}), SendResult::kSent);
  EXPECT_THAT(client_.Receive(), ElementsAre("", "welcome"));
}

TEST_F(ConnectedGatewayTest, PassesOverWhatHasNoEnvelope) {
  client_.Send({"no", "envelope"});
  client_.Send({"alone"});
  client_.Send({"", "good"});
  EXPECT_THAT(door_.Receive()->parts, ElementsAre("good"));
}

TEST_F(ConnectedGatewayTest, TakesTheNextRequestWhenThisOneWasTaken) {
  for (const char* text : {"1", "2", "3"}) client_.Send({"", text});
  for (const char* text : {"1", "2", "3"}) {
    EXPECT_THAT(door_.Receive()->parts, ElementsAre(text));
  }
}

TEST_F(ConnectedGatewayTest, SaysByeForAClientThatHasGone) {
  ClientId gone{};
  {
    SocketClient other(zmq::socket_type::req, door_.gateway.port());
    other.Send({"x"});
    gone = door_.Receive()->client;
  }
  const auto bye = door_.Receive();
  ASSERT_TRUE(bye);
  EXPECT_EQ(bye->client, gone);
  EXPECT_THAT(bye->parts, ElementsAre(::testing::_, HasSubstr("bye")));
}

TEST_F(ConnectedGatewayTest, TellsClientsWithTheSameIdentityApart) {
  SocketClient first(zmq::socket_type::req, door_.gateway.port(), {}, "same");
  SocketClient second(zmq::socket_type::req, door_.gateway.port(), {}, "same");
  first.Send({"1"});
  const auto of_first = door_.Receive();
  second.Send({"2"});
  const auto of_second = door_.Receive();
  ASSERT_TRUE(of_first && of_second);
  EXPECT_NE(of_first->client, of_second->client);
  door_.clients.Reply(of_second->client, {"two"});
  door_.clients.Reply(of_first->client, {"one"});
  EXPECT_THAT(first.Receive(), ElementsAre("one"));
  EXPECT_THAT(second.Receive(), ElementsAre("two"));
}

TEST_F(ConnectedGatewayTest, HangsUpOnAMessageThatIsTooLongAndServesOthers) {
  WebCaller stranger(door_.gateway.port());
  std::string properties;
  zmtp::AppendProperty("Socket-Type", "DEALER", properties);
  std::string bytes = zmtp::MakeGreeting("NULL");
  zmtp::AppendFrame(zmtp::kCommand, zmtp::MakeCommand("READY", properties), bytes);
  zmtp::AppendFrame(zmtp::kMore, "", bytes);
  for (int i = 0; i < 100; ++i) zmtp::AppendFrame(zmtp::kMore, "x", bytes);
  stranger.Say(bytes);
  EXPECT_THAT(stranger.Rest(), HasSubstr("READY"));
  client_.Send({"", "good"});
  auto request = door_.Receive();
  if (request && request->parts.size() == 2) request = door_.Receive();  // the stranger's bye
  EXPECT_THAT(request->parts, ElementsAre("good"));
}

TEST_F(ConnectedGatewayTest, SilentStrangersGiveWayToClients) {
  std::vector<std::unique_ptr<WebCaller>> strangers;
  for (std::size_t i = 0; i < 2 * ZmtpGateway::kMaxConnections; ++i) {
    strangers.push_back(std::make_unique<WebCaller>(door_.gateway.port()));
  }
  SocketClient late(zmq::socket_type::req, door_.gateway.port());
  late.Send({"x"});
  EXPECT_TRUE(door_.Receive());
}

TEST_F(ConnectedGatewayTest, SendsWhatIsLeftBeforeItEnds) {
  client_.Send({"", "x"});
  const auto request = door_.Receive();
  ASSERT_TRUE(request);
  door_.clients.Reply(request->client, {"the last"});
  door_.gateway.Stop();
  EXPECT_THAT(client_.Receive(), ElementsAre("", "the last"));
}

}  // namespace
}  // namespace coppice
