#include "robot_app/assistance/channels/http_request.h"

#include <gmock/gmock.h>

#include "tests/robot_app/assistance/local_server.h"

namespace coppice::robot::assistance {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;
namespace http = boost::beast::http;

class HttpRequestTest : public testing::Test {
 protected:
  Expected<std::string> Get(const std::string& url) const {
    HttpRequest request;
    request.method = "GET";
    request.url = url;
    return Exchange(request, never_);
  }
  const std::atomic<bool> never_{false};
};

TEST_F(HttpRequestTest, SendsItsBodyAsJsonWithTheToken) {
  HttpServer server([](const HttpServer::Request&) { return R"({"ok":true})"; });
  HttpRequest request;
  request.url = server.url() + "/path?a=1";
  request.body = R"({"text":"hello"})";
  request.bearer = "s3cret";
  const Expected<std::string> reply = Exchange(request, never_);
  ASSERT_TRUE(reply) << reply.problem();
  EXPECT_EQ(*reply, R"({"ok":true})");
  ASSERT_THAT(server.requests(), SizeIs(1));
  const HttpServer::Request got = server.requests()[0];
  EXPECT_EQ(got.method(), http::verb::post);
  EXPECT_EQ(got.target(), "/path?a=1");
  EXPECT_EQ(got.body(), request.body);
  EXPECT_EQ(got[http::field::content_type], "application/json");
  EXPECT_EQ(got[http::field::authorization], "Bearer s3cret");
}

TEST_F(HttpRequestTest, AGetHasNoBody) {
  HttpServer server;
  EXPECT_EQ(Get(server.url()).problem(), "");
  ASSERT_THAT(server.requests(), SizeIs(1));
  EXPECT_EQ(server.requests()[0].method(), http::verb::get);
  EXPECT_EQ(server.requests()[0].count(http::field::content_type), 0U);
  EXPECT_EQ(server.requests()[0].count(http::field::authorization), 0U);
}

TEST_F(HttpRequestTest, AnotherStatusIsAnErrorWithoutTheUrl) {
  HttpServer server(404);
  const std::string error = Get(server.url() + "/s3cret").problem();
  EXPECT_THAT(error, HasSubstr("404"));
  EXPECT_THAT(error, Not(HasSubstr("s3cret")));
}

TEST_F(HttpRequestTest, NobodyThereIsAnError) { EXPECT_FALSE(Get("http://127.0.0.1:1")); }

TEST_F(HttpRequestTest, OnlyHttpIsSpoken) { EXPECT_FALSE(Get("file:///etc/hostname")); }

TEST_F(HttpRequestTest, AReplyThatIsTooLongIsCutOffWithAnError) {
  HttpServer server(
      [](const HttpServer::Request&) { return std::string((std::size_t{1} << 20) + 1, 'x'); });
  EXPECT_EQ(Get(server.url()).problem(), "the answer is longer than 1048576 bytes");
}

TEST_F(HttpRequestTest, HeadersBehindTheBodyDoNotGoOnWithoutEnd) {
  LocalServer server([](LocalServer::Socket& socket) {
    boost::asio::streambuf request;
    boost::asio::read_until(socket, request, "\r\n\r\n");
    const std::string answer = "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n";
    boost::asio::write(socket, boost::asio::buffer(answer));
    const std::string header = "X: " + std::string(1000, 'x') + "\r\n";
    while (true) boost::asio::write(socket, boost::asio::buffer(header));
  });
  HttpRequest request;
  request.method = "GET";
  request.url = "http://127.0.0.1:" + server.port();
  request.timeout = std::chrono::seconds(60);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(Exchange(request, never_));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
}

TEST_F(HttpRequestTest, WhoHasCancelledDoesNotWait) {
  LocalServer silent([](LocalServer::Socket& socket) {
    boost::asio::streambuf buffer;
    boost::asio::read_until(socket, buffer, "never");
  });
  const std::atomic<bool> cancelled{true};
  HttpRequest request;
  request.url = "http://127.0.0.1:" + silent.port();
  EXPECT_FALSE(Exchange(request, cancelled));
}

TEST(UrlPart, KeepsLettersAndDigitsOnly) {
  EXPECT_EQ(UrlPart("!room:example.org"), "%21room%3Aexample.org");
  EXPECT_EQ(UrlPart("a b/c?d=\xc3\xa4~_-"), "a%20b%2Fc%3Fd%3D%C3%A4~_-");
  EXPECT_EQ(UrlPart(""), "");
}

}  // namespace
}  // namespace coppice::robot::assistance
