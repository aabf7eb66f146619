#include "robot_app/assistance/channels/mail_channel.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <boost/asio/read.hpp>

#include "tests/robot_app/assistance/local_server.h"

namespace coppice::robot::assistance {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Mail : public testing::Test {
 protected:
  static OutgoingMessage Message() {
    OutgoingMessage message;
    message.to = "ada@example.org";
    message.headline = "Sobi needs help: navigation";
    message.text = "The way is blocked.\n.\nA line that begins with a dot was above.";
    message.link = "http://robot:8090/#abc";
    message.id = "coppice-1";
    return message;
  }

  std::string Send(const OutgoingMessage& message, const std::string& url,
                   const std::string& user = {}) {
    ChannelConfig config;
    config.kind = ChannelConfig::Kind::kSmtp;
    config.url = url;
    config.user = user;
    config.secret = user.empty() ? "" : "password";
    config.from = "robot@example.org";
    return MailChannel(config).Send(message, cancelled_).problem();
  }

  std::atomic<bool> cancelled_{false};
};

TEST_F(Mail, GoesToItsAddressWithHeadlineTextAndLink) {
  SmtpServer server;
  EXPECT_EQ(Send(Message(), server.url()), "");
  const std::vector<std::string> lines = server.lines();
  EXPECT_THAT(lines, Contains(StartsWith("MAIL FROM:<robot@example.org>")));
  EXPECT_THAT(lines, Contains("RCPT TO:<ada@example.org>"));
  EXPECT_THAT(lines, Contains("From: <robot@example.org>"));
  EXPECT_THAT(lines, Contains("To: <ada@example.org>"));
  EXPECT_THAT(lines, Contains("Subject: Sobi needs help: navigation"));
  EXPECT_THAT(lines, Contains("Message-ID: <coppice-1@example.org>"));
  EXPECT_THAT(lines, Contains("The way is blocked."));
  EXPECT_THAT(lines, Contains("http://robot:8090/#abc"));
  EXPECT_EQ(lines.back(), "QUIT");
}

TEST_F(Mail, NoTextEndsTheMessageEarlyOrAddsAHeader) {
  SmtpServer server;
  OutgoingMessage message = Message();
  message.headline = "stuck\r\nBcc: thief@example.org\r\n\r\nbody";
  message.text = "one\r\n.\r\nMAIL FROM:<thief@example.org>";
  EXPECT_EQ(Send(message, server.url()), "");
  const std::vector<std::string> lines = server.lines();
  EXPECT_THAT(lines, Not(Contains(StartsWith("Bcc"))));
  EXPECT_EQ(std::count(lines.begin(), lines.end(), "."), 1);
  EXPECT_THAT(lines, Contains("Subject: stuck  Bcc: thief@example.org    body"));
}

TEST_F(Mail, AnAddressThatIsNoneIsRefusedBeforeAnythingIsSent) {
  SmtpServer server;
  OutgoingMessage message = Message();
  message.to = "ada@example.org>\r\nRCPT TO:<thief@example.org";
  EXPECT_THAT(Send(message, server.url()), HasSubstr("is no mail address"));
  EXPECT_TRUE(server.lines().empty());
}

TEST_F(Mail, TellsWhatTheServerRefuses) {
  SmtpServer server("RCPT");
  EXPECT_NE(Send(Message(), server.url()), "");
}

TEST_F(Mail, TellsThatNobodyListens) { EXPECT_NE(Send(Message(), "smtp://127.0.0.1:1"), ""); }

TEST_F(Mail, APasswordDoesNotGoToAnotherComputerInClear) {
  SmtpServer
      server;  // offers no encryption; reached by a name that is not known to be this computer
  std::string url = server.url();
  url.replace(url.find("127.0.0.1"), 9, "0.0.0.0");
  EXPECT_NE(Send(Message(), url, "robot"), "");
  EXPECT_THAT(server.text(), Not(HasSubstr("AUTH")));
}

TEST_F(Mail, ASilentServerDoesNotHoldUpTheEndOfTheProgram) {
  LocalServer silent([](LocalServer::Socket& socket) {
    char byte = 0;
    boost::asio::read(socket, boost::asio::buffer(&byte, 1));
  });
  cancelled_ = true;
  EXPECT_NE(Send(Message(), "smtp://127.0.0.1:" + silent.port()), "");
}

}  // namespace
}  // namespace coppice::robot::assistance
