#include "bt_core/live/client/client_socket.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>
#include <zmq.hpp>

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

  // What has come to an end of libzmq; the client has no thread, so it must wait meanwhile.
  static std::string Hear(zmq::socket_t& end, ClientSocket& socket) {
    zmq::message_t part;
    while (!end.recv(part, zmq::recv_flags::dontwait)) socket.Wait(1ms);
    return part.to_string();
  }

  zmq::context_t context_;
  zmq::socket_t robot_;
  std::string address_;
  ClientBell bell_;
};

TEST_F(ClientSocketTest, AsksAndIsAnswered) {
  ClientSocket socket(bell_, address_, nullptr);
  socket.Send({"question", "more"});
  EXPECT_EQ(Hear(robot_, socket), "question");
  EXPECT_EQ(Hear(robot_, socket), "more");
  robot_.send(zmq::str_buffer("answer"), zmq::send_flags::none);
  ASSERT_EQ(socket.Wait(30s), Event::kMessage);
  EXPECT_THAT(socket.Receive(), ElementsAre("answer"));
  EXPECT_THAT(socket.Receive(), IsEmpty());
}

TEST_F(ClientSocketTest, IsWokenByItsBell) {
  ClientSocket socket(bell_, address_, nullptr);
  std::thread ringer([&] { bell_.Ring(); });
  EXPECT_EQ(socket.Wait(30s), Event::kBell);
  ringer.join();
  EXPECT_EQ(socket.Wait(1ms), Event::kTimeout);
}

TEST_F(ClientSocketTest, TellsThatTheRobotIsGone) {
  ClientSocket socket(bell_, address_, nullptr);
  socket.Send({"question"});
  EXPECT_EQ(Hear(robot_, socket), "question");
  robot_.send(zmq::str_buffer("answer"), zmq::send_flags::none);
  ASSERT_EQ(socket.Wait(30s), Event::kMessage);
  socket.Receive();
  robot_.close();
  EXPECT_EQ(socket.Wait(30s), Event::kGone);
  EXPECT_EQ(socket.problem(), "the connection is closed");
}

TEST_F(ClientSocketTest, SuspectsTheTokenIfTheRobotIsGoneBeforeItSaidAnything) {
  ClientSocket socket(bell_, address_, nullptr);
  socket.Send({"question"});
  EXPECT_EQ(Hear(robot_, socket), "question");
  robot_.close();
  EXPECT_EQ(socket.Wait(30s), Event::kGone);
  EXPECT_THAT(socket.problem(), ::testing::HasSubstr("COPPICE_LIVE_TOKEN"));
}

TEST_F(ClientSocketTest, HearsWhatIsPublished) {
  zmq::socket_t publisher(context_, zmq::socket_type::xpub);
  publisher.bind("tcp://127.0.0.1:*");
  ClientSocket socket(bell_, address_, nullptr);
  socket.Listen(publisher.get(zmq::sockopt::last_endpoint));
  EXPECT_EQ(Hear(publisher, socket), "\1");
  publisher.send(zmq::str_buffer("news"), zmq::send_flags::none);
  ASSERT_EQ(socket.Wait(30s), Event::kMessage);
  EXPECT_THAT(socket.Receive(), ElementsAre("news"));
}

TEST_F(ClientSocketTest, SpeaksTheEncryptionOfLibzmq) {
  const RobotKeys keys = KeysOfRobot("a token for tests");
  const WatcherKeys watcher = KeysOfWatcher("a token for tests");
  zmq::socket_t robot(context_, zmq::socket_type::rep);
  robot.set(zmq::sockopt::linger, 0);
  robot.set(zmq::sockopt::curve_server, true);
  robot.set(zmq::sockopt::curve_secretkey, keys.robot.secret_key);
  robot.bind("tcp://127.0.0.1:*");
  ClientSocket socket(bell_, robot.get(zmq::sockopt::last_endpoint), &watcher);
  socket.Send({std::string(1000, 'x')});
  EXPECT_EQ(Hear(robot, socket), std::string(1000, 'x'));
  robot.send(zmq::str_buffer("answer"), zmq::send_flags::none);
  ASSERT_EQ(socket.Wait(30s), Event::kMessage);
  EXPECT_THAT(socket.Receive(), ElementsAre("answer"));
}

TEST_F(ClientSocketTest, FindsARobotByItsName) {
  ClientSocket socket(bell_, "tcp://localhost" + address_.substr(address_.rfind(':')), nullptr);
  socket.Send({"question"});
  EXPECT_EQ(Hear(robot_, socket), "question");
}

TEST_F(ClientSocketTest, HangsUpOnAMessageThatIsTooLarge) {
  zmq::socket_t robot(context_, zmq::socket_type::dealer);
  robot.set(zmq::sockopt::linger, 0);
  robot.bind("tcp://127.0.0.1:*");
  ClientSocket socket(bell_, robot.get(zmq::sockopt::last_endpoint), nullptr);
  socket.Send({"question"});
  EXPECT_EQ(Hear(robot, socket), "");
  for (int i = 0; i < 9; ++i) robot.send(zmq::str_buffer("part"), zmq::send_flags::sndmore);
  robot.send(zmq::str_buffer("end"), zmq::send_flags::none);
  EXPECT_EQ(socket.Wait(30s), Event::kGone);
  EXPECT_THAT(socket.problem(), ::testing::HasSubstr("too large"));
}

TEST(ClientSocket, KnowsTheAddressesOfARobot) {
  EXPECT_EQ(AddressOf("robot"), "tcp://robot:1667");
  EXPECT_EQ(AddressOf("10.0.0.1:1669"), "tcp://10.0.0.1:1669");
  EXPECT_EQ(NotificationsOf(AddressOf("robot")), "tcp://robot:1668");
  EXPECT_THROW(AddressOf("robot:x"), std::invalid_argument);
}

}  // namespace
}  // namespace coppice
