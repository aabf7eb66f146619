#include "robot_app/assistance/page/page_server.h"

#include <gmock/gmock.h>

#include <iterator>
#include <memory>
#include <random>
#include <vector>

#include "robot_app/assistance/page/page_http.h"
#include "tests/robot_app/assistance/page_caller.h"
#include "tests/robot_app/eventually.h"
#include "tests/support/folders.h"

namespace coppice::robot::assistance {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Server : public testing::Test {
 protected:
  PageEvent Next() {
    PageEvent event;
    EXPECT_TRUE(Eventually([&] { return server_.Receive(event); })) << "nothing has happened";
    return event;
  }

  std::string LogIn(const std::string& token) {
    PageCaller caller(server_.port());
    return caller.Post("/login", R"({"token": ")" + token + "\"}", caller.own_origin());
  }
  std::string Cookie() { return CookieOf(LogIn("an operator's token")); }

  static PageServerOptions Options() {
    PageServerOptions options;
    options.folder = SourceFolder() + "/robot_app/assistance/page/www";
    return options;
  }

  const WallClock clock_;
  PageAccess access_{"an operator's token", "a viewer's token"};
  PageServer server_{Options(), access_, clock_};
};

TEST_F(Server, ServesItsPageWithAStrictPolicyAndNothingElse) {
  const std::string page = PageCaller(server_.port()).Get("/");
  EXPECT_THAT(page, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(page, HasSubstr("Content-Security-Policy: default-src 'none'"));
  EXPECT_THAT(page, HasSubstr("text/html"));
  EXPECT_THAT(PageCaller(server_.port()).Get("/page.css"), HasSubstr("text/css"));
  EXPECT_THAT(PageCaller(server_.port()).Get("/map.js"), HasSubstr("text/javascript"));
  for (const char* const other : {"/../CMakeLists.txt", "/etc/passwd", "/.hidden", "//", "*"}) {
    EXPECT_THAT(PageCaller(server_.port()).Get(other), Not(HasSubstr(" 200 "))) << other;
  }
}

TEST_F(Server, ALogInGivesASessionThatOpensTheWebSocket) {
  const std::string answer = LogIn("an operator's token");
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 204"));
  EXPECT_THAT(answer, HasSubstr("HttpOnly; SameSite=Strict"));
  PageCaller caller(server_.port());
  EXPECT_THAT(caller.Upgrade(CookieOf(answer), caller.own_origin()), StartsWith("HTTP/1.1 101"));
  const PageEvent joined = Next();
  EXPECT_EQ(joined.kind, PageEvent::Kind::kJoined);
  EXPECT_EQ(joined.pass.role, PageRole::kOperator);
  caller.SendText("hello");
  EXPECT_EQ(Next().text, "hello");
  server_.Send(joined.client, "", std::make_shared<const std::string>("welcome"));
  EXPECT_EQ(caller.Read(), "welcome");
}

TEST_F(Server, AWrongTokenAForeignPageAndNoSessionAreRefused) {
  EXPECT_THAT(LogIn("guess"), StartsWith("HTTP/1.1 403"));
  const std::string cookie = Cookie();
  PageCaller foreign(server_.port());
  EXPECT_THAT(foreign.Post("/login", R"({"token": "an operator's token"})", "http://evil.example"),
              StartsWith("HTTP/1.1 403"));
  PageCaller other(server_.port());
  EXPECT_THAT(other.Upgrade(cookie, "http://evil.example"), StartsWith("HTTP/1.1 403"));
  PageCaller no_origin(server_.port());
  EXPECT_THAT(no_origin.Upgrade(cookie, ""), StartsWith("HTTP/1.1 403"));
  PageCaller stranger(server_.port());
  EXPECT_THAT(stranger.Upgrade("", stranger.own_origin()), StartsWith("HTTP/1.1 403"));
  PageCaller elsewhere(server_.port());
  EXPECT_THAT(elsewhere.Upgrade(cookie, elsewhere.own_origin(), "/other"),
              StartsWith("HTTP/1.1 403"));
}

TEST_F(Server, ALinkLogsInOnce) {
  const std::string token = access_.MakeLinkToken("Ada", 7, clock_.Now());
  EXPECT_THAT(LogIn(token), StartsWith("HTTP/1.1 204"));
  EXPECT_THAT(LogIn(token), StartsWith("HTTP/1.1 403"));
}

TEST_F(Server, WhoLogsOutHearsNothingMore) {
  const std::string cookie = Cookie();
  PageCaller caller(server_.port());
  caller.Upgrade(cookie, caller.own_origin());
  Next();
  PageCaller leaver(server_.port());
  EXPECT_THAT(leaver.Post("/logout", "", leaver.own_origin(), cookie), HasSubstr("Max-Age=0"));
  EXPECT_EQ(Next().kind, PageEvent::Kind::kLeft);
  EXPECT_EQ(caller.Read(), "");
}

TEST_F(Server, WhoseSessionIsOverHearsNothingMore) {
  const std::string cookie = Cookie();
  PageCaller caller(server_.port());
  caller.Upgrade(cookie, caller.own_origin());
  Next();
  access_.LogOut(SessionOf(cookie));  // by nobody whom the server has heard
  EXPECT_EQ(Next().kind, PageEvent::Kind::kLeft);
  EXPECT_EQ(caller.Read(), "");
}

TEST_F(Server, WrongTokensOfAllTheWorldLetARightOneIn) {
  for (std::size_t i = 0; i <= PageAccess::kMostFailures; ++i) {
    EXPECT_THAT(LogIn("guess"), StartsWith("HTTP/1.1 403"));
  }
  EXPECT_THAT(LogIn("guess"), HasSubstr("Too many"));
  EXPECT_THAT(LogIn("an operator's token"), StartsWith("HTTP/1.1 204"));
}

TEST_F(Server, WhoSendsTooMuchIsThrownOut) {
  PageCaller caller(server_.port());
  caller.Upgrade(Cookie(), caller.own_origin());
  Next();
  for (int i = 0; i < 3 * PageServer::kMostMessagesPerSecond; ++i) caller.SendText("x");
  PageEvent event = Next();
  int texts = 0;
  for (; event.kind == PageEvent::Kind::kText; event = Next()) ++texts;
  EXPECT_EQ(event.kind, PageEvent::Kind::kLeft);
  EXPECT_LT(texts, 2 * PageServer::kMostMessagesPerSecond);
}

TEST_F(Server, ABinaryMessageAndOneThatIsTooLongEndTheConnection) {
  const std::string frames[] = {
      std::string("\x82\x81\0\0\0\0x", 7), std::string("\x81\xfe\xff\xff\0\0\0\0", 8),
      std::string("\x81\xff\x7f\xff\xff\xff\xff\xff\xff\xff\0\0\0\0", 14)};
  std::vector<std::unique_ptr<PageCaller>> callers;
  for (std::size_t i = 0; i < std::size(frames); ++i) {
    callers.push_back(std::make_unique<PageCaller>(server_.port()));
    callers.back()->Upgrade(Cookie(), callers.back()->own_origin());
    EXPECT_EQ(Next().kind, PageEvent::Kind::kJoined);
  }
  for (std::size_t i = 0; i < std::size(frames); ++i) callers[i]->Say(frames[i]);
  for (std::size_t i = 0; i < std::size(frames); ++i) {
    EXPECT_EQ(Next().kind, PageEvent::Kind::kLeft);
  }
}

TEST_F(Server, NoBytesDoHarm) {
  std::mt19937 random(3);
  const std::string request =
      "POST /login HTTP/1.1\r\nHost: a\r\nOrigin: http://a\r\nContent-Length: 13\r\n\r\n"
      "{\"token\": \"x\"}";
  for (int i = 0; i < 300; ++i) {
    std::string text = request;
    for (unsigned edits = random() % 8; edits > 0; --edits) {
      text[random() % text.size()] = static_cast<char>(random());
    }
    PageCaller(server_.port()).Request(text.substr(0, random() % (text.size() + 1)));
  }
  EXPECT_THAT(PageCaller(server_.port()).Get("/"), StartsWith("HTTP/1.1 200"));
}

TEST_F(Server, NoFramesDoHarm) {
  std::mt19937 random(5);
  const std::string cookie = Cookie();
  for (int i = 0; i < 100; ++i) {
    PageCaller caller(server_.port());
    caller.Upgrade(cookie, caller.own_origin());
    std::string bytes(random() % 200, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    caller.Say(bytes);
    caller.Rest();
  }
  EXPECT_THAT(PageCaller(server_.port()).Get("/"), StartsWith("HTTP/1.1 200"));
}

TEST_F(Server, AHeaderOrBodyThatIsTooLongIsRefused) {
  EXPECT_THAT(PageCaller(server_.port()).Get("/" + std::string(20000, 'a')), Not(HasSubstr("200")));
  PageCaller caller(server_.port());
  EXPECT_THAT(caller.Post("/login", std::string(5000, ' '), caller.own_origin()),
              Not(HasSubstr(" 204 ")));
}

TEST_F(Server, APortThatIsTakenIsSaid) {
  PageServerOptions options = Options();
  options.port = server_.port();
  EXPECT_THROW(PageServer(options, access_, clock_), std::runtime_error);
}

}  // namespace
}  // namespace coppice::robot::assistance
