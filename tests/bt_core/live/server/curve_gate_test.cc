#include "bt_core/live/server/curve_gate.h"

#include <gtest/gtest.h>

#include "bt_core/live/server/live_sockets.h"
#include "tests/bt_core/live/live_client.h"

namespace coppice {
namespace {

constexpr const char* kToken = "a token for tests";

class CurveGateTest : public ::testing::Test {
 protected:
  // Serves until the client is heard, or for a while.
  std::optional<ReceivedRequest> Hear(SocketClient& client, int attempts) {
    client.Send({"", "hello"});
    ReceivedRequest request;
    for (int i = 0; i < attempts; ++i) {
      if (sockets_.Receive(request)) return request;
      sockets_.Wait(std::chrono::milliseconds(10));
    }
    return std::nullopt;
  }

  const RobotKeys keys_ = KeysOfRobot(kToken);
  LiveSockets sockets_{"127.0.0.1", 0, keys_};
};

TEST_F(CurveGateTest, TellsTheRolesApart) {
  SocketClient owner(zmq::socket_type::dealer, sockets_.port(), kToken);
  const auto from_owner = Hear(owner, 3000);
  ASSERT_TRUE(from_owner);
  EXPECT_TRUE(from_owner->may_control);
  SocketClient reader(zmq::socket_type::dealer, sockets_.port(), keys_.read_token);
  const auto from_reader = Hear(reader, 3000);
  ASSERT_TRUE(from_reader);
  EXPECT_FALSE(from_reader->may_control);
}

TEST_F(CurveGateTest, LetsNobodyElseIn) {
  SocketClient plain(zmq::socket_type::dealer, sockets_.port());
  EXPECT_FALSE(Hear(plain, 30));
  SocketClient stranger(zmq::socket_type::dealer, sockets_.port(), "the token of others");
  EXPECT_FALSE(Hear(stranger, 30));
  // Knows the robot, but has a key of its own.
  std::string forged = "read-";
  for (int i = 0; i < 32; ++i) forged += '5';
  forged += keys_.read_token.substr(forged.size());
  SocketClient forger(zmq::socket_type::dealer, sockets_.port(), forged);
  EXPECT_FALSE(Hear(forger, 30));
}

}  // namespace
}  // namespace coppice
