#include "bt_core/live/socket_pair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <stdexcept>

namespace coppice {
namespace {

using ::testing::HasSubstr;

std::string WhyNot(const std::string& address, std::uint16_t port) {
  try {
    const SocketPair sockets(address, port);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(SocketPair, TakesAFreePair) {
  const SocketPair first("127.0.0.1", 0);
  const SocketPair second("127.0.0.1", 0);
  EXPECT_GT(first.port(), 0);
  EXPECT_NE(first.port(), second.port());
}

TEST(SocketPair, SaysThatAPortIsInUseAndWhatToDo) {
  const SocketPair first("127.0.0.1", 0);
  const std::string port = std::to_string(first.port());
  EXPECT_EQ(WhyNot("127.0.0.1", first.port()),
            "live view: port 127.0.0.1:" + port +
                " is in use; end the program that has it or choose another port (each tree needs "
                "two neighbouring ones, for example 1669 and 1670)");
}

TEST(SocketPair, NeedsTheSecondPortToo) {
  const SocketPair first("127.0.0.1", 0);
  const std::string why = WhyNot("127.0.0.1", static_cast<std::uint16_t>(first.port() - 1));
  EXPECT_THAT(why, HasSubstr("127.0.0.1:"));
  EXPECT_THAT(why, HasSubstr("is in use"));
}

TEST(SocketPair, RefusesWhatIsNoAddress) {
  EXPECT_THAT(WhyNot("no such place", 1667), HasSubstr("cannot listen on no such place:1667"));
  EXPECT_THAT(WhyNot("127.0.0.1", 65535), HasSubstr("no neighbour"));
}

TEST(SocketPair, FreesThePortsWhenItEnds) {
  std::uint16_t port = 0;
  {
    const SocketPair sockets("127.0.0.1", 0);
    port = sockets.port();
  }
  EXPECT_EQ(WhyNot("127.0.0.1", port), "");
}

TEST(SocketPair, ShutdownEndsReceive) {
  SocketPair sockets("127.0.0.1", 0);
  auto received = std::async(std::launch::async, [&] {
    std::vector<std::string> parts;
    return sockets.Receive(parts);
  });
  sockets.Shutdown();
  ASSERT_EQ(received.wait_for(std::chrono::seconds(30)), std::future_status::ready);
  EXPECT_FALSE(received.get());
}

}  // namespace
}  // namespace coppice
