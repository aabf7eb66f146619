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
