#include "robot_app/assistance/channels/web_channels.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/robot_app/assistance/local_server.h"

namespace coppice::robot::assistance {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;
namespace http = boost::beast::http;

OutgoingMessage Message() {
  OutgoingMessage message;
  message.to = "!room:example.org";
  message.name = "Ada";
  message.headline = "Sobi needs help: navigation";
  message.text = "Blocked \"here\"\xff";
  message.link = "http://robot:8090/#abc";
  message.kind = "question";
  message.subject = "navigation";
  message.request = 7;
  message.id = "coppice-1";
  return message;
}

class WebChannels : public testing::Test {
 protected:
  std::string Send(ChannelConfig::Kind kind, const std::string& url,
                   const OutgoingMessage& message = Message()) {
    return MakeChannel({"test", kind, url, "", "s3cret", ""})->Send(message, cancelled_).problem();
  }
  const std::atomic<bool> cancelled_{false};
};

TEST_F(WebChannels, TelegramGetsChatAndText) {
  HttpServer server;
  EXPECT_EQ(Send(ChannelConfig::Kind::kTelegram, server.url()), "");
  ASSERT_THAT(server.requests(), SizeIs(1));
  const HttpServer::Request request = server.requests()[0];
  EXPECT_EQ(request.method(), http::verb::post);
  EXPECT_EQ(request.target(), "/bots3cret/sendMessage");
  EXPECT_EQ(request[http::field::content_type], "application/json");
  const json body = json::parse(request.body());
  EXPECT_EQ(body.at("chat_id"), "!room:example.org");
  EXPECT_EQ(body.at("text"),
            "Sobi needs help: navigation\nBlocked \"here\"\xef\xbf\xbd\nhttp://robot:8090/#abc");
}

TEST_F(WebChannels, AQuestionByTelegramHasAButtonForEachAnswer) {
  ChannelConfig config;
  const json body = json::parse(MakeTelegramRequest(config, Message()).body);
  const json& row = body.at("reply_markup").at("inline_keyboard").at(0);
  EXPECT_EQ(row.at(0).at("callback_data"), "fixed:7");
  EXPECT_EQ(row.at(1).at("callback_data"), "not_fixed:7");
  OutgoingMessage all_clear = Message();
  all_clear.kind = "all-clear";
  EXPECT_FALSE(json::parse(MakeTelegramRequest(config, all_clear).body).contains("reply_markup"));
  config.answers = false;
  EXPECT_FALSE(json::parse(MakeTelegramRequest(config, Message()).body).contains("reply_markup"));
}

TEST_F(WebChannels, MatrixGetsAMessageOfTheRoomWithItsTokenInTheHeader) {
  HttpServer server;
  EXPECT_EQ(Send(ChannelConfig::Kind::kMatrix, server.url()), "");
  ASSERT_THAT(server.requests(), SizeIs(1));
  const HttpServer::Request request = server.requests()[0];
  EXPECT_EQ(request.method(), http::verb::put);
  EXPECT_EQ(request.target(),
            "/_matrix/client/v3/rooms/%21room%3Aexample.org/send/m.room.message/coppice-1");
  EXPECT_EQ(request[http::field::authorization], "Bearer s3cret");
  const json body = json::parse(request.body());
  EXPECT_EQ(body.at("msgtype"), "m.text");
  EXPECT_THAT(body.at("body").get<std::string>(), HasSubstr("Blocked"));
}

TEST_F(WebChannels, AWebhookGetsEverything) {
  HttpServer server;
  EXPECT_EQ(Send(ChannelConfig::Kind::kWebhook, server.url() + "/help"), "");
  ASSERT_THAT(server.requests(), SizeIs(1));
  EXPECT_EQ(server.requests()[0].target(), "/help");
  const json body = json::parse(server.requests()[0].body());
  EXPECT_EQ(body.at("kind"), "question");
  EXPECT_EQ(body.at("request"), 7);
  EXPECT_EQ(body.at("link"), "http://robot:8090/#abc");
}

TEST_F(WebChannels, AnAddressCannotChangeTheRequest) {
  HttpServer server;
  OutgoingMessage message = Message();
  message.to = "x/../../y HTTP/1.1\r\nHost: evil\r\n\r\n";
  EXPECT_EQ(Send(ChannelConfig::Kind::kMatrix, server.url(), message), "");
  ASSERT_THAT(server.requests(), SizeIs(1));
  EXPECT_EQ(server.requests()[0].target().find(' '), boost::beast::string_view::npos);
  EXPECT_THAT(std::string(server.requests()[0][http::field::host]), HasSubstr("127.0.0.1"));
}

TEST_F(WebChannels, AnErrorIsToldWithoutTheSecret) {
  HttpServer server(403);
  const std::string error = Send(ChannelConfig::Kind::kTelegram, server.url());
  EXPECT_THAT(error, HasSubstr("403"));
  EXPECT_THAT(error, Not(HasSubstr("s3cret")));
  EXPECT_NE(Send(ChannelConfig::Kind::kTelegram, "http://127.0.0.1:1"), "");
}

}  // namespace
}  // namespace coppice::robot::assistance
