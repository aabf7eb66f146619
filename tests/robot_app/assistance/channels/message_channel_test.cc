#include "robot_app/assistance/channels/message_channel.h"

#include <gtest/gtest.h>

#include "tests/robot_app/assistance/local_server.h"

namespace coppice::robot::assistance {
namespace {

class MessageChannelTest : public testing::Test {
 protected:
  std::string Send(ChannelConfig::Kind kind, const std::string& url = {}) {
    OutgoingMessage message;
    message.to = "ada@example.org";
    message.name = "Ada";
    message.headline = "Sobi needs help:\nnavigation";
    message.text = "I find no way.";
    message.link = "http://robot:8090/#abc";
    message.id = "coppice-1";
    return MakeChannel({"test", kind, url, "", "token", "sobi@example.org"})
        ->Send(message, never_cancelled_)
        .problem();
  }
  const std::atomic<bool> never_cancelled_{false};
};

TEST_F(MessageChannelTest, TheConsoleGetsTwoLines) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(Send(ChannelConfig::Kind::kConsole), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(),
            "\n*** Ada: Sobi needs help: navigation\n"
            "*** I find no way. http://robot:8090/#abc\n");
}

TEST_F(MessageChannelTest, EachKindSpeaksItsProtocol) {
  SmtpServer mail;
  EXPECT_EQ(Send(ChannelConfig::Kind::kSmtp, mail.url()), "");
  EXPECT_NE(mail.text().find("RCPT TO:<ada@example.org>"), std::string::npos) << mail.text();
  HttpServer web;
  EXPECT_EQ(Send(ChannelConfig::Kind::kTelegram, web.url()), "");
  EXPECT_EQ(Send(ChannelConfig::Kind::kMatrix, web.url()), "");
  EXPECT_EQ(Send(ChannelConfig::Kind::kWebhook, web.url()), "");
  const std::vector<HttpServer::Request> requests = web.requests();
  ASSERT_EQ(requests.size(), 3U);
  EXPECT_EQ(requests[0].target(), "/bottoken/sendMessage");
  EXPECT_EQ(requests[1].method(), boost::beast::http::verb::put) << "Matrix";
  EXPECT_EQ(requests[2].target(), "/");
}

}  // namespace
}  // namespace coppice::robot::assistance
