// A page of the robot, attacked by who can reach its port.
#include "robot_app/common/web/call_server.h"

#include <gmock/gmock.h>

#include <mutex>
#include <vector>

#include "tests/robot_app/assistance/page_caller.h"
#include "tests/support/folders.h"

namespace coppice::robot {
namespace {

using assistance::PageCaller;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class CallServerTest : public testing::Test {
 protected:
  std::string Call(const std::string& body) {
    PageCaller caller(server_.port());
    return caller.Post("/call", body, caller.own_origin());
  }
  std::vector<std::string> Calls() {
    const std::lock_guard lock(mutex_);
    return calls_;
  }

  std::mutex mutex_;
  std::vector<std::string> calls_;
  CallServer server_{{"127.0.0.1", 0, SourceFolder() + "/robot_app/questionnaire/www"},
                     [this](const std::string& call) {
                       const std::lock_guard lock(mutex_);
                       calls_.push_back(call);
                       return std::string("{}");
                     }};
};

TEST_F(CallServerTest, ServesItsPageWithAStrictPolicyAndNothingElse) {
  const std::string page = PageCaller(server_.port()).Get("/");
  EXPECT_THAT(page, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(page, HasSubstr("Content-Security-Policy: default-src 'none'"));
  EXPECT_THAT(page, HasSubstr("Cache-Control: no-store"));
  EXPECT_THAT(PageCaller(server_.port()).Get("/questionnaire.js"), HasSubstr("text/javascript"));
  for (const char* const other :
       {"/../godspeed.yaml", "/%2e%2e/godspeed.yaml", "/etc/passwd", "/.hidden", "//", "*", "/call",
        "/live", "/page.js", "/../../assistance/page/www/page.js"}) {
    EXPECT_THAT(PageCaller(server_.port()).Get(other), Not(HasSubstr(" 200 "))) << other;
  }
}

TEST_F(CallServerTest, HandsACallOfItsPageToTheDesk) {
  EXPECT_THAT(Call("{\"do\":\"state\"}"), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(Calls(), ElementsAre("{\"do\":\"state\"}"));
}

TEST_F(CallServerTest, AnotherPageCannotCall) {
  for (const char* const origin :
       {"http://evil.example", "", "null", "http://localhost", "http://localhost:1"}) {
    PageCaller caller(server_.port());
    EXPECT_THAT(caller.Post("/call", "{}", origin), StartsWith("HTTP/1.1 403")) << origin;
  }
  EXPECT_THAT(Calls(), IsEmpty());
}

// Whoever owns a name can let it mean the robot; a browser then takes his page for the robot's own.
TEST_F(CallServerTest, APageUnderANameOfTheWorldCannotCallUnlessItIsTheRobots) {
  const auto call = [](std::uint16_t port, const std::string& host) {
    return PageCaller(port).Request("POST /call HTTP/1.1\r\nHost: " + host + "\r\nOrigin: http://" +
                                    host + "\r\nContent-Length: 2\r\n\r\n{}");
  };
  const CallServer named(
      {"127.0.0.1", 0, SourceFolder() + "/robot_app/questionnaire/www", "sobi.institute.example"},
      [](const std::string&) { return "{}"; });
  for (const char* const host : {"evil.example:8091", "127.0.0.1.nip.example", ":8091", ""}) {
    EXPECT_THAT(call(server_.port(), host), StartsWith("HTTP/1.1 403")) << host;
    EXPECT_THAT(call(named.port(), host), StartsWith("HTTP/1.1 403")) << host;
  }
  EXPECT_THAT(call(named.port(), "sobi.institute.example:8091"), StartsWith("HTTP/1.1 200"));
  for (const char* const host : {"10.0.0.2:8091", "[::1]:8091", "sobi.local", "sobi"}) {
    EXPECT_THAT(call(server_.port(), host), StartsWith("HTTP/1.1 200")) << host;
  }
}

// What the supervisors' page and the live view answer to is not here.
TEST_F(CallServerTest, NoWayLeadsToTheSupervisorsPageOrToTheTrees) {
  for (const char* const target : {"/login", "/logout", "/live", "/", "/call/../login", "/setup"}) {
    PageCaller caller(server_.port());
    EXPECT_THAT(caller.Post(target, R"({"token":"x"})", caller.own_origin()),
                StartsWith("HTTP/1.1 404"))
        << target;
  }
  for (const char* const target : {"/live", "/call", "/"}) {
    PageCaller caller(server_.port());
    EXPECT_THAT(caller.Upgrade("", caller.own_origin(), target), StartsWith("HTTP/1.1 403"))
        << target;
  }
  EXPECT_THAT(Calls(), IsEmpty());
}

TEST_F(CallServerTest, WhoSendsTooMuchIsHungUpOn) {
  PageCaller caller(server_.port());
  const std::string answer =
      caller.Post("/call", std::string(CallServer::kMostBodyBytes + 1, 'a'), caller.own_origin());
  EXPECT_THAT(answer, Not(HasSubstr(" 200 ")));
  EXPECT_THAT(Calls(), IsEmpty());
}

TEST_F(CallServerTest, AFloodIsRefusedAndTheDeskIsSpared) {
  int refused = 0;
  for (int i = 0; i < 10 * CallServer::kMostCallsPerSecond && refused == 0; ++i) {
    refused += Call("{}").find(" 429 ") != std::string::npos;
  }
  EXPECT_EQ(refused, 1);
}

}  // namespace
}  // namespace coppice::robot
