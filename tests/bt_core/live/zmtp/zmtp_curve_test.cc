#include "bt_core/live/zmtp/zmtp_curve.h"

#include <gtest/gtest.h>

#include "tests/bt_core/live/live_client.h"
#include "tests/bt_core/live/zmtp/live_door.h"

namespace coppice {
namespace {

constexpr const char* kToken = "a token for tests";
constexpr auto kShort = std::chrono::milliseconds(300);  // in which strangers are not heard

// Against the CURVE of libzmq.
class CurveTest : public ::testing::Test {
 protected:
  std::optional<ReceivedRequest> Hear(const std::string& token,
                                      std::chrono::milliseconds patience = kShort) {
    SocketClient client(zmq::socket_type::dealer, door_.gateway.port(), token);
    client.Send({"", "hello"});
    return door_.Receive(patience);
  }

  const RobotKeys keys_ = KeysOfRobot(kToken);
  LiveDoor door_{keys_};
};

TEST_F(CurveTest, ServesTheOwnerWhoMayControl) {
  SocketClient owner(zmq::socket_type::dealer, door_.gateway.port(), kToken);
  owner.Send({"", "hello", std::string(1000, 'x')});
  const auto request = door_.Receive();
  ASSERT_TRUE(request);
  EXPECT_TRUE(request->may_control);
  EXPECT_EQ(request->parts.at(1), std::string(1000, 'x'));
  door_.clients.Reply(request->client, {"welcome", std::string(100000, 'y')});
  EXPECT_EQ(owner.Receive(), (Parts{"", "welcome", std::string(100000, 'y')}));
}

TEST_F(CurveTest, ServesAReaderWhoMayNotControl) {
  const auto request = Hear(keys_.read_token, std::chrono::seconds(30));
  ASSERT_TRUE(request);
  EXPECT_FALSE(request->may_control);
}

TEST_F(CurveTest, DoesNotHearWhoHasNoKey) { EXPECT_FALSE(Hear("")); }

TEST_F(CurveTest, DoesNotHearWhoHasAnotherToken) { EXPECT_FALSE(Hear("the token of others")); }

TEST_F(CurveTest, DoesNotHearWhoKnowsTheRobotButHasAKeyOfHisOwn) {
  std::string forged = "read-";
  for (int i = 0; i < 32; ++i) forged += '5';
  EXPECT_FALSE(Hear(forged + keys_.read_token.substr(forged.size())));
}

TEST_F(CurveTest, EncryptsNotificationsToo) {
  SocketClient listener(zmq::socket_type::sub, static_cast<std::uint16_t>(door_.gateway.port() + 1),
                        keys_.read_token);
  listener.set_patience(10);
  listener.Subscribe("note");
  Parts heard;
  for (int i = 0; i < 3000 && heard.empty(); ++i) {
    door_.clients.Publish({"other", "x"});
    door_.clients.Publish({"note1", "a"});
    heard = listener.Receive();
  }
  EXPECT_EQ(heard, (Parts{"note1", "a"}));
}

TEST(CurveConnection, TakesNothingThatWasSealedForOthers) {
  const RobotKeys keys = KeysOfRobot(kToken);
  zmtp::CurveConnection curve(keys);
  std::uint8_t flags = 0;
  EXPECT_FALSE(curve.Welcome(std::string(194, '\0')));
  EXPECT_FALSE(curve.Welcome("short"));
  std::string properties;
  EXPECT_FALSE(curve.Initiate(std::string(300, '\0'), properties));
  for (std::string message : {"\7MESSAGE" + std::string(40, '\0'), std::string()}) {
    EXPECT_FALSE(curve.Open(message, flags));
  }
}

}  // namespace
}  // namespace coppice
