#include "bt_core/live/server/live_sockets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <stdexcept>

namespace coppice {
namespace {

using ::testing::HasSubstr;

std::string WhyNot(const std::string& address, std::uint16_t port) {
  try {
    const LiveSockets sockets(address, port);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(LiveSockets, TakesAFreePair) {
  const LiveSockets first("127.0.0.1", 0);
  const LiveSockets second("127.0.0.1", 0);
  EXPECT_GT(first.port(), 0);
  EXPECT_NE(first.port(), second.port());
}

TEST(LiveSockets, SaysThatAPortIsInUseAndWhatToDo) {
  const LiveSockets first("127.0.0.1", 0);
  const std::string port = std::to_string(first.port());
  EXPECT_EQ(WhyNot("127.0.0.1", first.port()),
            "live view: port 127.0.0.1:" + port +
                " is in use; end the program that has it or choose another port (each tree needs "
                "two neighbouring ones, for example 1669 and 1670)");
}

TEST(LiveSockets, NeedsTheSecondPortToo) {
  const LiveSockets first("127.0.0.1", 0);
  const std::string why = WhyNot("127.0.0.1", static_cast<std::uint16_t>(first.port() - 1));
  EXPECT_THAT(why, HasSubstr("127.0.0.1:"));
  EXPECT_THAT(why, HasSubstr("is in use"));
}

TEST(LiveSockets, RefusesWhatIsNoAddress) {
  EXPECT_THAT(WhyNot("no such place", 1667), HasSubstr("cannot listen on no such place:1667"));
  EXPECT_THAT(WhyNot("127.0.0.1", 65535), HasSubstr("no neighbour"));
}

TEST(LiveSockets, FreesThePortsWhenItEnds) {
  std::uint16_t port = 0;
  {
    const LiveSockets sockets("127.0.0.1", 0);
    port = sockets.port();
  }
  EXPECT_EQ(WhyNot("127.0.0.1", port), "");
}

TEST(LiveSockets, WakeEndsWaitingAlsoIfItComesBefore) {
  LiveSockets sockets("127.0.0.1", 0);
  sockets.Wake();
  sockets.Wake();
  sockets.Wait(std::chrono::hours(1));
  auto waited = std::async(std::launch::async, [&] { sockets.Wait(std::chrono::hours(1)); });
  sockets.Wake();
  EXPECT_EQ(waited.wait_for(std::chrono::seconds(30)), std::future_status::ready);
}

class ConnectedSocketsTest : public ::testing::Test {
 protected:
  ConnectedSocketsTest() {
    client_.set(zmq::sockopt::linger, 0);
    client_.set(zmq::sockopt::rcvtimeo, 30000);
    client_.connect("tcp://127.0.0.1:" + std::to_string(sockets_.port()));
  }
  void Ask(const groot2::Parts& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      client_.send(zmq::buffer(parts[i]),
                   i + 1 < parts.size() ? zmq::send_flags::sndmore : zmq::send_flags::none);
    }
  }
  ReceivedRequest Receive() {
    ReceivedRequest request;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (!sockets_.Receive(request) && std::chrono::steady_clock::now() < deadline) {
      sockets_.Wait(std::chrono::milliseconds(100));
    }
    return request;
  }

  LiveSockets sockets_{"127.0.0.1", 0};
  zmq::context_t context_;
  zmq::socket_t client_{context_, zmq::socket_type::dealer};
};

TEST_F(ConnectedSocketsTest, AnswersTheClientThatAsked) {
  Ask({"", "hello", "there"});
  const ReceivedRequest request = Receive();
  EXPECT_THAT(request.parts, ::testing::ElementsAre("hello", "there"));
  EXPECT_TRUE(request.may_control);
  EXPECT_EQ(sockets_.Send(request.client, {"welcome"}), SendResult::kSent);
  zmq::message_t part;
  ASSERT_TRUE(client_.recv(part));
  EXPECT_EQ(part.size(), 0u);
  ASSERT_TRUE(client_.recv(part));
  EXPECT_EQ(part.to_string(), "welcome");
}

TEST_F(ConnectedSocketsTest, PassesOverWhatHasNoEnvelope) {
  Ask({"no", "envelope"});
  Ask({"alone"});
  Ask({"", "good"});
  EXPECT_THAT(Receive().parts, ::testing::ElementsAre("good"));
}

TEST_F(ConnectedSocketsTest, SaysWhenAClientDoesNotReadAndWhenItHasGone) {
  Ask({"", "x"});
  const std::string client = Receive().client;
  EXPECT_EQ(sockets_.Send("somebody", {"y"}), SendResult::kGone);
  const std::string large(1 << 16, 'z');
  SendResult result = SendResult::kSent;
  for (int i = 0; i < 10000 && result == SendResult::kSent; ++i) {
    result = sockets_.Send(client, {large});
  }
  EXPECT_EQ(result, SendResult::kFull);
  client_.close();
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (result != SendResult::kGone && std::chrono::steady_clock::now() < deadline) {
    sockets_.Wait(std::chrono::milliseconds(10));
    result = sockets_.Send(client, {"y"});
  }
  EXPECT_EQ(result, SendResult::kGone);
}

}  // namespace
}  // namespace coppice
