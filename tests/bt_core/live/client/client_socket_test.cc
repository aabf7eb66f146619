#include "bt_core/live/client/client_socket.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using Event = ClientSocket::Event;

class ClientSocketTest : public ::testing::Test {
 protected:
  ClientSocketTest() : robot_(context_, zmq::socket_type::rep) {
    robot_.set(zmq::sockopt::linger, 0);
    robot_.bind("tcp://127.0.0.1:*");
    address_ = robot_.get(zmq::sockopt::last_endpoint);
  }

  zmq::context_t context_;
  zmq::socket_t robot_;
  std::string address_;
  ClientBell bell_{context_};
};

TEST_F(ClientSocketTest, AsksAndIsAnswered) {
  ClientSocket socket(context_, bell_, address_, nullptr);
  socket.Send({"question", "more"});
  zmq::message_t part;
  ASSERT_TRUE(robot_.recv(part));
  EXPECT_EQ(part.to_string(), "question");
  EXPECT_TRUE(part.more());
  ASSERT_TRUE(robot_.recv(part));
  robot_.send(zmq::str_buffer("answer"), zmq::send_flags::none);
  ASSERT_EQ(socket.Wait(30s), Event::kMessage);
  EXPECT_THAT(socket.Receive(), ElementsAre("answer"));
  EXPECT_THAT(socket.Receive(), IsEmpty());
}

TEST_F(ClientSocketTest, IsWokenByItsBell) {
  ClientSocket socket(context_, bell_, address_, nullptr);
  std::thread ringer([&] { bell_.Ring(); });
  EXPECT_EQ(socket.Wait(30s), Event::kBell);
  ringer.join();
  EXPECT_EQ(socket.Wait(1ms), Event::kTimeout);
}

TEST_F(ClientSocketTest, TellsThatTheRobotIsGone) {
  ClientSocket socket(context_, bell_, address_, nullptr);
  socket.Send({"question"});
  zmq::message_t part;
  ASSERT_TRUE(robot_.recv(part));
  robot_.send(zmq::str_buffer("answer"), zmq::send_flags::none);
  ASSERT_EQ(socket.Wait(30s), Event::kMessage);
  socket.Receive();
  robot_.close();
  EXPECT_EQ(socket.Wait(30s), Event::kGone);
  EXPECT_EQ(socket.problem(), "the connection is closed");
}

TEST_F(ClientSocketTest, SuspectsTheTokenIfTheRobotIsGoneBeforeItSaidAnything) {
  ClientSocket socket(context_, bell_, address_, nullptr);
  socket.Send({"question"});
  zmq::message_t part;
  ASSERT_TRUE(robot_.recv(part));
  robot_.close();
  EXPECT_EQ(socket.Wait(30s), Event::kGone);
  EXPECT_THAT(socket.problem(), ::testing::HasSubstr("COPPICE_LIVE_TOKEN"));
}

TEST_F(ClientSocketTest, HearsWhatIsPublished) {
  zmq::socket_t publisher(context_, zmq::socket_type::xpub);
  publisher.bind("tcp://127.0.0.1:*");
  ClientSocket socket(context_, bell_, address_, nullptr);
  socket.Listen(publisher.get(zmq::sockopt::last_endpoint));
  zmq::message_t subscription;
  ASSERT_TRUE(publisher.recv(subscription));
  publisher.send(zmq::str_buffer("news"), zmq::send_flags::none);
  ASSERT_EQ(socket.Wait(30s), Event::kMessage);
  EXPECT_THAT(socket.Receive(), ElementsAre("news"));
}

TEST(ClientSocket, KnowsTheAddressesOfARobot) {
  EXPECT_EQ(AddressOf("robot"), "tcp://robot:1667");
  EXPECT_EQ(AddressOf("10.0.0.1:1669"), "tcp://10.0.0.1:1669");
  EXPECT_EQ(NotificationsOf(AddressOf("robot")), "tcp://robot:1668");
  EXPECT_THROW(AddressOf("robot:x"), std::invalid_argument);
}

}  // namespace
}  // namespace coppice
