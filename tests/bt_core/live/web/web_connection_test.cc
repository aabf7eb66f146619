#include "bt_core/live/web/web_connection.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/bt_core/live/file_connection.h"
#include "tests/bt_core/live/web_caller.h"

namespace coppice {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class WebConnectionTest : public testing::Test {
 protected:
  FilePort port_;
  WebCaller caller_{port_.port()};
};

TEST_F(WebConnectionTest, ServesTheFilesOfThePage) {
  EXPECT_THAT(caller_.Ask("GET / HTTP/1.1\r\n\r\n"),
              AllOf(StartsWith("HTTP/1.1 200"), HasSubstr("Content-Type: text/html"),
                    HasSubstr("X-Content-Type-Options: nosniff"), HasSubstr("X-Test: yes")));
  EXPECT_EQ(caller_.Rest(), "<p>hello</p>");
}

TEST_F(WebConnectionTest, SaysThatItIsCompressed) {
  port_.Write("index.html.gz", "packed");
  EXPECT_THAT(caller_.Ask("HEAD / HTTP/1.1\r\nAccept-Encoding: gzip, br\r\n\r\n"),
              AllOf(HasSubstr("Content-Encoding: gzip"), HasSubstr("Content-Type: text/html"),
                    HasSubstr("Content-Length: 6"), HasSubstr("Vary: Accept-Encoding")));
  EXPECT_THAT(caller_.Ask("GET / HTTP/1.1\r\n\r\n"),
              AllOf(Not(HasSubstr("Content-Encoding")), HasSubstr("Vary: Accept-Encoding")));
  EXPECT_EQ(caller_.Rest(), "<p>hello</p>");
}

TEST_F(WebConnectionTest, ToHeadOnlyTheHeaderIsSaid) {
  EXPECT_THAT(caller_.Ask("HEAD / HTTP/1.1\r\n\r\n"), HasSubstr("Content-Length: 12"));
  EXPECT_EQ(caller_.Rest(), "");
}

// Of this process [MB].
double MemoryInUse() {
  std::ifstream file("/proc/self/statm");
  double whole = 0, resident = 0;
  file >> whole >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

TEST_F(WebConnectionTest, AFileThatIsNotTakenCostsNoCopyOfIt) {
  port_.Write("large.data", "");
  std::filesystem::resize_file(port_.Path("large.data"), 100 << 20);
  const double before = MemoryInUse();
  EXPECT_THAT(caller_.Ask("GET /large.data HTTP/1.1\r\n\r\n"), HasSubstr("104857600"));
  EXPECT_LT(MemoryInUse() - before, 50);
}

TEST_F(WebConnectionTest, OneConnectionMayAskAgain) {
  EXPECT_THAT(caller_.Ask("HEAD / HTTP/1.1\r\n\r\n"), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(caller_.Ask("GET /none HTTP/1.1\r\n\r\n"), StartsWith("HTTP/1.1 404"));
  EXPECT_EQ(caller_.Rest(), "no such thing\n");
}

TEST_F(WebConnectionTest, OtherMethodsAreNotServed) {
  EXPECT_THAT(caller_.Ask("DELETE / HTTP/1.1\r\n\r\n"), StartsWith("HTTP/1.1 405"));
  EXPECT_THAT(WebCaller(port_.port()).Ask("POST / HTTP/1.1\r\nContent-Length: 2\r\n\r\nhi"),
              StartsWith("HTTP/1.1 405"));
}

TEST_F(WebConnectionTest, WhoSendsTooMuchIsHungUpOn) {
  EXPECT_EQ(caller_.Ask("GET / HTTP/1.1\r\nX: " + std::string(2 << 10, 'x') + "\r\n\r\n"), "");
  EXPECT_EQ(WebCaller(port_.port()).Ask("POST / HTTP/1.1\r\nContent-Length: 17\r\n\r\n"), "");
  EXPECT_EQ(WebCaller(port_.port()).Ask("no HTTP at all\r\n\r\n"), "");
}

TEST_F(WebConnectionTest, TheConnectionEndsWithARefusal) {
  EXPECT_THAT(caller_.Upgrade(""), StartsWith("HTTP/1.1 403"));
  EXPECT_THAT(caller_.Rest(), EndsWith("not here\n"));
}

}  // namespace
}  // namespace coppice
