#include "bt_core/live/web/web_gateway.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <condition_variable>
#include <future>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "bt_core/live/client/part_packing.h"
#include "tests/bt_core/live/web_caller.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr auto kPatience = std::chrono::seconds(30);

class WebGatewayTest : public ::testing::Test {
 protected:
  static WebGatewayOptions Options() {
    WebGatewayOptions options;
    options.address = "127.0.0.1";
    options.tokens = {"secret", "glance"};
    return options;
  }

  ReceivedRequest Receive() {
    ReceivedRequest request;
    std::unique_lock<std::mutex> lock(mutex_);
    EXPECT_TRUE(news_.wait_for(lock, kPatience, [&] { return clients_.Receive(request); }));
    return request;
  }

  std::mutex mutex_;
  std::condition_variable news_;
  LiveClients clients_{[this] {
    const std::lock_guard<std::mutex> lock(mutex_);
    news_.notify_all();
  }};
  WebGateway gateway_{Options(), clients_};
};

TEST_F(WebGatewayTest, CarriesMessagesBothWays) {
  WebCaller caller(gateway_.port());
  EXPECT_THAT(caller.Upgrade("secret"), StartsWith("HTTP/1.1 101"));
  caller.Send(PackParts({"header", "body"}));
  const ReceivedRequest request = Receive();
  EXPECT_THAT(request.parts, ElementsAre("header", "body"));
  EXPECT_TRUE(request.may_control);
  EXPECT_EQ(clients_.Send(request.client, {"answer", ""}), SendResult::kSent);
  EXPECT_THAT(UnpackParts(caller.Read()), ElementsAre("answer", ""));
}

TEST_F(WebGatewayTest, KnowsWhoMayOnlyWatchAndWhoMayNot) {
  WebCaller reader(gateway_.port());
  reader.Upgrade("glance");
  reader.Send(PackParts({"x"}));
  EXPECT_FALSE(Receive().may_control);
  EXPECT_THAT(WebCaller(gateway_.port()).Upgrade("guess"), StartsWith("HTTP/1.1 403"));
}

TEST_F(WebGatewayTest, TakesTheNextRequestWhenThisOneWasTaken) {
  WebCaller caller(gateway_.port());
  caller.Upgrade("secret");
  for (const char* text : {"1", "2", "3"}) caller.Send(PackParts({text}));
  EXPECT_THAT(Receive().parts, ElementsAre("1"));
  EXPECT_THAT(Receive().parts, ElementsAre("2"));
  EXPECT_THAT(Receive().parts, ElementsAre("3"));
}

TEST_F(WebGatewayTest, SaysByeForAClientThatHasGone) {
  ClientId client{};
  {
    WebCaller caller(gateway_.port());
    caller.Upgrade("secret");
    caller.Send(PackParts({"x"}));
    client = Receive().client;
  }
  const ReceivedRequest bye = Receive();
  EXPECT_EQ(bye.client, client);
  ASSERT_EQ(bye.parts.size(), 2u);
  EXPECT_THAT(bye.parts[1], HasSubstr("bye"));
  EXPECT_EQ(clients_.Send(client, {"y"}), SendResult::kGone);
}

TEST_F(WebGatewayTest, SaysWhenAClientDoesNotRead) {
  WebCaller caller(gateway_.port());
  caller.Upgrade("secret");
  caller.Send(PackParts({"x"}));
  const ClientId client = Receive().client;
  SendResult result = SendResult::kSent;
  const std::string large(1 << 20, 'z');
  for (int i = 0; i < 1000 && result == SendResult::kSent; ++i) {
    result = clients_.Send(client, {large});
  }
  EXPECT_EQ(result, SendResult::kFull);
}

TEST_F(WebGatewayTest, RefusesRequestsThatAreNone) {
  const std::string long_line(2 * WebGateway::kMaxHeaderBytes, 'a');
  EXPECT_THAT(WebCaller(gateway_.port()).Ask("GET /" + long_line + " HTTP/1.1\r\n\r\n"), "");
  EXPECT_THAT(WebCaller(gateway_.port()).Ask("POST / HTTP/1.1\r\nContent-Length: 0\r\n\r\n"),
              StartsWith("HTTP/1.1 405"));
  EXPECT_THAT(WebCaller(gateway_.port()).Ask("GET / HTTP/1.1\r\nContent-Length: 9\r\n\r\n"), "");
  EXPECT_THAT(WebCaller(gateway_.port()).Ask("hello\r\n\r\n"), "");
  EXPECT_THAT(WebCaller(gateway_.port()).Ask("GET / HTTP/1.1\r\n\r\n"), StartsWith("HTTP/1.1 404"));
}

TEST_F(WebGatewayTest, ClosesWhatSendsNoMessagesOfTheProtocol) {
  WebCaller caller(gateway_.port());
  caller.Upgrade("secret");
  caller.Send("no parts");
  EXPECT_EQ(caller.Read().substr(0, 2), "\x03\xEF") << "1007, RFC 6455 section 7.4.1";
}

TEST(WebGateway, SendsWhatIsLeftBeforeItEnds) {
  WebGatewayOptions options;
  options.address = "lo";
  std::promise<void> arrived;
  LiveClients clients([&] { arrived.set_value(); });
  auto gateway = std::make_unique<WebGateway>(options, clients);
  WebCaller caller(gateway->port());
  caller.Upgrade("");
  caller.Send(PackParts({"x"}));
  ASSERT_EQ(arrived.get_future().wait_for(kPatience), std::future_status::ready);
  ReceivedRequest request;
  ASSERT_TRUE(clients.Receive(request));
  clients.Send(request.client, {"the last"});
  gateway.reset();
  EXPECT_THAT(UnpackParts(caller.Read()), ElementsAre("the last"));
}

TEST(WebGateway, SaysThatAPortIsInUse) {
  WebGatewayOptions options;
  options.address = "127.0.0.1";
  LiveClients clients([] {});
  const WebGateway first(options, clients);
  options.port = first.port();
  try {
    const WebGateway second(options, clients);
    FAIL() << "two have one port";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("127.0.0.1:" + std::to_string(first.port())));
    EXPECT_THAT(error.what(), HasSubstr("in use"));
  }
}

}  // namespace
}  // namespace coppice
