#include "robot_app/monitoring/system/time_server.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>

namespace coppice::robot::monitoring {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(TimeServer, AnswersAsAServerWithTheClientsTime) {
  NtpPacket request;
  request.transmit = 42;
  const NtpPacket answer = AnswerOf(request, 7, 8);
  EXPECT_EQ(answer.mode, NtpPacket::kServer);
  EXPECT_EQ(answer.origin, 42u);
  EXPECT_EQ(answer.receive, 7u);
  EXPECT_EQ(answer.transmit, 8u);
  EXPECT_NE(answer.stratum, 0);
}

TEST(TimeServer, APortThatIsTakenIsAnError) {
  const TimeServer first("127.0.0.1", 0, Duration::zero());
  ASSERT_EQ(first.error(), "");
  const TimeServer second("127.0.0.1", first.port(), Duration::zero());
  EXPECT_EQ(second.error(), "Address already in use");
}

// Two servers that took each other's answers for questions would never stop.
TEST(TimeServer, RubbishAndAnswersAreNotAnswered) {
  TimeServer server("127.0.0.1", 0, Duration::zero());
  const Socket client = Connect("127.0.0.1", server.port(), SOCK_DGRAM).value();
  NtpPacket answer;
  answer.mode = NtpPacket::kServer;
  const NtpPacket::Bytes bytes = answer.Encode();
  ASSERT_EQ(send(client.fd(), "rubbish", 7, 0), 7);
  ASSERT_EQ(send(client.fd(), bytes.data(), bytes.size(), 0), 48);
  NtpPacket question;
  question.transmit = 42;
  const NtpPacket::Bytes asked = question.Encode();
  ASSERT_EQ(send(client.fd(), asked.data(), asked.size(), 0), 48);
  pollfd waiting{client.fd(), POLLIN, 0};
  for (int i = 0; i < 1000 && poll(&waiting, 1, 0) == 0; ++i) server.Work(milliseconds(1));
  std::uint8_t data[64];
  ASSERT_EQ(recv(client.fd(), data, sizeof(data), 0), 48);  // the first thing that comes
  EXPECT_EQ(NtpPacket::Decode(data, sizeof(data))->origin, 42u);
  EXPECT_LT(recv(client.fd(), data, sizeof(data), 0), 0);  // and the only one
}

}  // namespace
}  // namespace coppice::robot::monitoring
