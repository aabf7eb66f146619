#include "bt_core/live/web/web_port.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "tests/bt_core/live/file_connection.h"
#include "tests/bt_core/live/web_caller.h"

namespace coppice {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kAsk = "HEAD /none HTTP/1.1\r\n\r\n";

// Has the claim that the first request names by its number.
class ClaimingConnection : public WebConnection {
 public:
  using WebConnection::WebConnection;
  Claim claim() const override { return claim_; }

 private:
  void OnUpgrade() override {}
  void OnPost() override {
    claim_ = static_cast<Claim>(std::stoi(request().body()));
    Reply(Status::no_content, "");
  }
  Claim claim_ = Claim::kStranger;
};

class ClaimTest : public testing::Test {
 protected:
  ~ClaimTest() override { port_.Stop(); }

  std::unique_ptr<WebCaller> Come(Claim claim) {
    auto caller = std::make_unique<WebCaller>(port_.port());
    const std::string number = std::to_string(static_cast<int>(claim));
    caller->Ask("POST / HTTP/1.1\r\nContent-Length: 1\r\n\r\n" + number);
    return caller;
  }
  static bool IsServed(WebCaller& caller) { return !caller.Ask(kAsk).empty(); }

  const WebFiles files_{"."};
  const WebConnectionOptions options_{1 << 10, 16, {}, "no such thing\n"};
  WebPort port_{{"127.0.0.1", 0, "claim_port", 4}, [this](WebPort::Socket socket, WebPort& port) {
                  return std::make_shared<ClaimingConnection>(std::move(socket), port, files_,
                                                              options_);
                }};
};

TEST_F(ClaimTest, OfStrangersOneOfTheMostCrowdedAddressGivesWay) {
  WebCaller alone(port_.port(), 2);
  EXPECT_TRUE(IsServed(alone));
  std::vector<std::unique_ptr<WebCaller>> crowd;
  for (int i = 0; i < 8; ++i) {
    crowd.push_back(std::make_unique<WebCaller>(port_.port(), 1));
    EXPECT_TRUE(IsServed(*crowd.back()));
  }
  EXPECT_TRUE(IsServed(alone)) << "though it was silent longest";
}

TEST_F(ClaimTest, WhoWatchesGivesWayOnlyBeyondHalfOfThePort) {
  std::vector<std::unique_ptr<WebCaller>> watching;
  for (int i = 0; i < 6; ++i) watching.push_back(Come(Claim::kWatches));
  const auto one = Come(Claim::kControls);
  const auto two = Come(Claim::kControls);
  EXPECT_EQ(Come(Claim::kControls)->Ask(kAsk), "");
  EXPECT_TRUE(IsServed(*watching[5]));
  EXPECT_TRUE(IsServed(*watching[4]));
  EXPECT_FALSE(IsServed(*watching[3]));
}

TEST_F(ClaimTest, WhoControlsAndIsSilentGivesNoWayToThoseWhoWatch) {
  std::vector<std::unique_ptr<WebCaller>> controlling;
  for (int i = 0; i < 2; ++i) controlling.push_back(Come(Claim::kIdleControls));
  std::vector<std::unique_ptr<WebCaller>> watching;
  for (int i = 0; i < 4; ++i) watching.push_back(Come(i < 2 ? Claim::kIdle : Claim::kWatches));
  EXPECT_EQ(Come(Claim::kWatches)->Ask(kAsk), "");
  for (const auto& one : controlling) EXPECT_TRUE(IsServed(*one));
}

TEST_F(ClaimTest, WhoControlsAndIsSilentGivesWayBeyondHalfOfThePort) {
  const auto watching = Come(Claim::kWatches);
  std::vector<std::unique_ptr<WebCaller>> controlling;
  for (int i = 0; i < 4; ++i) controlling.push_back(Come(Claim::kIdleControls));
  EXPECT_FALSE(IsServed(*controlling[0]));
  EXPECT_TRUE(IsServed(*controlling[1]));
  EXPECT_TRUE(IsServed(*watching));
}

TEST(WebPortTest, TakesAFreePortAndServesOnIt) {
  FilePort port;
  EXPECT_NE(port.port(), 0);
  EXPECT_THAT(WebCaller(port.port()).Ask(kAsk), StartsWith("HTTP/1.1 404"));
}

TEST(WebPortTest, SaysWhyAPortCannotBeHad) {
  FilePort port;
  try {
    FilePort second("127.0.0.1", port.port());
    FAIL() << "two ports in one";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("in use"));
  }
  EXPECT_THROW(FilePort("192.0.2.1", 0), std::runtime_error);
}

TEST(WebPortTest, WhoWasSilentLongestGivesWayWhenThereAreTooMany) {
  FilePort port("127.0.0.1", 0, 2);
  WebCaller first(port.port());
  WebCaller second(port.port());
  EXPECT_THAT(first.Ask(kAsk), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(second.Ask(kAsk), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(first.Ask(kAsk), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(WebCaller(port.port()).Ask(kAsk), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(first.Ask(kAsk), StartsWith("HTTP/1.1 404"));
  EXPECT_EQ(second.Ask(kAsk), "");
}

TEST(WebPortTest, WhoHasStoppedServesNobodyAndHoldsNobody) {
  FilePort port;
  WebCaller waiting(port.port());
  EXPECT_THAT(waiting.Ask(kAsk), StartsWith("HTTP/1.1 404"));
  port.Stop();
  EXPECT_EQ(waiting.Ask(kAsk), "");
  EXPECT_THROW(WebCaller(port.port()), std::runtime_error);
  port.Stop();
}

}  // namespace
}  // namespace coppice
